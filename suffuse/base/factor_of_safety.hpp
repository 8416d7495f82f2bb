#pragma once
// How the program writes factors of safety: with two digits below 10, and never rounded to 1 from below.

#include <string>

namespace suffuse {

/// Below 1 a hundredth decides.
int decimals_of_factor(double factor);

/// "1.5", "0.82"; "0.99" for 0.996.
std::string factor_text(double factor);

/// A lower bound, which rounding does not raise: "1.4" for 1.49.
std::string least_factor_text(double least);

} // namespace suffuse
