#include "suffuse/erosion/migration_leg.hpp"

#include "suffuse/base/parallel.hpp"
#include "suffuse/base/quantile.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/erosion/planes_across.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::erosion {
namespace {

constexpr double old_share = 0.01;   ///< of the fines' mass that has moved since the flow was solved
constexpr double burst_travel = 0.1; ///< of the median fine grain with the water, in a burst [diameters]

double median_diameter(const grains::Grains& grains) {
    std::vector<double> diameter;
    for (std::size_t g = 0; g < grains.size(); ++g) {
        if (grains.fine[g] != 0) {
            diameter.push_back(2 * grains.radius[g]);
        }
    }
    return upper_quantile(std::move(diameter), 0.5);
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

} // namespace

std::vector<std::size_t> find_present(const MigrationLedger& ledger) {
    std::vector<std::size_t> present;
    for (std::size_t k = 0; k < ledger.size(); ++k) {
        if (ledger.where[k] != Whereabouts::Eroded) {
            present.push_back(k);
        }
    }
    return present;
}

std::vector<std::uint8_t> goes_by_row(const dem::World& world, const MigrationLedger& ledger) {
    std::vector<std::uint8_t> goes(world.grains.size(), 0);
    const std::vector<std::size_t> present = find_present(ledger);
    for (std::size_t g = 0, p = 0; g < goes.size(); ++g) {
        if (world.grains.fine[g] != 0) {
            goes[g] = ledger.goes[present[p++]];
        }
    }
    return goes;
}

double strength(const MigrateSpec& spec) {
    return spec.gravity->acceleration / suffuse::gravity;
}

Leg::Leg(const Migration& before, const MigrateSpec& spec, const Surroundings& around)
    : spec_(spec), pulse_([&around, steps = before.steps](std::string_view part, long long more) {
          beat(around.pulse, part, steps + more);
      }),
      ledger_(before.ledger), present_(find_present(ledger_)),
      water_(
          before.world, goes_by_row(before.world, ledger_), spec.direction, around.fluid, before.coarse_permeability,
          before.hindrance
      ),
      copy_(before.world, before.scale, buoyant_weights(before.world, *spec.gravity, around.fluid)),
      throats_(before.pores, copy_.positions()), start_(copy_.positions()), to_true_(std::sqrt(before.scale.factor)),
      gradient_(before.result.holds.back().gradient), stack_(before.stack),
      pull_(gradient_ / before.at_first.base * strength(spec)),
      most_steps_(spec.steps_at_most.value_or(std::numeric_limits<std::int64_t>::max()) - before.steps),
      force_(before.world.grains.size()), rate_(before.world.grains.size()), network_(present_.size()) {
    look_up_network();
    if (stack_.is_stack()) {
        layers_ = layer_heads(water_.seepage(), before.world.grains, water_.forces(), stack_, spec.direction);
    }
    const double specific = around.fluid.density * suffuse::gravity * pull_; // [Pa/m]
    const double flow = specific * water_.permeability() / around.fluid.viscosity;
    push_ = specific * cell::volume(before.world.cell);
    power_ = push_ * flow;
    fastest_ = std::max(1.0, before.coarse_permeability / water_.permeability());
    discharge_ = flow * cell::volume(before.world.cell) / period_along(before.world.cell.h, spec.direction);
    for (std::uint32_t g = 0; g < rate_.size(); ++g) {
        rate_[g] = water_.rate(g);
    }
    if (present_.empty()) {
        return;
    }
    const std::uint32_t any = copy_.fines().front();
    const double d = median_diameter(before.world.grains);
    const double sinking =
        norm(copy_.weight(any)) / before.world.grains.mass[any] /
        (water_.hindrance() *
         stokes_rate(d, before.world.material.density * sphere_volume(d / 2), around.fluid.viscosity));
    burst_time_ = burst_travel * d / (flow / dem::porosity(before.world) + sinking);
}

/// Adds what flows in a time [s].
void Leg::flow_for(double time) {
    flowed_ += speed_ * time;
    layers_flowed_.base += layers_now_.base * time;
    layers_flowed_.filter += layers_now_.filter * time;
    layers_flowed_.interface += layers_now_.interface * time;
}

void Leg::go(double time, double most) {
    if (present_.empty()) { // water alone, which may bring fines
        layers_now_ = layers_;
        flow_for(most);
        took_ = most;
        return;
    }
    const double begin = copy_.world().clock.time;
    do {
        burst(std::min(burst_time_, most - took_));
        const double now = (copy_.world().clock.time - begin) * to_true_;
        flow_for(now - took_);
        took_ = now;
        note_travel(time + took_);
    } while (took_ < most * nearly_whole && copy_.steps() < most_steps_ && !is_flow_old());
    for (std::size_t p = 0; p < present_.size(); ++p) {
        ledger_.goes[present_[p]] = goes_now(p) ? 1 : 0;
    }
}

void Leg::enter(Migration& migration) {
    migration.time += took_;
    migration.energy += power_ * flowed_;
    migration.steps += copy_.steps();
    migration.time_step = present_.empty() ? migration.time_step : copy_.time_step() * to_true_;
    migration.hindrance = water_.hindrance();
    migration.result.holds.back().held_for += took_;
    const double speed = flowed_ / took_, permeability = water_.permeability() * speed;
    migration.result.holds.back().permeability = permeability;
    migration.now = {layers_flowed_.base / took_, layers_flowed_.filter / took_, layers_flowed_.interface / took_};
    const double sample_gradient = pull_ / strength(spec_);
    migration.result.holds.back().sample_gradient = sample_gradient;
    note_whereabouts();
    migration.ledger = ledger_;
    if (migration.result.rows.empty()) {
        migration.result.resting_permeability = water_.permeability();
    }
    MigrationRow row{
        .time = migration.time,
        .gradient = gradient_,
        .sample_gradient = sample_gradient,
        .base_gradient = migration.now.base * sample_gradient,
        .filter_gradient = migration.now.filter * sample_gradient,
        .permeability = permeability,
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

bool Leg::has_moved(std::size_t p) const {
    return norm(copy_.position(p) - start_[p]) > spec_.solve_after * diameter(p);
}

/// Of a grain [m/s].
Vec3 Leg::velocity(std::size_t p) const {
    return copy_.world().grains.velocity[copy_.fines()[p]] / to_true_;
}

/// Where a grain stands, the velocity that does not push it; where it has moved, or goes with the water, that in the
/// pore where it is.
void Leg::look_up_network() {
    constexpr std::size_t block = 256;
    parallel_for(present_.size(), block, [&](std::size_t first, std::size_t last) {
        for (std::size_t p = first; p < last; ++p) {
            const bool stands = !goes(p) && !has_moved(p);
            network_[p] = pull_ * (stands ? water_.velocity(copy_.fines()[p]) : water_.velocity_at(copy_.position(p)));
        }
    });
}

/// Over that of the network. Along the flow the gradient pushes the grains of the network, whose forces grow with that
/// speed, and the moving grains, each by its own drag m c (u - v): what the network counts too much or too little for
/// them the flow gets back or spends. It does not turn back.
double Leg::speed_of_water() const {
    const Vec3 along = spec_.direction / norm(spec_.direction);
    double push = push_, resists = push_;
    for (std::size_t p = 0; p < present_.size(); ++p) {
        const std::uint32_t g = copy_.fines()[p];
        const double drag = copy_.world().grains.mass[g] * rate_[g]; // [N s/m]
        const Vec3 counted = goes(p) ? Vec3{} : pull_ * water_.velocity(g);
        push += drag * dot(velocity(p), along);
        resists += drag * dot(network_[p] - counted, along);
    }
    return std::clamp(push / resists, 0.0, fastest_);
}

/// Of the layers, over those of the sample: heads of the network's pores grow with the speed of its water; what
/// moves in a layer takes head from the water there by its drag, which the network does not count.
LayerHeads Leg::find_layer_heads() const {
    const Vec3 along = spec_.direction / norm(spec_.direction);
    double in_base = 0, in_filter = 0, at_interface = 0; // [N]
    for (std::size_t p = 0; p < present_.size(); ++p) {
        const std::uint32_t g = copy_.fines()[p];
        const Vec3 counted = goes(p) ? Vec3{} : pull_ * water_.velocity(g);
        const double drag =
            copy_.world().grains.mass[g] * rate_[g] * dot(speed_ * (network_[p] - counted) - velocity(p), along); // [N]
        const double at = dot(copy_.position(p), along);
        const double from_face = moved_into(at, stack_.face, stack_.length) - stack_.face;
        (from_face < stack_.base_thickness() ? in_base : in_filter) += drag;
        at_interface += drag * share_at_interface(at, 0.5 * diameter(p), stack_);
    }
    const double per_length = push_ / stack_.length; // [N/m]
    return {
        speed_ * layers_.base + in_base / (per_length * stack_.base_thickness()),
        speed_ * layers_.filter + in_filter / (per_length * stack_.filter_thickness()),
        speed_ * layers_.interface + at_interface / push_};
}

/// Whether a grain goes with the water: it begins to where it is nearly as quick, and ceases where it comes to rest, at
/// half the speed.
bool Leg::goes_now(std::size_t p) const {
    const Vec3 water = water_at(p), own = velocity(p);
    return goes(p) ? norm(own) > 0.5 * (1 - spec_.with_water) * norm(water)
                   : !copy_.bears_load(p) && norm(own - water) < spec_.with_water * norm(water);
}

/// For a true time [s].
void Leg::burst(double time) {
    speed_ = speed_of_water();
    layers_now_ = stack_.is_stack() ? find_layer_heads() : LayerHeads{};
    for (std::size_t p = 0; p < present_.size(); ++p) {
        const std::uint32_t g = copy_.fines()[p];
        force_[g] = copy_.world().grains.mass[g] * rate_[g] * water_at(p);
    }
    copy_.immerse(force_, rate_);
    copy_.hold(time / copy_.true_time(), pulse_, "migrate");
    look_up_network();
}

void Leg::note_travel(double time) {
    const Vec3 along = spec_.direction / norm(spec_.direction);
    for (std::size_t p = 0; p < present_.size(); ++p) {
        const std::size_t k = present_[p];
        const Vec3 way = copy_.position(p) - ledger_.start[k];
        throats_.follow(p, copy_.position(p), ledger_.passed[k]);
        if (ledger_.departed[k] < 0 && norm(way) > departs * diameter(p)) {
            ledger_.departed[k] = time;
            ledger_.departed_at[k] = gradient_;
        }
        if (ledger_.left[k] < 0 && dot(way, along) >= ledger_.to_exit[k]) {
            ledger_.left[k] = time;
        }
    }
}

bool Leg::is_flow_old() const {
    double old = 0, all = 0;
    for (std::size_t p = 0; p < present_.size(); ++p) {
        const std::size_t k = present_[p];
        all += ledger_.mass[k];
        old += has_moved(p) || goes_now(p) != goes(p) ? ledger_.mass[k] : 0;
    }
    return old > old_share * all;
}

void Leg::note_whereabouts() {
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

} // namespace suffuse::erosion
