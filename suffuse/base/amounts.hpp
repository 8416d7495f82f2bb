#pragma once
// Amounts as people read them: durations, ranges, sizes, counts.

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/range.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace suffuse {

/// "0.4 s", "12 s", "7 min 12 s", "1 h 36 min".
std::string duration_text(double seconds);

/// "20-40 s", "4-6 min", "1.2-1.6 h": both ends in one unit, and never narrower than a tenth of itself.
std::string duration_range_text(const Range& seconds);

/// "410 MB", "1.4 GB".
std::string size_text(double bytes);

/// "1,200".
std::string count_text(std::int64_t count);

/// So many digits, but all of a number above 100: "7.8e-05", "12.3", "1283".
std::string digits_text(double value, int count);

/// "2.1e6", or "1,200" below ten thousand; a range where its ends differ: "1.2e5-2.1e6".
std::string steps_text(const Range& steps);

/// "1 stage", "12 stages".
std::string plural(std::int64_t count, std::string_view noun);

} // namespace suffuse
