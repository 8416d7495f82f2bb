#include "suffuse/base/resident.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <fstream>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace suffuse {
namespace {

/// A line `NAME: 1234 kB` of the process's status [proc(5)], in bytes.
std::int64_t status_bytes(const std::string& name) {
    constexpr std::int64_t kilobyte = 1024;
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        if (std::int64_t kilobytes = 0; word == name + ":" && status >> kilobytes) {
            return kilobyte * kilobytes;
        }
    }
    throw Error(fmt::format("/proc/self/status has no {}: this system does not report how much memory is in use", name)
    );
}

} // namespace

std::int64_t resident_bytes() {
    return status_bytes("VmRSS");
}

std::int64_t peak_resident_bytes() {
    return status_bytes("VmHWM");
}

void trim_heap() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

void forget_peak() {
    std::ofstream("/proc/self/clear_refs") << "5";
}

} // namespace suffuse
