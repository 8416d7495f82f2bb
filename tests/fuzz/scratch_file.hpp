#pragma once
// A file in memory that a reader can open by its name, written anew for every input.

#include <cstdint>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <unistd.h>

namespace suffuse::fuzz {

/// @return the path of a file that holds these bytes; it belongs to this process.
inline std::string scratch_file(const std::uint8_t* bytes, std::size_t size) {
    static const std::string path = "/dev/shm/suffuse-fuzz-" + std::to_string(getpid());
    static const bool is_registered = std::atexit([] { unlink(path.c_str()); }) == 0;
    const int file = open(path.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
    if (!is_registered || file < 0 || write(file, bytes, size) != static_cast<ssize_t>(size)) {
        std::abort();
    }
    close(file);
    return path;
}

} // namespace suffuse::fuzz
