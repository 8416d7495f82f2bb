#pragma once
// A folder of its own for each test, gone when the test ends.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>

namespace suffuse::test {

class TempFolder {
public:
    TempFolder() {
        const std::filesystem::path memory = "/dev/shm"; // where there is one: files are synced, and disks are slow
        const bool writable = ::access(memory.c_str(), W_OK) == 0;
        std::string name = ((writable ? memory : std::filesystem::temp_directory_path()) / "suffuse-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) {
            ADD_FAILURE() << "cannot make " << name;
        }
        path_ = name;
    }

    ~TempFolder() {
        std::error_code ignored; // a test that removed it itself is fine
        std::filesystem::remove_all(path_, ignored);
    }

    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// Number of files and folders in it.
    [[nodiscard]] std::ptrdiff_t entries() const {
        return std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator());
    }

private:
    std::filesystem::path path_;
};

inline std::string read_all(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

} // namespace suffuse::test
