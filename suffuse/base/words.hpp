#pragma once
// Numbers and units as a reader expects them in a sentence.

#include "suffuse/base/grouped.hpp"

#include <string>
#include <string_view>

namespace suffuse {

/// `digits` significant digits, no trailing zeros, powers of ten written as such outside 0.001 to 100,000: 1.37·10⁻⁵.
std::string short_number(double value, int digits = 3);

/// With its power of ten whatever its size: 1.37·10⁻³, so that the numbers of a column can be compared at a glance.
std::string number_with_power(double value, int digits = 3);

/// Of a percentage of the volume or of a stress: below a hundredth a change is noise of the balance.
bool is_noise(double percent);

/// The percentage to a hundredth, "< 0.01" where it is noise.
std::string percent_beyond_noise(double percent);

/// 10⁻⁵ for -5.
std::string power_of_ten(int exponent);

/// The same text with spaces that do not break between a number and its unit, nor around "=" and "<".
std::string kept_together(std::string_view text);

/// "Pass 1" for "pass 1": how a sentence begins.
std::string as_sentence(std::string text);

} // namespace suffuse
