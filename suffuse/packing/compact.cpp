#include "suffuse/packing/compact.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/cell/hold_stress.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/grains/gradation.hpp"
#include "suffuse/packing/overlaps.hpp"
#include "suffuse/packing/pace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace suffuse::packing {
namespace {

constexpr std::int64_t most_steps = 3'000'000, most_swift_steps = 60'000;
constexpr std::int64_t most_relax_steps = 1500;
constexpr double relaxed_load = 0.1;    // share of the pressure that overlaps left by geometry may still cause
constexpr double surely_denser = 1.5;   // tolerances below the specified void ratio: no servo lets go of so much again
constexpr double crept_enough = 1e-2;   // unbalanced force at which fines that slide have found their places
constexpr double carrying_contacts = 1; // a grain: rattling fines have none, a skeleton of fines about three
constexpr double least_void_ratio = 0.05; // spheres overlap beyond any meaning before this

/// Removes what the preparation lent: friction goes to its final value, bonds are cut.
void take_final_parameters(dem::World& world, const grains::Material& final_material) {
    world.material = final_material;
    if (!adheres(final_material)) {
        std::fill(world.contacts.bonded.begin(), world.contacts.bonded.end(), std::uint8_t{0});
    }
}

/// What a user may do whose sample does not settle, in words; `usual` unless its grading is too wide for the protocol.
std::string_view other_way(const dem::World& world, const CompactSpec& spec, std::string_view usual) {
    constexpr double too_wide = 9; // largest over smallest grain: from here on samples of swift were seen to fail
    const auto [least, most] = std::ranges::minmax_element(world.grains.radius);
    const bool helps = spec.protocol != Protocol::Wide && *most > too_wide * *least;
    return helps ? "or use the wide protocol, which is intended for such gradings" : usual;
}

[[noreturn]] void report_out_of_reach(const dem::World& world, const CompactSpec& spec, const CompactState& state) {
    constexpr double carried = 0.98; // of the pressure: what is missing is rest
    if (dem::mean_stress(state.balance.stress) > carried * spec.pressure) {
        throw StateError(fmt::format(
            "the sample carries {:.4g} of {:.4g} kPa after {} steps, and its grains do not come to rest, unbalanced "
            "force {:.1e}: a higher pressure or softer grains press them together more, {}",
            dem::mean_stress(state.balance.stress) / 1e3, spec.pressure / 1e3, state.steps,
            state.balance.equilibrium.unbalanced_force,
            other_way(
                world, spec,
                spec.protocol == Protocol::Swift ? "and the faithful protocol lets them find their places"
                                                 : "or specify a less strict balance"
            )
        ));
    }
    throw StateError(fmt::format(
        "the pressure {:.4g} kPa is out of reach: after {} steps the sample carries {:.4g} kPa at the void ratio "
        "{:.3f}, unbalanced force {:.1e}; lower the pressure, take stiffer grains, {}",
        spec.pressure / 1e3, state.steps, dem::mean_stress(state.balance.stress) / 1e3, dem::void_ratio(world),
        state.balance.equilibrium.unbalanced_force,
        other_way(
            world, spec,
            spec.protocol == Protocol::Swift ? "start denser, or take the faithful protocol"
                                             : "or specify a less strict balance"
        )
    ));
}

/// A swift sample that proves its balance has carried the pressure: some fall in once more, as slowly as grains with
/// their own inertia do.
std::int64_t step_limit(const CompactSpec& spec, const CompactState& state) {
    const bool soon = spec.protocol == Protocol::Swift && state.phase != CompactState::Phase::Prove;
    return soon ? most_swift_steps : most_steps;
}

bool is_at_rest(const dem::World& world) {
    return std::ranges::all_of(world.grains.velocity, [](const Vec3& v) { return v == Vec3{}; });
}

/// Spares the steps in which a cloud at rest is a gas: no sample remembers them, unless its grains adhere.
void leave_out_gas(dem::World& world) {
    dem::World closer = world;
    if (bring_to_porosity(closer, open_porosity)) {
        world = std::move(closer);
    }
}

/// Brings the cloud to where the first step is made.
void go_to_start(dem::World& world, const CompactSpec& spec, CompactState& state) {
    const bool swift = spec.protocol == Protocol::Swift;
    const std::optional<double> start = spec.start_porosity;
    if (start) {
        const bool clear = bring_to_porosity(world, *start);
        if (!clear && !swift) {
            throw StateError(fmt::format(
                "a porosity of {:.3f} to start from is denser than grains can be pushed together without overlaps; "
                "give a larger one",
                *start
            ));
        }
        state.phase = clear ? CompactState::Phase::Compact : CompactState::Phase::Relax;
    } else if (swift) {
        bring_near_touching(world);
    } else if (spec.protocol != Protocol::Slow && !adheres(world.material) && is_at_rest(world) && dem::porosity(world) > open_porosity) {
        leave_out_gas(world);
    }
    state.start_porosity = dem::porosity(world);
}

/// The longest step of the network as it is.
void take_time_step(const dem::World& world, const CompactSpec& spec, CompactState& state) {
    dem::take_time_step(state, choose_time_step(world, spec, state.damping), state.balance.equilibrium.contacts);
}

/// Swift with a specified void ratio: whether the sample gave way further from its start than it should under what it
/// carries. Its friction has then been low for long enough.
bool gave_way(const dem::World& world, const CompactSpec& spec, const CompactState& state) {
    if (spec.protocol != Protocol::Swift || !spec.void_ratio || state.phase != CompactState::Phase::Compact) {
        return false;
    }
    const double carried = std::clamp(dem::mean_stress(state.balance.stress) / spec.pressure, 0.0, 1.0);
    return state.start_porosity - dem::porosity(world) >= carried * swift_settling;
}

/// Wide: whether grains slide more easily than they will, and so many that fines are among those that carry. Their
/// rearrangement goes on for most of the steps, and moves the void ratio by a thousandth.
bool creeps(const dem::World& world, const CompactState& state) {
    return world.material.friction < state.material.friction && !adheres(world.material) &&
           static_cast<double>(state.balance.equilibrium.contacts) >
               carrying_contacts * static_cast<double>(world.grains.size());
}

/// What a burst has to show for its phase to end.
dem::BalanceSpec
goal_of(const dem::World& world, const CompactSpec& spec, const dem::BalanceSpec& balance, const CompactState& state) {
    dem::BalanceSpec goal = balance;
    if (spec.protocol == Protocol::Swift && state.phase != CompactState::Phase::Prove) {
        goal.patience = dem::burst_steps; // patience is for the state that is handed on
        if (state.phase == CompactState::Phase::Compact) {
            goal.unbalanced_force =
                swift_calm(balance); // frictionless grains creep on for long: friction will hold them
        } else {
            goal.unbalanced_force = 0.5 * balance.unbalanced_force; // a burst now, four without drag
        }
    }
    if (spec.protocol == Protocol::Wide && state.phase == CompactState::Phase::Compact && creeps(world, state)) {
        goal.unbalanced_force = std::max(crept_enough, balance.unbalanced_force);
    }
    return goal;
}

/// The next phase, and what changes with it.
void go_on(dem::World& world, const CompactSpec& spec, CompactState& state) {
    using Phase = CompactState::Phase;
    state.balance.balanced_steps = 0;
    if (state.phase == Phase::Compact) {
        state.void_ratio_compacted = dem::void_ratio(world);
        take_final_parameters(world, state.material);
        take_time_step(world, spec, state); // springs that had nothing to do may act now
        state.phase = Phase::Settle;
        return;
    }
    const bool lent_some = state.lent != dem::Lent{};
    state.phase = state.phase == Phase::Settle && lent_some ? Phase::Prove : Phase::Done;
    if (state.phase == Phase::Done) {
        cell::hold_stress(dem::isotropic_stress(spec.pressure), world.servo);
    }
}

/// Frictionless relaxation of what geometry left: ends when little load is left, or when it has had its time.
void end_relaxation(dem::World& world, const CompactSpec& spec, CompactState& state) {
    const bool relaxed = dem::mean_stress(state.balance.stress) < relaxed_load * spec.pressure;
    if (relaxed || state.steps >= most_relax_steps) {
        world.material.friction = spec.prepare.friction.value_or(state.material.friction);
        take_time_step(world, spec, state);
        state.phase = CompactState::Phase::Compact;
    }
}

} // namespace

CompactState begin_settling(dem::World& world, double damping, dem::Mode mode) {
    CompactState state;
    state.phase = CompactState::Phase::Settle;
    state.material = world.material;
    state.damping = damping;
    state.mode = mode;
    state.median_diameter = grains::median_diameter(world.grains);
    state.start_porosity = dem::porosity(world);
    state.void_ratio_compacted = dem::void_ratio(world);
    return state;
}

CompactState begin_compaction(dem::World& world, const CompactSpec& spec, double damping, dem::Mode mode) {
    CompactState state = begin_settling(world, damping, mode);
    state.phase = CompactState::Phase::Compact;
    const Prepare& prepare = spec.prepare;
    world.material.friction = prepare.friction.value_or(world.material.friction);
    world.material.adhesion_normal = prepare.adhesion_normal.value_or(world.material.adhesion_normal);
    world.material.adhesion_shear = prepare.adhesion_shear.value_or(world.material.adhesion_shear);
    go_to_start(world, spec, state);
    if (state.phase == CompactState::Phase::Relax) {
        world.material.friction = 0;
    }
    return state;
}

bool misses_void_ratio(const dem::World& world, const CompactSpec& spec, const CompactState& state) {
    if (!spec.void_ratio) {
        return false;
    }
    using Phase = CompactState::Phase;
    const double off = dem::void_ratio(world) - *spec.void_ratio;
    const bool too_dense = spec.protocol == Protocol::Swift && state.phase == Phase::Settle &&
                           off < -surely_denser * spec.void_ratio_tolerance;
    const bool settled = state.phase == Phase::Prove && state.balance.balanced_steps == 0;
    return too_dense || (settled && std::abs(off) > spec.void_ratio_tolerance);
}

bool compact_burst(
    dem::World& world, dem::StepCaches& caches, const CompactSpec& spec, const dem::BalanceSpec& balance,
    CompactState& state
) {
    const dem::Lent lent = choose_lent(world, spec, state);
    if (lent != state.lent) {
        dem::lend_inertia(world, state.median_diameter, state.lent, lent);
        state.lent = lent;
        take_time_step(world, spec, state);
    } else {
        dem::renew_time_step(state, state.steps, state.balance.equilibrium.contacts, [&] {
            return choose_time_step(world, spec, state.damping);
        });
    }
    const Pace pace = choose_pace(world, spec, balance, state);
    const bool settled =
        dem::settle_burst(world, caches, pace.plan, goal_of(world, spec, balance, state), state.balance) &&
        !pace.holding;
    state.steps += dem::burst_steps;
    if (state.steps > step_limit(spec, state) || dem::void_ratio(world) < least_void_ratio) {
        report_out_of_reach(world, spec, state);
    }
    if (state.phase == CompactState::Phase::Relax) {
        end_relaxation(world, spec, state);
    } else if (settled || gave_way(world, spec, state)) {
        go_on(world, spec, state);
    }
    return state.phase == CompactState::Phase::Done;
}

void give_back(dem::World& world, const CompactState& state) {
    take_final_parameters(world, state.material);
    dem::lend_inertia(world, state.median_diameter, state.lent, {});
}

} // namespace suffuse::packing
