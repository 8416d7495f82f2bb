#include "suffuse/erosion/mobility.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/quantile.hpp"
#include "suffuse/cell/cell.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/erosion/mobility_bounds.hpp"
#include "suffuse/erosion/rest_under_weight.hpp"
#include "suffuse/erosion/weighed_copy.hpp"
#include "suffuse/stats/stress_by_fraction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::erosion {
namespace {

constexpr double hold_burst = 4;    ///< in units of WeightScale::time; measured in docs/theory/weight.md
constexpr int bursts_of_a_flow = 5; ///< after which it follows the fines

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
        throw CaseError("gradients: expected at least one, all above 0 and each above the one before: they are applied "
                        "one after the other");
    }
    const double length = norm(setting.direction);
    if (!(length > 0) || !std::isfinite(length)) {
        throw CaseError("direction: expected three numbers that are finite and not all zero: where the water goes");
    }
    if (!std::ranges::count(world.grains.fine, std::uint8_t{1})) {
        throw StateError("no grain is fine: with weight, fines must be defined; define them by `fines` of the soil");
    }
    if (!std::ranges::count(world.grains.fine, std::uint8_t{0})) {
        throw StateError("all grains are fines: there is no skeleton that they could move through; define the fines by "
                         "`fines` of the soil");
    }
}

/// What is known of the sample before anything moves.
MobilityResult describe(const dem::World& world, const MobilitySetting& setting, const WeighedCopy& copy) {
    MobilityResult result;
    result.down = setting.gravity.down;
    result.acceleration = setting.gravity.acceleration;
    result.direction = setting.direction / norm(setting.direction);
    result.specified_gradient = setting.specified_gradient;
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
void lay_to_rest(WeighedCopy& copy, const Vec3& down, const Pulse& pulse, MobilityResult& result) {
    const std::vector<Vec3> start = copy.positions();
    const Rest rest = rest_under_weight(copy, pulse);
    result.rested_for = rest.took;
    result.rest_steps = copy.steps();
    const Vec3 widths = cell::widths(copy.world().cell.h);
    const double cell_width = std::min({widths.x, widths.y, widths.z});
    const auto fall = [&](std::size_t k) { return dot(copy.position(k) - start[k], down); };
    result.fallen_mass_share =
        mass_share(result, [&](std::size_t k) { return has_fallen(fall(k), result.diameter[k]); });
    result.sifting_mass_share =
        mass_share(result, [&](std::size_t k) { return fall(k) > cell_width || (!rest.ended && rest.moving[k] != 0); });
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
    if (result.alpha_fines && is_upward(result)) { // as in their tests
        result.skempton_brogan_gradient = *result.alpha_fines * result.critical_gradient;
    }
}

/// The levels that are still ahead.
RefinedRamp levels_ahead(const MobilityRamp& ramp, const MobilitySetting& setting) {
    RefinedRamp levels(setting.gradients, ramp.result.heave_gradient, setting.specified_gradient);
    for (const double share : ramp.tried) {
        levels.take(share);
    }
    return levels;
}

/// The flow that pulls.
UnitSeepage solve_as_it_was(const MobilityRamp& ramp, const WeighedCopy& copy, const SolveFlow& solve) {
    dem::World then = ramp.world;
    for (std::size_t k = 0; k < ramp.solved_at.size(); ++k) {
        then.grains.position[copy.fines()[k]] = ramp.solved_at[k];
    }
    return solve(then);
}

/// One level of a ramp, on a copy of its fines.
class Level {
public:
    Level(
        WeighedCopy& copy, const MobilityRamp& ramp, const MobilitySetting& setting, const SolveFlow& solve,
        const WatchRamp& watch
    )
        : copy_(copy), so_far_(ramp.result), rest_(ramp.rest), solve_(solve), watch_(watch),
          moved_(setting.motion.moved), longest_hold_(setting.motion.hold_at_most),
          strength_(setting.gravity.acceleration / suffuse::gravity), // the flow is of standard gravity
          mobile_gradient_(ramp.result.mobile_gradient), water_(*ramp.water), solved_at_(ramp.solved_at) {}

    /// Holds one gradient until nothing new advances, or until it is known to be undone, and enters what is mobile. The
    /// flow follows the fines.
    MobilityStep bear(double gradient, std::optional<double> undone_at, const Pulse& pulse) {
        MobilityStep step{.gradient = gradient, .permeability = water_.permeability};
        std::vector<double> furthest;
        for (std::size_t k = 0; k < rest_.size(); ++k) {
            furthest.push_back(advance(k));
        }
        const auto mobile = [&](std::size_t k) { return is_mobile(k); };
        int bursts = 0; // of the flow
        copy_.load(water_.force, gradient * strength_);
        const double longest = longest_hold(gradient, mass_share(so_far_, mobile));
        for (bool holds_on = copy_.free_count() > 0; holds_on && step.held_for < longest;) {
            if (bursts++ == bursts_of_a_flow) {
                if (follow()) {
                    copy_.load(water_.force, gradient * strength_);
                }
                bursts = 1;
            }
            const double time = std::min(hold_burst, longest - step.held_for);
            copy_.hold(time, pulse, "ramp");
            step.held_for += time;
            std::int64_t advancing = 0;
            for (std::size_t k = 0; k < rest_.size(); ++k) {
                const double now = advance(k);
                if (!is_mobile(k) && now > moved_) {
                    mobile_gradient_[k] = gradient;
                }
                advancing += !is_mobile(k) && goes_on(now, furthest[k]) ? 1 : 0;
                furthest[k] = std::max(furthest[k], now);
            }
            step.still_moving = static_cast<double>(advancing) / static_cast<double>(rest_.size());
            step.mobile_mass_share = mass_share(so_far_, mobile);
            if (watch_) {
                watch_(so_far_.ramp, step);
            }
            holds_on = is_still_growing(step) && !(undone_at && step.mobile_mass_share >= *undone_at);
        }
        const auto count = std::ranges::count_if(mobile_gradient_, [](double i) { return !std::isnan(i); });
        step.mobile_number_share = static_cast<double>(count) / static_cast<double>(rest_.size());
        step.mobile_mass_share = mass_share(so_far_, mobile);
        step.lifted_mass_share = mass_share(so_far_, [&](std::size_t k) { return is_lifted(advance(k)); });
        step.displaced_mass_share = mass_share(so_far_, [&](std::size_t k) {
            return norm(copy_.position(k) - rest_[k]) > moved_ * so_far_.diameter[k];
        });
        return step;
    }

    /// The next level, if there is one, goes on from where this one has left the fines.
    void keep(const MobilityStep& step, bool is_last, MobilityRamp& ramp) {
        ramp.world = copy_.whole();
        if (!is_last) {
            follow();
        }
        ramp.result.ramp.push_back(step);
        ramp.result.mobile_gradient = std::move(mobile_gradient_);
        ramp.solved_at = std::move(solved_at_);
        ramp.water = std::move(water_);
    }

private:
    /// Solves the flow through the fines as they lie now, where enough of them lie elsewhere.
    bool follow() {
        double moved = 0, all = 0;
        for (std::size_t k = 0; k < rest_.size(); ++k) {
            const double diameters = norm(copy_.position(k) - solved_at_[k]) / so_far_.diameter[k];
            moved += so_far_.mass[k] * std::min(1.0, diameters);
            all += so_far_.mass[k];
        }
        const bool is_old = is_flow_old(moved / all);
        if (is_old) {
            water_ = solve_(copy_.world()), solved_at_ = copy_.positions();
        }
        return is_old;
    }

    [[nodiscard]] double longest_hold(double gradient, double mobile_share) const {
        if (floats(so_far_, gradient)) {
            return hold_burst; // what moves there counts for nothing
        }
        const double below = so_far_.ramp.empty() ? 0 : so_far_.ramp.back().gradient;
        const double share = share_of_hold(mobile_share, gradient - below);
        return share < 1 ? std::max(hold_burst, share * longest_hold_) : longest_hold_;
    }

    [[nodiscard]] double advance(std::size_t k) const {
        return dot(copy_.position(k) - rest_[k], so_far_.direction) / so_far_.diameter[k];
    }

    [[nodiscard]] bool is_mobile(std::size_t k) const { return !std::isnan(mobile_gradient_[k]); }

    WeighedCopy& copy_;
    const MobilityResult& so_far_;
    const std::vector<Vec3>& rest_;
    const SolveFlow& solve_;
    const WatchRamp& watch_;
    double moved_, longest_hold_, strength_;
    std::vector<double> mobile_gradient_;
    UnitSeepage water_; ///< that pulls
    std::vector<Vec3> solved_at_;
};

} // namespace

MobilityRamp
begin_ramp(const dem::World& equilibrium, const MobilitySetting& setting, const SolveFlow& solve, const Pulse& pulse) {
    check(equilibrium, setting);
    WeighedCopy copy(equilibrium, buoyant_weights(equilibrium, setting.gravity, setting.fluid), setting.motion);
    MobilityRamp ramp{.scale = copy.scale(), .result = describe(equilibrium, setting, copy)};
    check_heave(ramp.result, setting);
    lay_to_rest(copy, setting.gravity.down, pulse, ramp.result);
    ramp.rest = ramp.solved_at = copy.positions();
    ramp.water = solve(copy.world());
    ramp.result.flow = ramp.water->source;
    compare_with_weight(copy, *ramp.water, setting.gravity.acceleration / suffuse::gravity, ramp.result);
    ramp.world = copy.whole();
    return ramp;
}

void climb(
    MobilityRamp& ramp, const MobilitySetting& setting, const SolveFlow& solve, const Pulse& pulse,
    const WatchRamp& watch
) {
    RefinedRamp levels = levels_ahead(ramp, setting);
    const double gradient = levels.next().value();
    const std::string part = fmt::format(
        "gradient {:.3g}, {} of {}", gradient, levels.given_count() - levels.given_left() + 1, levels.given_count()
    );
    const std::int64_t before = ramp.result.rest_steps + ramp.result.ramp_steps;
    const Pulse of_level = [&](std::string_view, long long steps) { beat(pulse, part, before + steps); };
    WeighedCopy copy(ramp.world, ramp.scale, buoyant_weights(ramp.world, setting.gravity, setting.fluid));
    if (!ramp.water) {
        ramp.water = solve_as_it_was(ramp, copy, solve);
    }
    Level level(copy, ramp, setting, solve, watch);
    const MobilityStep step = level.bear(gradient, levels.undone_at(), of_level);
    const bool is_kept = levels.take(step.mobile_mass_share);
    if (is_kept) {
        level.keep(step, !levels.next(), ramp);
    }
    ramp.over = !levels.next();
    ramp.tried.push_back(step.mobile_mass_share);
    MobilityResult& result = ramp.result;
    result.ramp_steps += copy.steps();
    result.time_step = copy.time_step();
    result.moves_1 = gradient_that_moves(result, 0.01);
    result.moves_10 = gradient_that_moves(result, 0.1);
    result.moves_50 = gradient_that_moves(result, 0.5);
}

MobilityResult find_mobility(
    const dem::World& equilibrium, const MobilitySetting& setting, const SolveFlow& solve, const Pulse& pulse,
    const WatchRamp& watch
) {
    MobilityRamp ramp = begin_ramp(equilibrium, setting, solve, pulse);
    while (!ramp.over) {
        climb(ramp, setting, solve, pulse, watch);
    }
    return std::move(ramp.result);
}

void mark_leaving(MobilityResult& mobility, std::span<const std::uint8_t> passes) {
    for (MobilityStep& step : mobility.ramp) {
        step.leaving_mass_share = mass_share(mobility, [&](std::size_t k) {
            return passes[k] != 0 && mobility.mobile_gradient[k] <= step.gradient;
        });
    }
}

} // namespace suffuse::erosion
