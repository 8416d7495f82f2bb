#include "suffuse/study/factor_of_safety.hpp"

#include <fmt/format.h>

namespace suffuse::study {

std::string factor_text(const Scatter& factor) {
    if (factor.seeds == 0) {
        return "–";
    }
    const int decimals = decimals_of_factor(factor.mean);
    const std::string deviation = fmt::format("{:.{}f}", factor.standard_deviation, decimals);
    const bool has_scatter = factor.seeds > 1 && deviation.find_first_not_of("0.") != std::string::npos;
    return suffuse::factor_text(factor.mean) + (has_scatter ? " ± " + deviation : "");
}

} // namespace suffuse::study
