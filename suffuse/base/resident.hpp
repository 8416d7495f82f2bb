#pragma once
// Memory that this process has in use, as the system counts it.

#include <cstdint>

namespace suffuse {

/// In use now [bytes].
/// @throws Error where the system does not report it.
std::int64_t resident_bytes();

/// The most in use since `forget_peak` [bytes].
std::int64_t peak_resident_bytes();
void forget_peak();

/// Returns freed memory that the allocator keeps to the system, where possible.
void trim_heap();

} // namespace suffuse
