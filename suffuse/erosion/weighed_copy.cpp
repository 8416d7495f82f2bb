#include "suffuse/erosion/weighed_copy.hpp"

#include "suffuse/contact/carry_over.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/settle.hpp"
#include "suffuse/grains/load.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::erosion {
namespace {

// In units of WeightScale::time; measured against shorter naps in docs/theory/weight.md.
constexpr double look_interval = 0.5;  ///< between two looks at who moves
constexpr double awake_after_load = 2; ///< all are, so long after the load has changed
constexpr double creep = 1e-3;         ///< above it a grain moves [diameters in a unit of time]

constexpr double largest_drag_step =
    0.2; ///< of the time in which drag brakes the quickest grain: the scheme is explicit

/// For each grain whether a contact presses it that its weight alone does not explain.
std::vector<std::uint8_t> find_load_bearing(const dem::World& world, const std::vector<Vec3>& weight) {
    std::vector<std::uint8_t> bears(world.grains.size(), 0);
    for (const dem::ContactView& contact : dem::inspect_contacts(world)) {
        const double force = norm(contact.normal_force + contact.shear_force);
        for (const std::uint32_t g : {contact.i, contact.j}) {
            bears[g] = bears[g] != 0 || force > load_of_skeleton * norm(weight[g]) ? 1 : 0;
        }
    }
    return bears;
}

/// For each contact 1 where neither grain moves.
std::vector<std::uint8_t> between_held(const dem::World& world) {
    const contact::Contacts& contacts = world.contacts;
    const std::vector<grains::Motion>& motion = world.grains.motion;
    std::vector<std::uint8_t> held(contacts.size());
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        const bool moves =
            motion[contacts.first[c]] == grains::Motion::Free || motion[contacts.second[c]] == grains::Motion::Free;
        held[c] = moves ? 0 : 1;
    }
    return held;
}

/// Takes contacts between held grains out of the world, for they push nothing that moves. @return them
contact::Contacts part_held_grains(dem::World& world) {
    std::vector<std::uint8_t> held = between_held(world);
    contact::Contacts resting = contact::chosen_rows(world.contacts, held);
    std::ranges::transform(held, held.begin(), [](std::uint8_t is_held) { return 1 - is_held; });
    world.contacts = contact::chosen_rows(world.contacts, held);
    return resting;
}

std::int64_t count_touching(const contact::Contacts& contacts) {
    std::int64_t count = 0;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        count += contacts.touches(c) ? 1 : 0;
    }
    return count;
}

/// Marks also the grains that a marked one touches.
void mark_touched(
    const contact::Contacts& contacts, const std::vector<std::uint8_t>& moves, std::vector<std::uint8_t>& marked
) {
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        const std::uint32_t i = contacts.first[c], j = contacts.second[c];
        if (contacts.touches(c) && (moves[i] != 0 || moves[j] != 0)) {
            marked[i] = marked[j] = 1;
        }
    }
}

/// The stable step of the grains that move. Those that are held do not swing: in its measure they are heavy.
double time_step_of_free_grains(const dem::World& world) {
    constexpr double heavy = 1e6;
    dem::World measured = world;
    grains::Grains& grains = measured.grains;
    for (std::size_t g = 0; g < grains.size(); ++g) {
        if (grains.motion[g] == grains::Motion::Held) {
            grains.mass[g] *= heavy;
            grains.inertia[g] *= heavy;
        }
    }
    return dem::stable_time_step(measured);
}

} // namespace

WeighedCopy::WeighedCopy(
    const dem::World& sample, std::vector<Vec3> weight, const WeighedMotion& motion, double load_over_weight,
    const std::vector<std::uint8_t>& held
)
    : world_(sample), weight_(std::move(weight)) {
    grains::Grains& grains = world_.grains;
    world_.cell.velocity_gradient = {};
    const std::vector<std::uint8_t> bears = held.empty() ? find_load_bearing(world_, weight_) : held;
    for (std::uint32_t g = 0; g < grains.size(); ++g) {
        const bool is_free = grains.fine[g] != 0 && bears[g] == 0;
        grains.velocity[g] = grains.spin[g] = {};
        grains.motion[g] = is_free ? grains::Motion::Free : grains::Motion::Held;
        if (grains.fine[g] != 0) {
            fines_.push_back(g);
            bears_load_.push_back(bears[g]);
            free_ += is_free ? 1 : 0;
        }
    }
    skeleton_ = part_held_grains(world_);
    caches_.neighborhood.leave_out_held_pairs();
    scale_ = scale_weight(world_, weight_, fines_, motion, load_over_weight);
}

WeighedCopy::WeighedCopy(dem::World whole, const WeightScale& scale, std::vector<Vec3> weight)
    : world_(std::move(whole)), weight_(std::move(weight)), scale_(scale) {
    for (std::uint32_t g = 0; g < world_.grains.size(); ++g) {
        if (world_.grains.fine[g] != 0) {
            const bool is_held = world_.grains.motion[g] == grains::Motion::Held;
            fines_.push_back(g);
            bears_load_.push_back(is_held ? 1 : 0);
            free_ += is_held ? 0 : 1;
        }
    }
    skeleton_ = part_held_grains(world_);
    caches_.neighborhood.leave_out_held_pairs();
}

dem::World WeighedCopy::whole() {
    wake();
    dem::World whole = world_;
    whole.contacts = contact::joined(world_.contacts, skeleton_);
    return whole;
}

std::vector<Vec3> WeighedCopy::positions() const {
    std::vector<Vec3> positions;
    positions.reserve(fines_.size());
    for (const std::uint32_t g : fines_) {
        positions.push_back(world_.grains.position[g]);
    }
    return positions;
}

void WeighedCopy::wake() {
    if (!some_sleep_) {
        return;
    }
    for (std::size_t k = 0; k < fines_.size(); ++k) {
        if (bears_load_[k] == 0) {
            world_.grains.motion[fines_[k]] = grains::Motion::Free;
        }
    }
    world_.contacts = contact::joined(world_.contacts, resting_);
    resting_ = {};
    some_sleep_ = false;
    caches_.neighborhood.forget_table();
}

void WeighedCopy::put_to_sleep(const std::vector<Vec3>& before, double time) {
    grains::Grains& grains = world_.grains;
    std::vector<std::uint8_t> moves(grains.size(), 0);
    for (std::size_t k = 0; k < fines_.size(); ++k) {
        const std::uint32_t g = fines_[k];
        moves[g] = norm(position(k) - before[k]) > creep * time * 2 * grains.radius[g] ? 1 : 0;
    }
    std::vector<std::uint8_t> awake = moves;
    mark_touched(world_.contacts, moves, awake);
    mark_touched(resting_, moves, awake);
    wake();
    for (std::size_t k = 0; k < fines_.size(); ++k) {
        const std::uint32_t g = fines_[k];
        if (awake[g] == 0) {
            grains.motion[g] = grains::Motion::Held;
            grains.velocity[g] = grains.spin[g] = {};
        }
    }
    some_sleep_ = true;
    caches_.neighborhood.forget_table();
    resting_ = part_held_grains(world_);
}

void WeighedCopy::renew_time_step() {
    wake();
    dem::take_time_step(step_, time_step_of_free_grains(world_), count_touching(world_.contacts));
}

void WeighedCopy::load(std::span<const Vec3> force, double share) {
    load_.force.assign(world_.grains.size(), {});
    for (std::size_t k = 0; k < fines_.size(); ++k) {
        const std::uint32_t g = fines_[k];
        if (bears_load_[k] == 0) {
            load_.force[g] = scale_.factor * (force.empty() ? weight_[g] : weight_[g] + share * force[g]);
        }
    }
    load_.drag.clear();
    drag_ = scale_.drag;
    damping_ = dem::usual_damping;
    loaded_for_ = 0;
    renew_time_step();
}

void WeighedCopy::immerse(std::span<const Vec3> force, std::span<const double> rate) {
    load(force, 1);
    const double largest = std::ranges::max(rate);
    load_.drag.resize(rate.size());
    std::ranges::transform(rate, load_.drag.begin(), [&](double each) { return largest > 0 ? each / largest : 0; });
    drag_ = std::sqrt(scale_.factor) * largest;
    damping_ = 0;
}

void WeighedCopy::brake() {
    drag_ = largest_drag_step / step_.time_step;
}

double WeighedCopy::true_time() const {
    return scale_.time * std::sqrt(scale_.factor);
}

void WeighedCopy::hold(double time, const Pulse& pulse, std::string_view part) {
    dem::StepPlan plan;
    plan.damping = damping_;
    plan.drag = drag_;
    plan.loading = dem::constant_volume();
    plan.load = &load_;
    for (double left = time; left > 0;) {
        beat(pulse, part, steps());
        if (dem::network_has_grown(count_touching(world_.contacts) + count_touching(resting_), step_.known_contacts)) {
            renew_time_step();
        }
        plan.dt = load_.drag.empty() ? step_.time_step : std::min(step_.time_step, largest_drag_step / drag_);
        const std::vector<Vec3> before = positions();
        const auto steps = static_cast<std::int64_t>(std::ceil(std::min(left, look_interval) * scale_.time / plan.dt));
        dem::advance(world_, caches_, plan, steps);
        steps_ += steps;
        const double advanced = static_cast<double>(steps) * plan.dt / scale_.time;
        left -= advanced;
        loaded_for_ += advanced;
        if (loaded_for_ > awake_after_load) {
            put_to_sleep(before, advanced);
        }
    }
}

} // namespace suffuse::erosion
