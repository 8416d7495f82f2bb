#include "suffuse/erosion/mobility_result.hpp"

#include "suffuse/erosion/refined_ramp.hpp"

#include <algorithm>

namespace suffuse::erosion {

namespace {

/// Two steps of the ramp, or its start, between which something is reached.
struct Between {
    MobilityStep below, above;
};

std::optional<Between> where_reached(const MobilityResult& mobility, double share) {
    MobilityStep below; // nothing moves without flow
    for (const MobilityStep& step : steps_below_heave(mobility)) {
        if (step.mobile_mass_share >= share) {
            return Between{below, step};
        }
        below = step;
    }
    return std::nullopt;
}

} // namespace

bool is_upward(const MobilityResult& mobility) {
    return dot(mobility.down, mobility.direction) < -0.9999;
}

bool floats(const MobilityResult& mobility, double gradient) {
    return mobility.heave_gradient && gradient >= *mobility.heave_gradient;
}

std::optional<double> gradient_that_moves(const MobilityResult& mobility, double share) {
    const std::optional<Between> found = where_reached(mobility, share);
    if (!found) {
        return std::nullopt;
    }
    const auto& [below, above] = *found;
    const double part = (share - below.mobile_mass_share) / (above.mobile_mass_share - below.mobile_mass_share);
    return below.gradient + part * (above.gradient - below.gradient);
}

bool is_upper_bound(const MobilityResult& mobility, double share) {
    constexpr double known = 1.0001 * gradient_width; // within such a step more motion changes it by no more
    const std::optional<Between> found = where_reached(mobility, share);
    return found && (is_still_growing(found->below) ||
                     (is_still_growing(found->above) && found->above.gradient - found->below.gradient > known));
}

std::span<const MobilityStep> steps_below_heave(const MobilityResult& mobility) {
    const auto end =
        std::ranges::find_if(mobility.ramp, [&](const MobilityStep& step) { return floats(mobility, step.gradient); });
    return {mobility.ramp.begin(), end};
}

std::optional<double> mobile_share_at(const MobilityResult& mobility, double gradient) {
    double below = 0, moved = 0;
    for (const MobilityStep& step : steps_below_heave(mobility)) {
        if (step.gradient >= gradient) {
            const double part = step.gradient > below ? (gradient - below) / (step.gradient - below) : 1;
            return moved + part * (step.mobile_mass_share - moved);
        }
        below = step.gradient, moved = step.mobile_mass_share;
    }
    return std::nullopt;
}

bool is_lower_bound(const MobilityResult& mobility, double gradient) {
    const std::span<const MobilityStep> steps = steps_below_heave(mobility);
    const auto step = std::ranges::find_if(steps, [&](const MobilityStep& s) { return s.gradient >= gradient; });
    return step != steps.end() && is_still_growing(*step);
}

std::optional<FactorOfSafety> factor_of_safety(const MobilityResult& mobility) {
    if (!mobility.specified_gradient || !(*mobility.specified_gradient > 0) || mobility.ramp.empty()) {
        return std::nullopt;
    }
    const double specified = *mobility.specified_gradient;
    const bool is_at_most = is_upper_bound(mobility, 0.01);
    if (mobility.moves_1 && !is_at_most) {
        return FactorOfSafety{*mobility.moves_1 / specified, *mobility.moves_1 / specified};
    }
    double borne = 0;
    for (const MobilityStep& step : steps_below_heave(mobility)) {
        if (step.mobile_mass_share < 0.01 && !is_still_growing(step)) {
            borne = step.gradient;
        }
    }
    return FactorOfSafety{
        mobility.moves_1 ? std::optional(*mobility.moves_1 / specified) : std::nullopt, borne / specified, is_at_most};
}

} // namespace suffuse::erosion
