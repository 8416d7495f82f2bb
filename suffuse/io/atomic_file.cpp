#include "suffuse/io/atomic_file.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
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
    case EFBIG:
        return "free some space there, or write to another folder";
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

/// The new name itself must reach the disk too. Some file systems refuse to sync a folder; the file is safe all the
/// same.
void sync_folder(const std::filesystem::path& file) {
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) {
        return;
    }
    ::fsync(descriptor);
    ::close(descriptor);
}

} // namespace

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)), partial_(path_) {
    partial_ += ".partial";
    constexpr int everybody_may_read = 0644;
    descriptor_ = ::open(partial_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, everybody_may_read);
    if (descriptor_ < 0) {
        fail(errno);
    }
    buffer_.reserve(buffer_size);
}

AtomicFile::~AtomicFile() {
    if (descriptor_ < 0) {
        return;
    }
    ::close(descriptor_);
    ::unlink(partial_.c_str());
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

void AtomicFile::commit() {
    flush();
    if (::fsync(descriptor_) != 0) {
        fail(errno);
    }
    if (::close(std::exchange(descriptor_, -1)) != 0 || std::rename(partial_.c_str(), path_.c_str()) != 0) {
        const int error = errno;
        ::unlink(partial_.c_str());
        fail(error);
    }
    sync_folder(path_);
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

} // namespace suffuse::io
