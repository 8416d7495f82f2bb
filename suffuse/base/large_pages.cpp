#include "suffuse/base/large_pages.hpp"

#include <cstdint>
#include <sys/mman.h>
#include <unistd.h>

namespace suffuse {

void advise_large_pages(void* begin, std::size_t bytes) {
    constexpr std::size_t much = std::size_t{1} << 21;
    if (bytes < much) {
        return;
    }
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    const std::uintptr_t first = (reinterpret_cast<std::uintptr_t>(begin) + page - 1) / page * page;
    const std::uintptr_t last = (reinterpret_cast<std::uintptr_t>(begin) + bytes) / page * page;
    // What it says does not matter: a system without large pages goes on with small ones.
    static_cast<void>(madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE));
}

} // namespace suffuse
