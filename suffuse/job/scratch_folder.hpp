#pragma once
// A folder for what another program is to work on, gone at the end.

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace suffuse::job {

class ScratchFolder {
public:
    ScratchFolder() {
        const std::filesystem::path within = std::filesystem::temp_directory_path();
        std::string name = (within / "suffuse-figures-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) {
            throw IoError(fmt::format("cannot make a folder in {}", within.string()));
        }
        path_ = name;
    }

    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace suffuse::job
