#pragma once
// The gradients that fines of weight bear one after the other.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace suffuse::erosion {

/// 0.15, and not the next number above.
inline double rounded_gradient(double gradient) {
    constexpr double digits = 1e12;
    return std::round(gradient * digits) / digits;
}

/// Gradients up to `up_to` in so many equal steps.
inline std::vector<double> even_gradients(double up_to, std::int64_t steps) {
    std::vector<double> gradients;
    for (std::int64_t k = 1; k < steps; ++k) {
        gradients.push_back(rounded_gradient(up_to * static_cast<double>(k) / static_cast<double>(steps)));
    }
    gradients.push_back(up_to);
    return gradients;
}

/// Gradients up to this one in steps that separate what moves early from what moves late: 0.05, from 0.4 on 0.1.
inline std::vector<double> gradients_up_to(double last) {
    constexpr double early = 0.05, early_until = 0.4, late = 0.1;
    std::vector<double> gradients;
    const auto add_steps = [&](double from, double to, double most) {
        const auto count = static_cast<std::int64_t>(std::ceil((to - from) / most * (1 - 1e-12)));
        for (std::int64_t k = 1; k < count; ++k) {
            gradients.push_back(
                rounded_gradient(from + static_cast<double>(k) * (to - from) / static_cast<double>(count))
            );
        }
        gradients.push_back(to);
    };
    add_steps(0, std::min(last, early_until), early);
    if (last > early_until) {
        add_steps(early_until, last, late);
    }
    return gradients;
}

} // namespace suffuse::erosion
