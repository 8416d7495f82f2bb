#include "suffuse/io/folders.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <system_error>
#include <unistd.h>

namespace suffuse::io {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void complain(const fs::path& folder, const std::error_code& error) {
    throw IoError(fmt::format("{}: cannot be made: {}", folder.string(), error.message()));
}

} // namespace

void make_folders(const fs::path& folder) {
    std::error_code error;
    if (folder.empty() || fs::is_directory(folder, error)) {
        return;
    }
    const fs::path plain = folder.has_filename() ? folder : folder.parent_path();
    make_folders(plain.parent_path());
    if (!make_folder(plain) && !fs::is_directory(plain, error)) {
        complain(folder, std::make_error_code(std::errc::not_a_directory));
    }
}

bool make_folder(const fs::path& folder) {
    std::error_code error;
    const bool is_new = fs::create_directory(folder, error);
    if (error && error != std::errc::file_exists) {
        complain(folder, error);
    }
    if (is_new) {
        sync_folder_of(folder);
    }
    return is_new;
}

void remove_file(const fs::path& file) {
    if (fs::remove(file)) {
        sync_folder_of(file);
    }
}

void sync_folder_of(const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) {
        return;
    }
    ::fsync(descriptor);
    ::close(descriptor);
}

} // namespace suffuse::io
