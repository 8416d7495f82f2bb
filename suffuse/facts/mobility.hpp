#pragma once
// Which gradients move the fines against their weight.

#include "suffuse/erosion/mobility_result.hpp"
#include "suffuse/facts/fact.hpp"

#include <map>
#include <optional>
#include <string>

namespace suffuse::facts {

/// A gradient of the ramp: an object of `mobility`.
inline constexpr std::tuple mobility_step{
    row<&erosion::MobilityStep::gradient>("gradient", "-", "hydraulic gradient"),
    row<&erosion::MobilityStep::mobile_mass_share>(
        "mobile_mass_share", "-",
        "of the fines' mass: moved along the flow by half a diameter, at this gradient or a lower one"
    ),
    row<&erosion::MobilityStep::mobile_number_share>("mobile_number_share", "-", "the same, of their number"),
    row<&erosion::MobilityStep::leaving_mass_share>(
        "leaving_mass_share", "-", "mobile, and smaller than the constriction; null where no constriction decides"
    ),
    row<&erosion::MobilityStep::lifted_mass_share>(
        "lifted_mass_share", "-", "moved along the flow by a tenth of a diameter"
    ),
    row<&erosion::MobilityStep::displaced_mass_share>(
        "displaced_mass_share", "-", "moved half a diameter in any direction"
    ),
    row<&erosion::MobilityStep::held_for>("held_for", "-", "how long the gradient was held, in units of time"),
    row<&erosion::MobilityStep::still_moving>(
        "still_moving", "-", "of the fines' number: still advanced at the end, mobile ones not counted"
    ),
    row<&erosion::MobilityStep::permeability>("permeability", "m2", "along the flow, at the start of the step"),
    row<&erosion::is_still_growing>(
        "still_growing", "", "whether more than 0.3 % still advanced: the shares are then lower bounds"
    ),
};

/// The gradient that moves 1 % of the fines over the specified one; nothing where the ramp ends before.
inline std::optional<double> safety(const erosion::MobilityResult& mobility) {
    const auto found = erosion::factor_of_safety(mobility);
    return found ? found->factor : std::nullopt;
}

/// `detach` with weight, and each pass of `erode` with weight.
inline constexpr std::tuple mobility{
    row<[](const erosion::MobilityResult& m) {
        return std::map<std::string, std::optional<double>>{
            {"1 %", m.moves_1}, {"10 %", m.moves_10}, {"50 %", m.moves_50}};
    }>("critical_gradient", "-",
       "`1 %`, `10 %`, `50 %`: the gradients that make so much of the fines' mass mobile; null beyond the ramp, and "
       "where the whole soil floats first"),
    row<[](const erosion::MobilityResult& m) {
        return std::map<std::string, bool>{
            {"1 %", erosion::is_upper_bound(m, 0.01)},
            {"10 %", erosion::is_upper_bound(m, 0.1)},
            {"50 %", erosion::is_upper_bound(m, 0.5)}};
    }>("critical_gradient_at_most", "",
       "the same three: whether that gradient is an upper bound, as motion had not ended when the gradient rose"),
    row<&erosion::MobilityResult::critical_gradient>(
        "terzaghi_gradient", "-", "i_c: upward flow at this gradient lifts the whole soil", "critical_gradient"
    ),
    row<&erosion::MobilityResult::heave_gradient>(
        "heave_gradient", "-", "at which this flow lifts the whole soil; null where it never does"
    ),
    row<&erosion::MobilityResult::alpha_fines>(
        "alpha_fines", "-", "α, mean effective stress in the fines over that of the soil"
    ),
    row<&erosion::MobilityResult::skempton_brogan_gradient>(
        "skempton_brogan_gradient", "-", "α × i_c, of vertical flow upward; else null"
    ),
    row<&erosion::MobilityResult::fines_heave_gradient>(
        "fines_heave_gradient", "-", "`heave_gradient` × FC/s, or null"
    ),
    row<&erosion::MobilityResult::single_grain_gradient>(
        "single_grain_gradient", "-", "above it 5 % of the fines weigh less than their own seepage force"
    ),
    row<&erosion::MobilityResult::drag_share>(
        "fines_drag_share", "-", "s, share of the seepage force along the flow that acts on fines", "drag_share"
    ),
    row<&erosion::MobilityResult::load_bearing_mass_share>(
        "load_bearing_mass_share", "-", "of the fines' mass: fixed, as they carry the skeleton's forces"
    ),
    row<&erosion::MobilityResult::sifting_mass_share>(
        "sifting_mass_share", "-", "of the fines' mass: fell through the skeleton without flow"
    ),
    row<&erosion::MobilityResult::sifts>("sifts_under_its_weight", "", "whether more than 1 % did", "sifts"),
    row<&erosion::MobilityResult::fallen_mass_share>(
        "fallen_mass_share", "-", "of the fines' mass: fell half a diameter before it rested"
    ),
    row<&erosion::MobilityResult::rested_for>("rested_for", "-", "how long that took, in units of time"),
    row<&erosion::MobilityResult::weight_scale>(
        "weight_scale", "-", "K, by which all forces from outside were multiplied"
    ),
    row<&erosion::MobilityResult::down>("down", "-", "unit vector"),
    row<&erosion::MobilityResult::direction>("direction", "-", "of the flow, unit vector"),
    row<&erosion::MobilityResult::acceleration>("gravity", "m/s2", "acceleration by which fines weigh", "acceleration"),
    saved_alone<&erosion::MobilityResult::flow>("flow"),
    saved_alone<&erosion::MobilityResult::ramp>("ramp"),
    saved_alone<&erosion::MobilityResult::fines_content>("fines_content"),
    saved_alone<&erosion::MobilityResult::moves_1>("moves_1"),
    saved_alone<&erosion::MobilityResult::moves_10>("moves_10"),
    saved_alone<&erosion::MobilityResult::moves_50>("moves_50"),
    saved_alone<&erosion::MobilityResult::specified_gradient>("asked_gradient"),
    saved_alone<&erosion::MobilityResult::time_step>("time_step"),
    saved_alone<&erosion::MobilityResult::rest_steps>("rest_steps"),
    saved_alone<&erosion::MobilityResult::ramp_steps>("ramp_steps"),
    saved_alone<&erosion::MobilityResult::id>("id"),
    saved_alone<&erosion::MobilityResult::diameter>("diameter"),
    saved_alone<&erosion::MobilityResult::mass>("mass"),
    saved_alone<&erosion::MobilityResult::mobile_gradient>("mobile_gradient"),
    saved_alone<&erosion::MobilityResult::bears_load>("bears_load"),
};

/// What there is beyond that where a gradient is specified.
inline constexpr std::tuple mobility_at_gradient{
    row<[](const erosion::MobilityResult& m) { return m.specified_gradient; }>(
        "asked_gradient", "-", "the specified gradient; an erosion's own is one"
    ),
    row<[](const erosion::MobilityResult& m) { return erosion::mobile_share_at(m, *m.specified_gradient); }>(
        "mobile_mass_share_at_asked", "-",
        "of the fines' mass: mobile at that gradient; null beyond the ramp, and where the whole soil floats"
    ),
    row<&safety>("factor_of_safety", "-", "the gradient that moves 1 % over the specified one, or null"),
    row<[](const erosion::MobilityResult& m) {
        const auto found = erosion::factor_of_safety(m);
        return found && found->is_at_most;
    }>("factor_of_safety_at_most", "",
       "whether that factor is an upper bound, as motion had not ended when the gradient rose"),
};

} // namespace suffuse::facts
