#include "suffuse/io/own_file.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace suffuse::io {
namespace {

namespace fs = std::filesystem;

/// Why a file is not written to; empty where it may be.
std::string fault_of(int descriptor) {
    struct stat status {};

    if (::fstat(descriptor, &status) != 0) {
        return std::generic_category().message(errno);
    }
    if (!S_ISREG(status.st_mode)) {
        return "is no regular file; remove it and call again";
    }
    if (status.st_uid != ::geteuid()) {
        return "belongs to another user; copy the run and continue with the copy";
    }
    if (status.st_nlink != 1) {
        return "has another name elsewhere (a hard link), where it would be changed, too; replace it by a copy";
    }
    return {};
}

int open_to_append(const fs::path& path) {
    constexpr int everybody_may_read = 0644;
    constexpr int flags = O_WRONLY | O_APPEND | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
    const int descriptor = ::open(path.c_str(), flags, everybody_may_read);
    if (descriptor < 0) {
        const int error = errno;
        throw IoError(
            error == ELOOP
                ? fmt::format("{} is a link, which is not written through; remove it and call again", path.string())
                : fmt::format("{}: cannot be written: {}", path.string(), std::generic_category().message(error))
        );
    }
    if (const std::string fault = fault_of(descriptor); !fault.empty()) {
        ::close(descriptor);
        throw IoError(fmt::format("{} {}", path.string(), fault));
    }
    return descriptor;
}

} // namespace

void append_to(const fs::path& path, std::string_view text) {
    const int descriptor = open_to_append(path);
    int error = 0;
    while (!text.empty() && error == 0) {
        const ssize_t written = ::write(descriptor, text.data(), text.size());
        if (written >= 0) {
            text.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno != EINTR) {
            error = errno;
        }
    }
    ::close(descriptor);
    if (error != 0) {
        throw IoError(fmt::format(
            "{}: cannot be written: {}; is the disk full?", path.string(), std::generic_category().message(error)
        ));
    }
}

void require_regular(const fs::path& path) {
    std::error_code none;
    const fs::file_status there = fs::status(path, none);
    if (fs::is_other(there)) {
        throw IoError(fmt::format(
            "{} is a {}, which is no file of a run; remove it and call again", path.string(),
            fs::is_fifo(there)     ? "pipe (FIFO)"
            : fs::is_socket(there) ? "socket"
                                   : "device"
        ));
    }
}

} // namespace suffuse::io
