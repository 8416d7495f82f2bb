#include "suffuse/erosion/mobility_result.hpp"

#include <algorithm>

namespace suffuse::erosion {

std::optional<double> gradient_that_moves(const MobilityResult& mobility, double share) {
    double gradient = 0, moved = 0; // of the step before: nothing moves without flow
    for (const MobilityStep& step : mobility.ramp) {
        if (step.mobile_mass_share >= share) {
            return gradient + (share - moved) / (step.mobile_mass_share - moved) * (step.gradient - gradient);
        }
        gradient = step.gradient, moved = step.mobile_mass_share;
    }
    return std::nullopt;
}

std::optional<double> mobile_share_at(const MobilityResult& mobility, double gradient) {
    double below = 0, moved = 0;
    for (const MobilityStep& step : mobility.ramp) {
        if (step.gradient >= gradient) {
            const double part = step.gradient > below ? (gradient - below) / (step.gradient - below) : 1;
            return moved + part * (step.mobile_mass_share - moved);
        }
        below = step.gradient, moved = step.mobile_mass_share;
    }
    return std::nullopt;
}

std::optional<FactorOfSafety> factor_of_safety(const MobilityResult& mobility) {
    if (!mobility.asked_gradient || !(*mobility.asked_gradient > 0) || mobility.ramp.empty()) {
        return std::nullopt;
    }
    const double asked = *mobility.asked_gradient;
    if (mobility.moves_1) {
        return FactorOfSafety{*mobility.moves_1 / asked, *mobility.moves_1 / asked};
    }
    return FactorOfSafety{std::nullopt, mobility.ramp.back().gradient / asked};
}

} // namespace suffuse::erosion
