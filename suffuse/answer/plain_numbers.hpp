#pragma once
// Numbers as people write them, for what stands large on the page: two or three digits, a true minus, a unit, and
// compared with the mean a deviation with the mean's own digits. Never a power of ten where a word says it.

#include "suffuse/flow/fluid.hpp"
#include "suffuse/study/study_curves.hpp"

#include <string>

namespace suffuse::answer {

/// "−0.30": so many decimals, with a true minus, and never -0.
std::string fixed(double value, int decimals);

/// Decimals that leave `digits` significant ones, none for 100 and more.
int decimals_for(double value, int digits);

/// A share as a percentage of two digits: "14 %", "0.2 %", "< 0.1 %", "none".
std::string percent_text(double share);

/// Whether a change is rounding and the balance's noise.
bool is_no_change(double change);

/// The same with its sign, of a change: "−19 %", "+9 %", "none" where nothing changed to a thousandth.
std::string change_text(double change);

/// "± 0.03"; empty for a single sample, and where samples agree to the last digit shown.
std::string spread_text(const study::Scatter& value, double factor, int decimals);

/// "0.55 mm/s", "56 µm/s", "3 m/s": how fast water of this fluid seeps under a gradient of one.
std::string conductivity_text(double permeability, const flow::Fluid& fluid);

/// "5.6 × 10⁻¹¹ m²".
std::string permeability_text(double permeability);

/// "one", "two" ... "nine", "10".
std::string count_in_words(std::size_t count);

} // namespace suffuse::answer
