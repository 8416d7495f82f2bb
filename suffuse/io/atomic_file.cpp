#include "suffuse/io/atomic_file.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/folders.hpp"
#include "suffuse/io/leftovers.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace suffuse::io {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 18;

std::string advice(int error) {
    switch (error) {
    case ENOSPC:
    case EDQUOT:
        return "free some space there, or write to another folder";
    case EFBIG:
        return "raise the limit on the size of files (ulimit -f), or write to a disk that takes larger ones";
    case EACCES:
    case EPERM:
    case EROFS:
        return "choose a folder that you may write to";
    case ENOENT:
    case ENOTDIR:
        return "create the folder first, or correct its name";
    default:
        return "check the disk, or write to another folder";
    }
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : ".";
}

int lock(int descriptor, int kind) {
    while (::flock(descriptor, kind) != 0) {
        if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

/// A new file, held for as long as its writer lives; -1 and errno where there is none, EEXIST where the name is taken.
int open_held(const std::filesystem::path& partial) {
    constexpr int everybody_may_read = 0644;
    const int descriptor = ::open(partial.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, everybody_may_read);
    if (descriptor < 0) {
        return -1;
    }
    lock(descriptor, LOCK_SH);                  // where there are no locks, leftovers stay
    if (::access(partial.c_str(), F_OK) != 0) { // taken for a leftover before it was held
        ::close(descriptor);
        errno = EEXIST;
        return -1;
    }
    return descriptor;
}

} // namespace

bool is_partial(std::string_view name) {
    const std::size_t at = name.rfind(partial_suffix);
    return at != std::string_view::npos &&
           name.find_first_not_of("0123456789-", at + partial_suffix.size()) == std::string_view::npos;
}

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)) {
    buffer_.reserve(buffer_size);
    std::error_code error;
    const std::filesystem::file_status there = std::filesystem::status(path_, error);
    if (std::filesystem::exists(there) && std::filesystem::is_other(there)) {
        descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor_ < 0) {
            fail(errno);
        }
        return;
    }
    const std::string own_name = path_.filename().string();
    remove_leftovers(folder_of(path_), [&](std::string_view name) { return name == own_name; });
    do {
        partial_ = next_partial(path_);
        descriptor_ = open_held(partial_);
    } while (descriptor_ < 0 && errno == EEXIST);
    if (descriptor_ < 0) {
        fail(errno);
    }
}

AtomicFile::~AtomicFile() {
    if (descriptor_ < 0) {
        return;
    }
    if (!partial_.empty()) {
        ::unlink(partial_.c_str());
    }
    ::close(descriptor_);
}

void AtomicFile::write(std::string_view bytes) {
    if (buffer_.size() + bytes.size() > buffer_size) {
        flush();
    }
    if (bytes.size() > buffer_size) {
        write_out(bytes);
    } else {
        buffer_.append(bytes);
    }
}

void AtomicFile::finish(bool to_disk) {
    flush();
    if (partial_.empty()) {
        ::close(std::exchange(descriptor_, -1));
        return;
    }
    if (to_disk && ::fsync(descriptor_) != 0) {
        fail(errno);
    }
    if (std::rename(partial_.c_str(), path_.c_str()) != 0) {
        fail(errno);
    }
    ::close(std::exchange(descriptor_, -1)); // only now: let go before, it would pass for a leftover
    if (to_disk) {
        sync_folder_of(path_);
    }
}

void AtomicFile::flush() {
    write_out(buffer_);
    buffer_.clear();
}

void AtomicFile::write_out(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0) {
            if (errno == EINTR) {
                continue;
            }
            fail(errno);
        }
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

void AtomicFile::fail(int error) const {
    throw IoError(fmt::format(
        "cannot write {}: {}; {}; nothing half-written was left", path_.string(),
        std::generic_category().message(error), advice(error)
    ));
}

void sync_file(const std::filesystem::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const bool is_synced = descriptor >= 0 && ::fsync(descriptor) == 0;
    const int error = errno;
    if (descriptor >= 0) {
        ::close(descriptor);
    }
    if (!is_synced) {
        throw IoError(
            fmt::format("cannot write {}: {}; {}", path.string(), std::generic_category().message(error), advice(error))
        );
    }
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
    AtomicFile file(path);
    file.write(bytes);
    file.commit();
}

bool show_file(const std::filesystem::path& path, std::string_view bytes) {
    try {
        AtomicFile file(path);
        file.write(bytes);
        file.show();
        return true;
    } catch (const IoError&) {
        return false;
    }
}

} // namespace suffuse::io
