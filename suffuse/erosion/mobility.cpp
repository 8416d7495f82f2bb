#include "suffuse/erosion/mobility.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/quantile.hpp"
#include "suffuse/cell/cell.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/erosion/weighed_copy.hpp"
#include "suffuse/stats/stress_by_fraction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::erosion {
namespace {

// The rest: bursts until so few of the free fines still move. Measured against longer rests in docs/theory/weight.md.
constexpr double rest_burst = 5, longest_rest = 200; ///< in units of WeightScale::time
constexpr double rest_motion = 0.02;                 ///< of a diameter in a burst
constexpr double rest_share = 0.002;                 ///< of the number of free fines

// A step of the ramp, likewise.
constexpr double hold_burst = 4, longest_hold = 20;
constexpr double hold_motion = 0.01;
constexpr double hold_share = 0.001; ///< of the number of fines, on which the curve depends no further

constexpr double mobile_motion = 0.5; ///< along the flow, of a diameter: out of the place where it rested
constexpr double lifted_motion = 0.1; ///< likewise: against the roof of its cage

/// Masses of the fines of the result, those for which `counts` holds over all.
template <class Counts>
double mass_share(const MobilityResult& result, Counts&& counts) {
    double all = 0, some = 0;
    for (std::size_t k = 0; k < result.mass.size(); ++k) {
        all += result.mass[k];
        some += counts(k) ? result.mass[k] : 0;
    }
    return all > 0 ? some / all : 0;
}

void check(const dem::World& world, const MobilitySetting& setting) {
    const std::vector<double>& gradients = setting.gradients;
    const auto wrong = std::ranges::adjacent_find(gradients, [](double a, double b) { return !(a < b); });
    if (gradients.empty() || !(gradients.front() > 0) || wrong != gradients.end()) {
        throw CaseError("gradients: expected at least one, all above 0 and each above the one before: the fines bear "
                        "them one after the other");
    }
    const double length = norm(setting.direction);
    if (!(length > 0) || !std::isfinite(length)) {
        throw CaseError("direction: expected three numbers that are finite and not all zero: where the water goes");
    }
    if (!std::ranges::count(world.grains.fine, std::uint8_t{1})) {
        throw StateError("no grain is fine: weight asks which fines the water moves; say which grains are fine, by "
                         "`fines` of the soil");
    }
    if (!std::ranges::count(world.grains.fine, std::uint8_t{0})) {
        throw StateError("all grains are fines: there is no skeleton that they could move through; say which grains "
                         "are fine, by `fines` of the soil");
    }
}

/// What is known of the sample before anything moves.
MobilityResult describe(const dem::World& world, const MobilitySetting& setting, const WeighedCopy& copy) {
    MobilityResult result;
    result.down = setting.gravity.down;
    result.acceleration = setting.gravity.acceleration;
    result.direction = setting.direction / norm(setting.direction);
    result.asked_gradient = setting.asked_gradient;
    result.critical_gradient = critical_gradient(dem::porosity(world), world.material.density, setting.fluid.density);
    result.heave_gradient = heave_gradient(result.critical_gradient, setting.gravity, result.direction);
    const stats::StressByFraction stress = stats::measure_stress_by_fraction(world);
    if (dem::mean_stress(stress.total) > 0) {
        result.alpha_fines = stress.alpha_fines;
    }
    result.fines_content = stress.fines_content;
    result.weight_scale = copy.scale().factor;
    for (std::size_t k = 0; k < copy.fines().size(); ++k) {
        const std::uint32_t g = copy.fines()[k];
        result.id.push_back(world.grains.id[g]);
        result.diameter.push_back(2 * world.grains.radius[g]);
        result.mass.push_back(world.grains.mass[g]);
        result.bears_load.push_back(copy.bears_load(k) ? 1 : 0);
    }
    result.mobile_gradient.assign(result.id.size(), std::numeric_limits<double>::quiet_NaN());
    result.load_bearing_mass_share = mass_share(result, [&](std::size_t k) { return result.bears_load[k] != 0; });
    return result;
}

void check_heave(const MobilityResult& result, const MobilitySetting& setting) {
    if (result.heave_gradient && *result.heave_gradient < setting.gradients.front()) {
        throw StateError(fmt::format(
            "gradients: the ramp begins at i = {:.4g}, and this soil heaves at {:.4g}: the water lifts the skeleton "
            "before the first step; begin lower, as with {{ up_to = {:.2g}, steps = 24 }}",
            setting.gradients.front(), *result.heave_gradient, *result.heave_gradient
        ));
    }
}

/// Fines fall into place under their weight alone.
void rest(WeighedCopy& copy, const Vec3& down, const Pulse& pulse, MobilityResult& result) {
    const std::vector<Vec3> start = copy.positions();
    std::vector<std::uint8_t> moving(start.size(), 1);
    bool rests = copy.free_count() == 0;
    while (!rests && result.rested_for < longest_rest) {
        const std::vector<Vec3> before = copy.positions();
        copy.hold(rest_burst, {}, 0, pulse, "rest");
        result.rested_for += rest_burst;
        std::int64_t count = 0;
        for (std::size_t k = 0; k < before.size(); ++k) {
            moving[k] = norm(copy.position(k) - before[k]) > rest_motion * result.diameter[k] ? 1 : 0;
            count += moving[k];
        }
        rests = static_cast<double>(count) <= rest_share * static_cast<double>(copy.free_count());
    }
    result.rest_steps = copy.steps();
    const Vec3 widths = cell::widths(copy.world().cell.h);
    const double cell_width = std::min({widths.x, widths.y, widths.z});
    const auto fall = [&](std::size_t k) { return dot(copy.position(k) - start[k], down); };
    result.fallen_mass_share =
        mass_share(result, [&](std::size_t k) { return fall(k) > mobile_motion * result.diameter[k]; });
    result.sifting_mass_share =
        mass_share(result, [&](std::size_t k) { return fall(k) > cell_width || (!rests && moving[k] != 0); });
    result.sifts = is_notable_sifting(result.sifting_mass_share);
}

/// Shares of the seepage force, and the gradient that lifts single grains, of the fines where they rest.
void compare_with_weight(const WeighedCopy& copy, const UnitSeepage& water, double strength, MobilityResult& result) {
    double all = 0, of_fines = 0;
    for (const Vec3& force : water.force) {
        all += dot(force, result.direction);
    }
    std::vector<double> lifting;
    for (const std::uint32_t g : copy.fines()) {
        const double along = dot(water.force[g], result.direction);
        of_fines += along;
        lifting.push_back(along > 0 ? norm(copy.weight(g)) / (strength * along) : std::numeric_limits<double>::max());
    }
    result.drag_share = all > 0 ? of_fines / all : 0;
    if (result.heave_gradient) {
        if (result.drag_share > 0) {
            result.fines_heave_gradient = *result.heave_gradient * result.fines_content / result.drag_share;
        }
        result.single_grain_gradient = quantile(std::move(lifting), 0.05);
    }
    if (result.alpha_fines && result.heave_gradient) {
        result.skempton_brogan_gradient = *result.alpha_fines * *result.heave_gradient;
    }
}

/// Holds one gradient until nothing new moves, and enters what is mobile by then.
/// @param rest where the fines rested
MobilityStep bear(
    WeighedCopy& copy, double gradient, const UnitSeepage& water, double strength, const std::vector<Vec3>& rest,
    const Pulse& pulse, MobilityResult& result
) {
    MobilityStep step;
    step.gradient = gradient;
    step.permeability = water.permeability;
    const auto moved_along = [&](std::size_t k) {
        return dot(copy.position(k) - rest[k], result.direction) / result.diameter[k];
    };
    const auto is_mobile = [&](std::size_t k) { return !std::isnan(result.mobile_gradient[k]); };
    bool goes_on = copy.free_count() > 0;
    while (goes_on && step.held_for < longest_hold) {
        const std::vector<Vec3> before = copy.positions();
        copy.hold(hold_burst, water.force, gradient * strength, pulse, "ramp");
        step.held_for += hold_burst;
        std::int64_t moving = 0;
        for (std::size_t k = 0; k < rest.size(); ++k) {
            if (!is_mobile(k) && moved_along(k) > mobile_motion) {
                result.mobile_gradient[k] = gradient;
            }
            const bool moves = norm(copy.position(k) - before[k]) > hold_motion * result.diameter[k];
            moving += moves && !is_mobile(k) ? 1 : 0;
        }
        step.still_moving = static_cast<double>(moving) / static_cast<double>(rest.size());
        goes_on = step.still_moving > hold_share;
    }
    const auto mobile = std::count_if(result.mobile_gradient.begin(), result.mobile_gradient.end(), [](double i) {
        return !std::isnan(i);
    });
    step.mobile_number_share = static_cast<double>(mobile) / static_cast<double>(result.id.size());
    step.mobile_mass_share = mass_share(result, is_mobile);
    step.lifted_mass_share = mass_share(result, [&](std::size_t k) { return moved_along(k) > lifted_motion; });
    step.displaced_mass_share = mass_share(result, [&](std::size_t k) {
        return norm(copy.position(k) - rest[k]) > mobile_motion * result.diameter[k];
    });
    return step;
}

} // namespace

MobilityResult find_mobility(
    const dem::World& equilibrium, const MobilitySetting& setting, const SolveFlow& solve, const Pulse& pulse
) {
    check(equilibrium, setting);
    WeighedCopy copy(equilibrium, buoyant_weights(equilibrium, setting.gravity, setting.fluid), setting.softness);
    MobilityResult result = describe(equilibrium, setting, copy);
    check_heave(result, setting);
    rest(copy, setting.gravity.down, pulse, result);
    const std::vector<Vec3> rested = copy.positions();
    // The flow is of standard gravity: another pulls at grains and water alike.
    const double strength = setting.gravity.acceleration / suffuse::gravity;
    for (const double gradient : setting.gradients) {
        const UnitSeepage water = solve(copy.world());
        if (result.ramp.empty()) {
            result.flow = water.source;
            compare_with_weight(copy, water, strength, result);
        }
        const auto count = result.ramp.size() + 1;
        const Pulse beat_of_gradient = [&](std::string_view, long long steps) {
            beat(pulse, fmt::format("gradient {:.3g}, {} of {}", gradient, count, setting.gradients.size()), steps);
        };
        result.ramp.push_back(bear(copy, gradient, water, strength, rested, beat_of_gradient, result));
    }
    result.ramp_steps = copy.steps() - result.rest_steps;
    result.time_step = copy.time_step();
    result.moves_1 = gradient_that_moves(result, 0.01);
    result.moves_10 = gradient_that_moves(result, 0.1);
    result.moves_50 = gradient_that_moves(result, 0.5);
    return result;
}

void tell_leaving(MobilityResult& mobility, std::span<const std::uint8_t> passes) {
    for (MobilityStep& step : mobility.ramp) {
        step.leaving_mass_share = mass_share(mobility, [&](std::size_t k) {
            return passes[k] != 0 && mobility.mobile_gradient[k] <= step.gradient;
        });
    }
}

} // namespace suffuse::erosion
