#include "suffuse/base/factor_of_safety.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse {

int decimals_of_factor(double factor) {
    return factor < 1 ? 2 : 1;
}

std::string factor_text(double factor) {
    constexpr double largest_below_1 = 0.99;
    return fmt::format("{:.{}f}", factor < 1 ? std::min(factor, largest_below_1) : factor, decimals_of_factor(factor));
}

std::string least_factor_text(double least) {
    constexpr double rounding = 1e-9;
    const double scale = std::pow(10, decimals_of_factor(least));
    return factor_text(std::floor(scale * least + rounding) / scale);
}

} // namespace suffuse
