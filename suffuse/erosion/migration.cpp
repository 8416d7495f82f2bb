#include "suffuse/erosion/migration.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/quantile.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/erosion/base_profile.hpp"
#include "suffuse/erosion/filter_view.hpp"
#include "suffuse/erosion/migration_leg.hpp"
#include "suffuse/erosion/planes_across.hpp"
#include "suffuse/erosion/reequilibrate.hpp"
#include "suffuse/erosion/rest_under_weight.hpp"
#include "suffuse/erosion/sample_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::erosion {
namespace {

constexpr double load_quantile = 0.95; ///< of the fines, which sets how soft contacts are

void check(const dem::World& world, const MigrateSpec& spec) {
    if (!spec.gravity) {
        throw CaseError("migrate: fines that move need their weight; add [gravity] with down = \"-z\"");
    }
    const auto wrong = std::ranges::find_if(spec.gradients, [](double i) { return !(i > 0); });
    if (spec.gradients.empty() || wrong != spec.gradients.end()) {
        throw CaseError("gradients: expected at least one, all above 0: each is held until the fines come to rest");
    }
    if (spec.feed && spec.stack) {
        throw CaseError(
            "feed: no grains enter a stack, whose base is held at the face where the water enters; leave it "
            "out"
        );
    }
    const double length = norm(spec.direction);
    if (!(length > 0) || !std::isfinite(length)) {
        throw CaseError("direction: expected three numbers that are finite and not all zero: where the water goes");
    }
    for (const std::uint8_t kind : {std::uint8_t{0}, std::uint8_t{1}}) {
        if (std::ranges::count(world.grains.fine, kind) == 0) {
            throw StateError(fmt::format(
                "{} grain is fine: fines migrate through a skeleton of coarse grains; define them by `fines` of the "
                "soil",
                kind == 0 ? "every" : "no"
            ));
        }
    }
}

/// The period of the cell along the flow [m]. @throws where a plane across the flow is none of the cell's
double length_along(const Mat3& h, const MigrateSpec& spec) {
    const double length = period_along(h, spec.direction);
    if (spec.exit && !has_planes_across(h, spec.direction)) {
        throw StateError("exit: a plane across this flow cuts the periodic cell at an angle; take a direction that "
                         "two edges of the cell are perpendicular to, or leave `exit` out");
    }
    if (spec.exit && !(*spec.exit > 0 && *spec.exit <= length)) {
        throw StateError(fmt::format(
            "exit: {:.4g} m lies outside the cell, which is {:.4g} m long along the flow; take a distance from where "
            "the water enters it, above 0 and up to that length",
            *spec.exit, length
        ));
    }
    return length;
}

/// The plane by which base grains leave [m].
double exit_of(const Stack& stack, const MigrateSpec& spec) {
    const double exit = spec.exit.value_or(stack.length - stack.filter_grain);
    if (exit <= stack.base_thickness()) {
        throw StateError(fmt::format(
            "exit: {:.4g} m after the water enters the base the base has not ended, which is {:.4g} m thick; take "
            "more, or leave `exit` out: base grains leave at the end of the filter",
            exit, stack.base_thickness()
        ));
    }
    return stack.face + exit;
}

/// Along the flow to the exit from `start` [m].
double distance_to_exit(const Vec3& start, const MigrateSpec& spec, double length, const Stack& stack) {
    if (stack.is_stack()) {
        return stack.exit - stack.place(dot(start, spec.direction) / norm(spec.direction));
    }
    if (!spec.exit) {
        return length;
    }
    const double ahead = std::fmod(*spec.exit - dot(start, spec.direction) / norm(spec.direction), length);
    return ahead > 0 ? ahead : ahead + length;
}

/// @param base_share gradient of the base over that of the sample
/// How many times its weight presses a fine grain at the highest gradient, where 95 % of them are pressed by less.
double load_over_weight(
    const dem::World& world, const std::vector<Vec3>& weight, const GrainWater& water, const MigrateSpec& spec,
    double base_share
) {
    const double gradient = *std::ranges::max_element(spec.gradients) / base_share * strength(spec);
    std::vector<double> ratio;
    for (std::uint32_t g = 0; g < world.grains.size(); ++g) {
        if (world.grains.fine[g] != 0) {
            ratio.push_back(norm(weight[g] + gradient * water.force(g)) / norm(weight[g]));
        }
    }
    return std::max(1.0, quantile(std::move(ratio), load_quantile));
}

/// Whether motion was last looked at so long ago that it differs from rest.
bool can_look(const Migration& migration, const MigrateSpec& spec) {
    return migration.time >= (migration.looked + spec.still_for) * nearly_whole;
}

/// Of the fines' mass, what went further than a rest allows since motion was last looked at; from now on that is now.
double look_at_motion(Migration& migration, const MigrateSpec& spec) {
    MigrationLedger& ledger = migration.ledger;
    const double part = can_look(migration, spec) ? 1 : (migration.time - migration.looked) / spec.still_for;
    double moving = 0;
    for (std::size_t k = 0; k < ledger.size(); ++k) {
        const bool is_there = ledger.where[k] != Whereabouts::Eroded;
        const double travel = norm(ledger.end[k] - ledger.before[k]);
        moving += is_there && travel > part * moves * ledger.diameter[k] ? ledger.mass[k] : 0;
        ledger.before[k] = ledger.end[k];
    }
    migration.looked = migration.time;
    return moving / migration.result.fines_mass;
}

void stop(grains::Grains& grains) {
    grains.velocity.assign(grains.size(), {});
    grains.spin.assign(grains.size(), {});
}

void bring_to_rest(dem::World& world, grains::Motion motion) {
    stop(world.grains);
    world.grains.motion.assign(world.grains.size(), motion);
}

/// On each grain; a step leaves none on grains that are held.
void sum_contact_forces(dem::World& world) {
    std::vector<Vec3>& force = world.grains.force;
    force.assign(world.grains.size(), {});
    for (const dem::ContactView& contact : dem::inspect_contacts(world)) {
        const Vec3 on_first = contact.normal_force + contact.shear_force;
        force[contact.i] += on_first;
        force[contact.j] -= on_first;
    }
}

/// Gives the fines of a weightless sample their weight, and lets them come to rest on a skeleton that is held.
WeighedCopy rest_fines(Migration& migration, dem::World sample, const MigrateSpec& spec, const Surroundings& around) {
    sample.material.friction = spec.friction.value_or(sample.material.friction);
    const grains::Grains& grains = sample.grains;
    const std::vector<Vec3> weight = buoyant_weights(sample, *spec.gravity, around.fluid);
    migration.coarse_permeability =
        flow::coarse_permeability(
            sample.cell, grains.position, grains.radius, grains.fine, spec.direction, around.fluid
        )
            .value_or(0);
    const GrainWater water(
        sample, std::vector<std::uint8_t>(grains.size()), spec.direction, around.fluid, migration.coarse_permeability
    );
    migration.hindrance = water.hindrance();
    std::vector<std::uint8_t> held;
    if (migration.stack.is_stack()) {
        migration.at_first = migration.now =
            layer_heads(water.seepage(), grains, water.forces(), migration.stack, spec.direction);
        held = held_in_stack(sample, migration.stack, spec.direction);
    }
    const double load = load_over_weight(sample, weight, water, spec, migration.at_first.base);
    WeighedCopy copy(sample, weight, {.softness = spec.softness}, load, held);
    const Pulse pulse = [&around, before = migration.steps](std::string_view part, long long steps) {
        beat(around.pulse, part, before + steps);
    };
    if (!migration.stack.is_stack()) { // a base rests where it was compacted
        migration.rested = rest_under_weight(copy, pulse).ended && migration.rested;
    }
    migration.steps += copy.steps();
    migration.scale = copy.scale();
    migration.world = copy.whole();
    return copy;
}

/// The skeleton finds its new equilibrium under the stresses of the sample before, and the fines come to rest on it.
/// What they travel does not count that.
void settle_skeleton(Migration& migration, const MigrateSpec& spec, const Surroundings& around) {
    Migration next = migration;
    dem::World sample = migrated_sample(migration, around.pulse);
    ErosionResult before;
    before.initial_mass = migration.solids_mass;
    PassResult pass;
    pass.stress_before = migration.stress;
    Resettlement so_far;
    reequilibrate(sample, {}, before, around, pass, so_far);
    next.steps += pass.steps;
    MigrationHold& hold = next.result.holds.back();
    hold.porosity = pass.porosity_after;
    hold.volumetric_strain = pass.volumetric_strain;
    hold.stress_kept = dem::mean_stress(pass.stress_constant_volume) / dem::mean_stress(migration.stress);
    hold.failed = pass.failed;
    MigrationLedger& ledger = next.ledger;
    const std::vector<std::size_t> present = find_present(ledger);
    if (present.empty()) {
        bring_to_rest(sample, grains::Motion::Held);
        next.world = sample;
    } else {
        const WeighedCopy copy = rest_fines(next, std::move(sample), spec, around);
        for (std::size_t p = 0; p < present.size(); ++p) {
            const std::size_t k = present[p];
            ledger.start[k] += copy.position(p) - ledger.end[k];
            ledger.end[k] = ledger.before[k] = copy.position(p);
            ledger.goes[k] = 0;
            ledger.passed[k].last = PassedThroats::never; // throats are numbered anew
        }
    }
    next.settles = false;
    next.pores.reset();
    migration = std::move(next);
}

/// What ends the hold, whatever moves; None while nothing does.
HoldEnd find_end(const Migration& migration, const MigrateSpec& spec) {
    const bool all_left = std::ranges::all_of(migration.ledger.where, [](Whereabouts where) {
        return where == Whereabouts::Eroded || where == Whereabouts::Fixed;
    });
    return all_left && !spec.feed                                                       ? HoldEnd::AllLeft
           : spec.time_at_most && migration.time >= *spec.time_at_most * nearly_whole   ? HoldEnd::TimeLimit
           : spec.steps_at_most && migration.steps >= *spec.steps_at_most               ? HoldEnd::StepLimit
           : migration.result.holds.back().held_for >= spec.hold_at_most * nearly_whole ? HoldEnd::HoldLimit
                                                                                        : HoldEnd::None;
}

/// Until motion is looked at, or a limit ends the hold. A limit that is due a little before the look waits for it [s].
double longest_leg(const Migration& migration, const MigrateSpec& spec) {
    constexpr double soon = 0.1; // of `still_for`: steps go a little beyond each look
    const double look = migration.looked + spec.still_for - migration.time;
    const double hold = spec.hold_at_most - migration.result.holds.back().held_for;
    const double limit = spec.time_at_most ? std::min(hold, *spec.time_at_most - migration.time) : hold;
    return limit < look - soon * spec.still_for ? limit : look;
}

/// Adds to the profile of one soil what its slices are now, in the flow among the grains that stand.
void note_slices(Migration& migration, const MigrateSpec& spec, const Surroundings& around) {
    if (migration.result.sample.slices > 0) {
        const GrainWater water(
            migration.world, goes_by_row(migration.world, migration.ledger), spec.direction, around.fluid,
            migration.coarse_permeability
        );
        note_sample_profile(migration.world, water.seepage(), spec.direction, migration.result.sample);
    }
}

/// Looks whether the fines rest, which they do not while the water brings more. @param end what else ends the hold
/// @return whether the hold is over
bool end_hold(Migration& migration, const MigrateSpec& spec, const Surroundings& around, HoldEnd end) {
    MigrationHold& hold = migration.result.holds.back();
    const bool can_rest = can_look(migration, spec) && !spec.feed;
    hold.moving_mass_share = look_at_motion(migration, spec);
    hold.eroded_mass_share = eroded_mass(migration.ledger) / migration.result.fines_mass;
    hold.porosity = dem::porosity(migration.world);
    const bool rests = can_rest && hold.moving_mass_share <= spec.still && end != HoldEnd::AllLeft;
    hold.ended_by = rests ? HoldEnd::Rest : end;
    hold.ended = rests || end == HoldEnd::AllLeft;
    const bool is_over = hold.ended_by != HoldEnd::None;
    if (is_over && migration.stack.is_stack()) {
        note_profile(
            migration.ledger, migration.world, migration.stack, spec.direction, migration.result.profile, hold
        );
        look_again(migration.ledger, migration.world, migration.stack, spec.direction, migration.result.filter);
    } else if (is_over) {
        note_slices(migration, spec, around);
    }
    return is_over;
}

void begin_next_hold(Migration& migration, const MigrateSpec& spec) {
    std::vector<MigrationHold>& holds = migration.result.holds;
    const HoldEnd end = find_end(migration, spec);
    const bool is_cut = end == HoldEnd::TimeLimit || end == HoldEnd::StepLimit;
    migration.over = holds.back().failed || end == HoldEnd::AllLeft || is_cut || holds.size() == spec.gradients.size();
    migration.cut_by = is_cut && holds.size() < spec.gradients.size() ? end : HoldEnd::None;
    if (!migration.over) {
        holds.push_back({.gradient = spec.gradients[holds.size()]});
    }
}

} // namespace

double mass_of(const MigrationLedger& ledger, Whereabouts where) {
    double mass = 0;
    for (std::size_t k = 0; k < ledger.size(); ++k) {
        mass += ledger.where[k] == where ? ledger.mass[k] : 0;
    }
    return mass;
}

double eroded_mass(const MigrationLedger& ledger) {
    return mass_of(ledger, Whereabouts::Eroded);
}

double own_eroded_mass(const MigrationLedger& ledger) {
    double mass = 0;
    for (std::size_t k = 0; k < ledger.size(); ++k) {
        mass += ledger.where[k] == Whereabouts::Eroded && ledger.entered[k] < 0 ? ledger.mass[k] : 0;
    }
    return mass;
}

double share_of_own(const MigrationResult& result) {
    const double fed = result.rows.empty() ? 0 : result.rows.back().fed_mass;
    return result.fines_mass / (result.fines_mass + fed);
}

Migration begin_migration(const dem::World& sample, const MigrateSpec& spec, const Surroundings& around) {
    check(sample, spec);
    Migration migration;
    const double length = length_along(sample.cell.h, spec);
    dem::World sorted = sample;
    dem::sort_along_curve(sorted);
    migration.stress = dem::mean_stress_tensor(sorted);
    migration.friction = sample.material.friction;
    if (spec.stack) {
        migration.stack = find_layers(sorted, spec.direction);
        migration.stack.exit = exit_of(migration.stack, spec);
    }
    if (spec.skeleton == Skeleton::Moves && !(dem::mean_stress(migration.stress) > 0)) {
        throw StateError("skeleton = \"moves\": the sample carries no stress that its skeleton could keep; compact it "
                         "first, or take \"held\"");
    }
    const WeighedCopy copy = rest_fines(migration, sorted, spec, around);
    MigrationLedger& ledger = migration.ledger;
    for (std::size_t p = 0; p < copy.fines().size(); ++p) {
        const std::uint32_t g = copy.fines()[p];
        ledger.id.push_back(sorted.grains.id[g]);
        ledger.diameter.push_back(2 * sorted.grains.radius[g]);
        ledger.mass.push_back(sorted.grains.mass[g]);
        ledger.start.push_back(copy.position(p));
        ledger.to_exit.push_back(distance_to_exit(copy.position(p), spec, length, migration.stack));
        ledger.where.push_back(copy.bears_load(p) ? Whereabouts::Fixed : Whereabouts::Stayed);
        const bool is_screen = spec.stack && ledger.where.back() == Whereabouts::Fixed;
        migration.result.fines_mass += is_screen ? 0 : sorted.grains.mass[g];
    }
    for (const double mass : sorted.grains.mass) {
        migration.solids_mass += mass;
    }
    ledger.end = ledger.before = ledger.start;
    ledger.entered.assign(ledger.size(), -1);
    ledger.departed.assign(ledger.size(), -1);
    ledger.departed_at.assign(ledger.size(), 0);
    ledger.left.assign(ledger.size(), -1);
    ledger.goes.assign(ledger.size(), 0);
    ledger.passed.resize(ledger.size());
    if (spec.stack) {
        MigrationHold none;
        migration.result.profile = begin_profile(sorted, migration.stack, spec.direction);
        note_profile(ledger, sorted, migration.stack, spec.direction, migration.result.profile, none);
        migration.result.filter = view_filter(sorted, migration.stack, spec.direction, spec.base_gap);
    } else {
        migration.result.sample = begin_sample_profile(sorted, spec.direction);
        note_slices(migration, spec, around);
    }
    migration.result.holds.push_back({.gradient = spec.gradients.front()});
    return migration;
}

void migrate_on(Migration& migration, const MigrateSpec& spec, const Surroundings& around) {
    expects(!migration.over, "a migration that is over does not go on");
    if (migration.settles) {
        settle_skeleton(migration, spec, around);
        return begin_next_hold(migration, spec);
    }
    if (!migration.pores) {
        migration.pores = std::make_shared<const CoarsePores>(migration.world);
    }
    Leg leg(migration, spec, around);
    leg.go(migration.time, longest_leg(migration, spec));
    leg.enter(migration);
    if (spec.feed) {
        migration.fed_mass +=
            feed_fines(migration.world, migration.ledger, migration.feeding, spec, leg.water(), migration.time);
        migration.result.rows.back().fed_mass = migration.fed_mass;
    }
    const HoldEnd end = find_end(migration, spec);
    if ((end != HoldEnd::None || can_look(migration, spec)) && end_hold(migration, spec, around, end)) {
        migration.settles = spec.skeleton == Skeleton::Moves;
        if (!migration.settles) {
            begin_next_hold(migration, spec);
        }
    }
}

dem::World migrated_sample(const Migration& migration, const Pulse& pulse) {
    constexpr double burst = 2, longest = 40; // in units of WeightScale::time
    constexpr double still = 1e-3;            // in a burst [diameters]
    dem::World smooth = migration.world;
    smooth.material.friction = 0;
    stop(smooth.grains);
    WeighedCopy weightless(std::move(smooth), migration.scale, std::vector<Vec3>(migration.world.grains.size()));
    double travel = 1;
    for (double took = 0; travel > still && took < longest; took += burst) {
        const std::vector<Vec3> before = weightless.positions();
        weightless.load({}, 0); // all are awake
        weightless.brake();
        weightless.hold(burst, pulse, "unload");
        travel = 0;
        for (std::size_t p = 0; p < before.size(); ++p) {
            const double diameter = 2 * weightless.world().grains.radius[weightless.fines()[p]];
            travel = std::max(travel, norm(weightless.position(p) - before[p]) / diameter);
        }
    }
    dem::World sample = weightless.whole();
    sample.material.friction = migration.friction;
    bring_to_rest(sample, grains::Motion::Free);
    sum_contact_forces(sample);
    return sample;
}

} // namespace suffuse::erosion
