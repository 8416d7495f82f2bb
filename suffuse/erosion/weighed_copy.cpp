#include "suffuse/erosion/weighed_copy.hpp"

#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/settle.hpp"
#include "suffuse/grains/load.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::erosion {
namespace {

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

/// Contacts between held grains push nothing that moves: they are taken not to touch, and the first table drops them.
void part_held_grains(dem::World& world) {
    contact::Contacts& contacts = world.contacts;
    const std::vector<grains::Motion>& motion = world.grains.motion;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        if (motion[contacts.first[c]] == grains::Motion::Free || motion[contacts.second[c]] == grains::Motion::Free) {
            continue;
        }
        contacts.overlap[c] = 0;
        for (contact::VectorColumn* column :
             {&contacts.shear_force, &contacts.bending, &contacts.normal, &contacts.twisting}) {
            if (column->size() > 0) { // twisting memory need not be there
                column->set(c, {});
            }
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

WeighedCopy::WeighedCopy(const dem::World& sample, std::vector<Vec3> weight, const WeighedMotion& motion)
    : world_(sample), weight_(std::move(weight)) {
    grains::Grains& grains = world_.grains;
    world_.cell.velocity_gradient = {};
    const std::vector<std::uint8_t> bears = find_load_bearing(world_, weight_);
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
    part_held_grains(world_);
    caches_.neighborhood.leave_out_held_pairs();
    scale_ = scale_weight(world_, weight_, fines_, motion);
}

void WeighedCopy::go_back(const State& state) {
    undone_steps_ += steps_ - state.steps;
    world_ = state.world;
    step_ = state.step;
    steps_ = state.steps;
    caches_ = {};
    caches_.neighborhood.leave_out_held_pairs();
}

std::vector<Vec3> WeighedCopy::positions() const {
    std::vector<Vec3> positions;
    positions.reserve(fines_.size());
    for (const std::uint32_t g : fines_) {
        positions.push_back(world_.grains.position[g]);
    }
    return positions;
}

void WeighedCopy::hold(
    double time, std::span<const Vec3> force, double share, const Pulse& pulse, std::string_view part
) {
    constexpr std::int64_t burst = 200; // between two looks at the pulse
    grains::GrainLoad load;
    load.force.resize(world_.grains.size());
    for (std::size_t k = 0; k < fines_.size(); ++k) {
        const std::uint32_t g = fines_[k];
        if (bears_load_[k] == 0) {
            load.force[g] = scale_.factor * (force.empty() ? weight_[g] : weight_[g] + share * force[g]);
        }
    }
    dem::StepPlan plan;
    plan.damping = dem::usual_damping;
    plan.drag = scale_.drag;
    plan.loading = dem::constant_volume();
    plan.load = &load;
    for (double left = time * scale_.time; left > 0;) {
        beat(pulse, part, steps());
        const std::int64_t contacts = dem::measure_equilibrium(world_).contacts;
        dem::renew_time_step(step_, steps_, contacts, [&] { return time_step_of_free_grains(world_); });
        plan.dt = step_.time_step;
        const auto steps = std::clamp<std::int64_t>(static_cast<std::int64_t>(std::ceil(left / plan.dt)), 1, burst);
        dem::advance(world_, caches_, plan, steps);
        steps_ += steps;
        left -= static_cast<double>(steps) * plan.dt;
    }
}

} // namespace suffuse::erosion
