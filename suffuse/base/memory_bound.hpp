#pragma once
// How much memory this machine grants a program, and a bound on what this process takes of it.

#include <filesystem>
#include <optional>

namespace suffuse {

/// The machine's memory, or what a control group (a container, a batch system) leaves of it, where that is less [B].
double machine_memory();

/// The least limit of the groups that `membership` (as /proc/self/cgroup) names, below `hierarchy` (as /sys/fs/cgroup),
/// by either version of cgroups(7) [B]; nothing where none is set.
std::optional<double> group_memory(const std::filesystem::path& membership, const std::filesystem::path& hierarchy);

/// A sanitizer reserves terabytes for itself, which would count: nothing is bound under one.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool memory_is_bound = false;
#else
inline constexpr bool memory_is_bound = true;
#endif

/// From now on, memory beyond `bytes` is refused to this process: std::bad_alloc, not a kill by the system. Counted is
/// what it may write to (RLIMIT_DATA of setrlimit(2)), used or not. @return the bound before [B]
double bound_memory(double bytes);

} // namespace suffuse
