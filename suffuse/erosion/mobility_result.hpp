#pragma once
// Which fines a gradient moves against their weight, as plain values.

#include "suffuse/base/vec3.hpp"
#include "suffuse/flow/known_error.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace suffuse::erosion {

/// The state that fines of weight reach under one gradient of the ramp. Shares are of the mass of all fines unless
/// said.
struct MobilityStep {
    double gradient = 0;            ///< hydraulic [-]
    double mobile_mass_share = 0;   ///< moved along the flow by half a diameter, at this gradient or a lower one
    double mobile_number_share = 0; ///< of their number
    std::optional<double> leaving_mass_share; ///< mobile, and smaller than the constriction; nothing where none decides
    double lifted_mass_share = 0;             ///< moved along the flow by a tenth of a diameter
    double displaced_mass_share = 0;          ///< moved half a diameter whatever the direction
    double held_for = 0;                      ///< time that the gradient was held, in units of WeightScale::time [-]
    double still_moving = 0; ///< of the number of fines, that advance in the last of it, mobile ones not counted [-]
    double permeability = 0; ///< along the flow, of the packing at the start of the step [m2]
};

/// Whether the gradient rose before motion had ended: the mobile share is then a lower bound.
constexpr bool is_still_growing(const MobilityStep& step) {
    return step.still_moving > 0.003;
}

/// Whether so large a share of the fines' mass falls through the skeleton that it must be said.
constexpr bool is_notable_sifting(double mass_share) {
    return mass_share > 0.01;
}

/// Fines under their weight: laid to rest without flow, then under a gradient that rises step by step.
struct MobilityResult {
    Vec3 down, direction;    ///< unit vectors
    double acceleration = 0; ///< of gravity [m/s2]
    flow::FlowSource flow;   ///< that the forces are of, at the first step
    std::vector<MobilityStep> ramp;

    double critical_gradient = 0;         ///< i_c of Terzaghi [-]
    std::optional<double> heave_gradient; ///< at which this flow lifts the whole soil; none where it never does
    std::optional<double> alpha_fines;    ///< stress that the fines carry, stats/stress_by_fraction.hpp [-]
    std::optional<double> skempton_brogan_gradient; ///< alpha x heave gradient [SkemptonBrogan1994]
    std::optional<double> fines_heave_gradient;     ///< heave of the fines alone: heave gradient x FC/s
    std::optional<double> single_grain_gradient; ///< 5 % of the fines weigh less than their own seepage force beyond it
    double fines_content = 0;                    ///< by mass [-]
    double drag_share = 0;                       ///< of the seepage force along the flow that acts on fines: s [-]
    std::optional<double> moves_1, moves_10,
        moves_50;                             ///< gradients that make so many percent of the fines' mass mobile
    std::optional<double> specified_gradient; ///< that the soil has to bear

    double load_bearing_mass_share = 0; ///< of the fines that carry the skeleton's forces, and were held
    double sifting_mass_share = 0;      ///< of those that fell over a cell without flow, or were falling still
    bool sifts = false;                 ///< whether that is notable
    double fallen_mass_share = 0;       ///< of those that fell half a diameter before they rested
    double rested_for = 0;              ///< time of the rest, in units of WeightScale::time [-]
    double weight_scale = 1;            ///< K [-]
    double time_step = 0;               ///< [s]
    std::int64_t rest_steps = 0, ramp_steps = 0;

    std::vector<std::uint32_t> id;        ///< of the fines, as all that follows
    std::vector<double> diameter, mass;   ///< [m], [kg]
    std::vector<double> mobile_gradient;  ///< of the first step at which it was mobile; not a number: at none [-]
    std::vector<std::uint8_t> bears_load; ///< 1: held
};

/// Whether the flow is straight up, within a degree.
bool is_upward(const MobilityResult& mobility);

/// Whether seepage at this gradient lifts the whole soil.
bool floats(const MobilityResult& mobility, double gradient);

/// The steps of the ramp that count: where the whole soil floats, a step is only held for a moment.
std::span<const MobilityStep> steps_below_heave(const MobilityResult& mobility);

/// The gradient at which the mobile share of the mass reaches `share`, linear between steps; nothing beyond the ramp,
/// nor where the whole soil floats first.
std::optional<double> gradient_that_moves(const MobilityResult& mobility, double share);

/// Whether that gradient is an upper bound: with a longer hold a lower one would have moved as much.
bool is_upper_bound(const MobilityResult& mobility, double share);

/// Of the mass at one gradient, linear between steps; nothing beyond the ramp, nor where the whole soil floats.
std::optional<double> mobile_share_at(const MobilityResult& mobility, double gradient);

/// Whether that share is a lower bound: with a longer hold as much or more would move.
bool is_lower_bound(const MobilityResult& mobility, double gradient);

/// The gradient that moves 1 % of the fines over the specified one.
struct FactorOfSafety {
    std::optional<double> factor; ///< nothing where the ramp ends before
    double at_least = 0;          ///< where that is none or a bound: of the last step that moves less, motion ended
    bool is_at_most = false;      ///< as that gradient: is_upper_bound()
};

/// Nothing where no gradient is requested.
std::optional<FactorOfSafety> factor_of_safety(const MobilityResult& mobility);

} // namespace suffuse::erosion
