#include "suffuse/base/memory_bound.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace suffuse {
namespace {

namespace fs = std::filesystem;

constexpr double no_bound = std::numeric_limits<double>::infinity();

/// A number in a file; no bound where there is none ("max").
double number_in(const fs::path& file) {
    std::ifstream stream(file);
    double bytes = 0;
    return stream >> bytes ? bytes : no_bound;
}

/// The least limit of a group and of those that it is part of. A container sees its own group as the root.
double least_above(fs::path group, const fs::path& root, const char* file) {
    double least = number_in(root / file);
    for (group = group.relative_path(); !group.empty(); group = group.parent_path()) {
        least = std::min(least, number_in(root / group / file));
    }
    return least;
}

double of_limit(rlim_t limit) {
    return limit == RLIM_INFINITY ? no_bound : static_cast<double>(limit);
}

} // namespace

std::optional<double> group_memory(const fs::path& membership, const fs::path& hierarchy) {
    double least = no_bound;
    std::ifstream stream(membership);
    for (std::string line; std::getline(stream, line);) { // "0::/group", or "4:memory:/group" of the first version
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (second == std::string::npos) {
            continue;
        }
        const std::string of = fmt::format(",{},", line.substr(first + 1, second - first - 1));
        const fs::path group = line.substr(second + 1);
        if (of == ",,") {
            least = std::min(least, least_above(group, hierarchy, "memory.max"));
        } else if (of.find(",memory,") != std::string::npos) {
            least = std::min(least, least_above(group, hierarchy / "memory", "memory.limit_in_bytes"));
        }
    }
    return least < no_bound ? std::optional(least) : std::nullopt;
}

double machine_memory() {
    const double all = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    return std::min(all, group_memory("/proc/self/cgroup", "/sys/fs/cgroup").value_or(all));
}

double bound_memory(double bytes) {
    rlimit limit{};
    if (!memory_is_bound || getrlimit(RLIMIT_DATA, &limit) != 0) {
        return no_bound;
    }
    const double before = of_limit(limit.rlim_cur);
    const double requested = std::min(bytes, of_limit(limit.rlim_max));
    constexpr double most = 9e18; // that rlim_t holds
    limit.rlim_cur = requested < most ? static_cast<rlim_t>(requested) : limit.rlim_max;
    setrlimit(RLIMIT_DATA, &limit);
    return before;
}

} // namespace suffuse
