#include "suffuse/erosion/migration.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/quantile.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/erosion/grain_water.hpp"
#include "suffuse/erosion/rest_under_weight.hpp"
#include "suffuse/erosion/weighed_copy.hpp"
#include "suffuse/pores/widest_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::erosion {
namespace {

constexpr double departs = 0.5;           ///< from where it rested [diameters]
constexpr double moves = 0.1;             ///< within `still_for`: a grain that is on its way [diameters]
constexpr double old_share = 0.01;        ///< of the fines' mass that has moved since the flow was solved
constexpr double burst_travel = 0.1;      ///< of the median fine grain with the water, in a burst [diameters]
constexpr double load_quantile = 0.95;    ///< of the fines, which sets how soft contacts are
constexpr double nearly_whole = 1 - 1e-9; ///< of a time

double median_diameter(const grains::Grains& grains) {
    std::vector<double> diameter;
    for (std::size_t g = 0; g < grains.size(); ++g) {
        if (grains.fine[g] != 0) {
            diameter.push_back(2 * grains.radius[g]);
        }
    }
    return upper_quantile(std::move(diameter), 0.5);
}

void check(const dem::World& world, const MigrateSpec& spec) {
    if (!spec.gravity) {
        throw CaseError("migrate: fines that move need their weight; add [gravity] with down = \"-z\"");
    }
    const auto wrong = std::ranges::find_if(spec.gradients, [](double i) { return !(i > 0); });
    if (spec.gradients.empty() || wrong != spec.gradients.end()) {
        throw CaseError("gradients: expected at least one, all above 0: each is held until the fines come to rest");
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
    constexpr double tilted = 1e-6;
    const Vec3 along = spec.direction / norm(spec.direction);
    const int axis = pores::axis_along(h, spec.direction);
    const double length = std::abs(dot(h.column(axis), along));
    for (int other = 0; other < 3 && spec.exit; ++other) {
        if (other != axis && std::abs(dot(h.column(other), along)) > tilted * length) {
            throw StateError("exit: a plane across this flow cuts the periodic cell at an angle; take a direction that "
                             "two edges of the cell are perpendicular to, or leave `exit` out");
        }
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

/// Along the flow to the exit from `start` [m].
double distance_to_exit(const Vec3& start, const MigrateSpec& spec, double length) {
    if (!spec.exit) {
        return length;
    }
    const double ahead = std::fmod(*spec.exit - dot(start, spec.direction) / norm(spec.direction), length);
    return ahead > 0 ? ahead : ahead + length;
}

/// Factor between a hydraulic gradient under this gravity and one of the flow's, which is of standard gravity.
double strength(const MigrateSpec& spec) {
    return spec.gravity->acceleration / suffuse::gravity;
}

/// How many times its weight presses a fine grain at the highest gradient, where 95 % of them are pressed by less.
double load_over_weight(
    const dem::World& world, const std::vector<Vec3>& weight, const GrainWater& water, const MigrateSpec& spec
) {
    const double gradient = *std::ranges::max_element(spec.gradients) * strength(spec);
    std::vector<double> ratio;
    for (std::uint32_t g = 0; g < world.grains.size(); ++g) {
        if (world.grains.fine[g] != 0) {
            ratio.push_back(norm(weight[g] + gradient * water.force(g)) / norm(weight[g]));
        }
    }
    return std::max(1.0, quantile(std::move(ratio), load_quantile));
}

/// Fines that are still there, by their number p in a copy: their rows of the ledger.
std::vector<std::size_t> find_present(const MigrationLedger& ledger) {
    std::vector<std::size_t> present;
    for (std::size_t k = 0; k < ledger.size(); ++k) {
        if (ledger.where[k] != Whereabouts::Eroded) {
            present.push_back(k);
        }
    }
    return present;
}

/// A row a grain of the world: 1 where it goes with the water.
std::vector<std::uint8_t> flags_of_rows(const dem::World& world, const MigrationLedger& ledger) {
    std::vector<std::uint8_t> goes(world.grains.size(), 0);
    const std::vector<std::size_t> present = find_present(ledger);
    for (std::size_t g = 0, p = 0; g < goes.size(); ++g) {
        if (world.grains.fine[g] != 0) {
            goes[g] = ledger.goes[present[p++]];
        }
    }
    return goes;
}

/// Of contacts of grains that move, over the smaller radius [-].
double largest_overlap(const dem::World& world) {
    const grains::Grains& grains = world.grains;
    double largest = 0;
    for (const dem::ContactView& contact : dem::inspect_contacts(world)) {
        if (grains.motion[contact.i] == grains::Motion::Free || grains.motion[contact.j] == grains::Motion::Free) {
            const double smaller = std::min(grains.radius[contact.i], grains.radius[contact.j]);
            largest = std::max(largest, contact.overlap / smaller);
        }
    }
    return largest;
}

/// What moves from one solution of the flow to the next; on copies, so that it may be stopped.
class Leg {
public:
    Leg(const Migration& before, const MigrateSpec& spec, const MigrationSurroundings& around)
        : spec_(spec), pulse_([&around, steps = before.steps](std::string_view part, long long more) {
              beat(around.pulse, part, steps + more);
          }),
          ledger_(before.ledger), present_(find_present(ledger_)),
          water_(before.world, flags_of_rows(before.world, ledger_), spec.direction, around.fluid),
          copy_(before.world, before.scale, buoyant_weights(before.world, *spec.gravity, around.fluid)),
          start_(copy_.positions()), to_true_(std::sqrt(before.scale.factor)),
          pull_(before.result.holds.back().gradient * strength(spec)), force_(before.world.grains.size()),
          rate_(before.world.grains.size()) {
        const double specific = around.fluid.density * suffuse::gravity * pull_; // [Pa/m]
        const double flow = specific * water_.permeability() / around.fluid.viscosity;
        power_ = specific * flow * cell::volume(before.world.cell);
        for (std::uint32_t g = 0; g < rate_.size(); ++g) {
            rate_[g] = water_.rate(g);
        }
        const std::size_t any = copy_.fines().front();
        const double d = median_diameter(before.world.grains);
        const double sinking =
            norm(copy_.weight(copy_.fines().front())) / before.world.grains.mass[any] /
            (water_.hindrance() *
             stokes_rate(d, before.world.material.density * sphere_volume(d / 2), around.fluid.viscosity));
        burst_time_ = burst_travel * d / (flow / dem::porosity(before.world) + sinking);
    }

    /// Moves until the flow is old, for at most `most` of true time [s].
    void go(double time, double most) {
        const double begin = copy_.world().clock.time;
        do {
            burst(std::min(burst_time_, most - took_));
            took_ = (copy_.world().clock.time - begin) * to_true_;
            note_travel(time + took_);
        } while (took_ < most * nearly_whole && !is_flow_old());
        for (std::size_t p = 0; p < present_.size(); ++p) {
            ledger_.goes[present_[p]] = goes_now(p) ? 1 : 0;
        }
    }

    /// Enters what has happened.
    void enter(Migration& migration) {
        migration.time += took_;
        migration.energy += power_ * took_;
        migration.steps += copy_.steps();
        migration.time_step = copy_.time_step() * to_true_;
        migration.hindrance = water_.hindrance();
        migration.result.holds.back().held_for += took_;
        migration.result.holds.back().permeability = water_.permeability();
        note_whereabouts();
        migration.ledger = ledger_;
        MigrationRow row{
            .time = migration.time,
            .gradient = migration.result.holds.back().gradient,
            .permeability = water_.permeability(),
            .eroded_mass = eroded_mass(ledger_),
            .energy = migration.energy};
        for (std::size_t k = 0; k < ledger_.size(); ++k) {
            row.moving_mass += ledger_.where[k] == Whereabouts::Moving ? ledger_.mass[k] : 0;
            row.lodged_mass += ledger_.where[k] == Whereabouts::Lodged ? ledger_.mass[k] : 0;
        }
        migration.result.rows.push_back(row);
        migration.world = copy_.whole();
        migration.largest_overlap = std::max(migration.largest_overlap, largest_overlap(migration.world));
        std::vector<std::uint32_t> eroded;
        for (std::size_t p = 0; p < present_.size(); ++p) {
            if (ledger_.where[present_[p]] == Whereabouts::Eroded) {
                eroded.push_back(copy_.fines()[p]);
            }
        }
        if (!eroded.empty()) {
            dem::remove_grains(migration.world, eroded);
        }
    }

private:
    [[nodiscard]] double diameter(std::size_t p) const { return ledger_.diameter[present_[p]]; }

    [[nodiscard]] bool goes(std::size_t p) const { return ledger_.goes[present_[p]] != 0; }

    [[nodiscard]] bool has_moved(std::size_t p) const {
        return norm(copy_.position(p) - start_[p]) > spec_.solve_after * diameter(p);
    }

    /// Velocity of the water at a grain [m/s]: where it stands, that which does not push it; where it has moved, or
    /// goes with the water, that in the pore where it is.
    [[nodiscard]] Vec3 water_at(std::size_t p) const {
        const bool stands = !goes(p) && !has_moved(p);
        return pull_ * (stands ? water_.velocity(copy_.fines()[p]) : water_.velocity_at(copy_.position(p)));
    }

    /// Whether a grain goes with the water: it begins to where it is nearly as quick, and ceases where it comes to
    /// rest, at half the speed.
    [[nodiscard]] bool goes_now(std::size_t p) const {
        const Vec3 water = water_at(p), own = copy_.world().grains.velocity[copy_.fines()[p]] / to_true_;
        return goes(p) ? norm(own) > 0.5 * (1 - spec_.with_water) * norm(water)
                       : !copy_.bears_load(p) && norm(own - water) < spec_.with_water * norm(water);
    }

    /// For a true time [s].
    void burst(double time) {
        for (std::size_t p = 0; p < present_.size(); ++p) {
            const std::uint32_t g = copy_.fines()[p];
            force_[g] = copy_.world().grains.mass[g] * rate_[g] * water_at(p);
        }
        copy_.immerse(force_, rate_);
        copy_.hold(time / copy_.true_time(), pulse_, "migrate");
    }

    void note_travel(double time) {
        const Vec3 along = spec_.direction / norm(spec_.direction);
        for (std::size_t p = 0; p < present_.size(); ++p) {
            const std::size_t k = present_[p];
            const Vec3 way = copy_.position(p) - ledger_.start[k];
            if (ledger_.departed[k] < 0 && norm(way) > departs * diameter(p)) {
                ledger_.departed[k] = time;
                ledger_.departed_at[k] = pull_ / strength(spec_);
            }
            if (ledger_.left[k] < 0 && dot(way, along) >= ledger_.to_exit[k]) {
                ledger_.left[k] = time;
            }
        }
    }

    [[nodiscard]] bool is_flow_old() const {
        double old = 0, all = 0;
        for (std::size_t p = 0; p < present_.size(); ++p) {
            const std::size_t k = present_[p];
            all += ledger_.mass[k];
            old += has_moved(p) || goes_now(p) != goes(p) ? ledger_.mass[k] : 0;
        }
        return old > old_share * all;
    }

    void note_whereabouts() {
        for (std::size_t p = 0; p < present_.size(); ++p) {
            const std::size_t k = present_[p];
            ledger_.end[k] = copy_.position(p);
            const double speed = norm(copy_.position(p) - start_[p]) / took_;
            ledger_.where[k] = copy_.bears_load(p)                                               ? Whereabouts::Fixed
                               : ledger_.left[k] >= 0                                            ? Whereabouts::Eroded
                               : speed > moves * diameter(p) / spec_.still_for                   ? Whereabouts::Moving
                               : norm(ledger_.end[k] - ledger_.start[k]) > departs * diameter(p) ? Whereabouts::Lodged
                                                                                                 : Whereabouts::Stayed;
        }
    }

    const MigrateSpec& spec_;
    Pulse pulse_; ///< with the steps of all legs
    MigrationLedger ledger_;
    std::vector<std::size_t> present_;
    GrainWater water_;
    WeighedCopy copy_;
    std::vector<Vec3> start_;          ///< fines where the flow was solved [m]
    double to_true_;                   ///< time of the copy to true time [-]
    double pull_;                      ///< the gradient, for a flow of standard gravity [-]
    double power_ = 0;                 ///< of the flow [W]
    double burst_time_ = 0, took_ = 0; ///< true [s]
    std::vector<Vec3> force_;          ///< of the water on grains at rest [N]
    std::vector<double> rate_;         ///< [1/s]
};

/// Of the fines' mass, what went further than a rest allows since motion was last looked at; from now on that is now.
double look_at_motion(Migration& migration) {
    MigrationLedger& ledger = migration.ledger;
    double moving = 0;
    for (std::size_t k = 0; k < ledger.size(); ++k) {
        const bool is_there = ledger.where[k] != Whereabouts::Eroded;
        moving += is_there && norm(ledger.end[k] - ledger.before[k]) > moves * ledger.diameter[k] ? ledger.mass[k] : 0;
        ledger.before[k] = ledger.end[k];
    }
    migration.looked = migration.time;
    return moving / migration.result.fines_mass;
}

/// Ends the gradient where its fines rest, or a budget is spent, and begins the next.
void end_hold(Migration& migration, const MigrateSpec& spec) {
    MigrationHold& hold = migration.result.holds.back();
    hold.moving_mass_share = look_at_motion(migration);
    hold.eroded_mass_share = eroded_mass(migration.ledger) / migration.result.fines_mass;
    hold.ended = hold.moving_mass_share <= spec.still;
    const bool is_spent = (spec.time_at_most && migration.time >= *spec.time_at_most * nearly_whole) ||
                          (spec.steps_at_most && migration.steps >= *spec.steps_at_most);
    const bool all_left = std::ranges::all_of(migration.ledger.where, [](Whereabouts where) {
        return where == Whereabouts::Eroded || where == Whereabouts::Fixed;
    });
    const bool is_over = hold.ended || hold.held_for >= spec.hold_at_most * nearly_whole;
    if (is_spent || all_left || (is_over && migration.result.holds.size() == spec.gradients.size())) {
        migration.over = true;
    } else if (is_over) {
        migration.result.holds.push_back({.gradient = spec.gradients[migration.result.holds.size()]});
    }
}

} // namespace

double eroded_mass(const MigrationLedger& ledger) {
    double mass = 0;
    for (std::size_t k = 0; k < ledger.size(); ++k) {
        mass += ledger.where[k] == Whereabouts::Eroded ? ledger.mass[k] : 0;
    }
    return mass;
}

double mass_share(const MigrationLedger& ledger, Whereabouts where) {
    double some = 0, all = 0;
    for (std::size_t k = 0; k < ledger.size(); ++k) {
        all += ledger.mass[k];
        some += ledger.where[k] == where ? ledger.mass[k] : 0;
    }
    return all > 0 ? some / all : 0;
}

Migration begin_migration(const dem::World& sample, const MigrateSpec& spec, const MigrationSurroundings& around) {
    check(sample, spec);
    Migration migration;
    const double length = length_along(sample.cell.h, spec);
    dem::World sorted = sample;
    dem::sort_along_curve(sorted);
    const std::vector<Vec3> weight = buoyant_weights(sorted, *spec.gravity, around.fluid);
    const GrainWater water(sorted, std::vector<std::uint8_t>(sorted.grains.size()), spec.direction, around.fluid);
    WeighedCopy copy(sorted, weight, {.softness = spec.softness}, load_over_weight(sorted, weight, water, spec));
    migration.rested = rest_under_weight(copy, around.pulse).ended;
    migration.steps = copy.steps();
    migration.scale = copy.scale();
    migration.world = copy.whole();
    MigrationLedger& ledger = migration.ledger;
    for (std::size_t p = 0; p < copy.fines().size(); ++p) {
        const std::uint32_t g = copy.fines()[p];
        ledger.id.push_back(sorted.grains.id[g]);
        ledger.diameter.push_back(2 * sorted.grains.radius[g]);
        ledger.mass.push_back(sorted.grains.mass[g]);
        ledger.start.push_back(copy.position(p));
        ledger.to_exit.push_back(distance_to_exit(copy.position(p), spec, length));
        ledger.where.push_back(copy.bears_load(p) ? Whereabouts::Fixed : Whereabouts::Stayed);
        migration.result.fines_mass += sorted.grains.mass[g];
    }
    for (const double mass : sorted.grains.mass) {
        migration.solids_mass += mass;
    }
    ledger.end = ledger.before = ledger.start;
    ledger.departed.assign(ledger.size(), -1);
    ledger.departed_at.assign(ledger.size(), 0);
    ledger.left.assign(ledger.size(), -1);
    ledger.goes.assign(ledger.size(), 0);
    migration.result.holds.push_back({.gradient = spec.gradients.front()});
    return migration;
}

void migrate_on(Migration& migration, const MigrateSpec& spec, const MigrationSurroundings& around) {
    expects(!migration.over, "a migration that is over does not go on");
    Leg leg(migration, spec, around);
    const double left = migration.looked + spec.still_for - migration.time;
    leg.go(migration.time, left);
    leg.enter(migration);
    const bool none_left = find_present(migration.ledger).empty();
    if (none_left || migration.time >= (migration.looked + spec.still_for) * nearly_whole) {
        end_hold(migration, spec);
    }
}

dem::World migrated_sample(const Migration& migration, const Pulse& pulse) {
    constexpr double pushed_apart = 10; // in units of WeightScale::time
    WeighedCopy weightless(migration.world, migration.scale, std::vector<Vec3>(migration.world.grains.size()));
    weightless.load({}, 0);
    weightless.hold(pushed_apart, pulse, "unload");
    dem::World sample = weightless.whole();
    for (std::size_t g = 0; g < sample.grains.size(); ++g) {
        sample.grains.velocity[g] = sample.grains.spin[g] = {};
        sample.grains.motion[g] = grains::Motion::Free;
    }
    return sample;
}

} // namespace suffuse::erosion
