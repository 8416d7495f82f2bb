#include "suffuse/study/factor_of_safety.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::study {

int decimals_of_factor(double factor) {
    return factor < 1 ? 2 : 1;
}

std::string factor_text(double factor) {
    constexpr double largest_below_1 = 0.99;
    return fmt::format("{:.{}f}", factor < 1 ? std::min(factor, largest_below_1) : factor, decimals_of_factor(factor));
}

std::string factor_text(const Scatter& factor) {
    if (factor.seeds == 0) {
        return "–";
    }
    const int decimals = decimals_of_factor(factor.mean);
    const std::string deviation = fmt::format("{:.{}f}", factor.standard_deviation, decimals);
    const bool has_scatter = factor.seeds > 1 && deviation.find_first_not_of("0.") != std::string::npos;
    return factor_text(factor.mean) + (has_scatter ? " ± " + deviation : "");
}

std::string least_factor_text(double least) {
    constexpr double rounding = 1e-9;
    const double scale = std::pow(10, decimals_of_factor(least));
    return factor_text(std::floor(scale * least + rounding) / scale);
}

} // namespace suffuse::study
