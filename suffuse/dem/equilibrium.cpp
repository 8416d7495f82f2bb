#include "suffuse/dem/equilibrium.hpp"

#include "suffuse/base/parallel.hpp"
#include "suffuse/contact/stress.hpp"
#include "suffuse/contact/sum_touching.hpp"
#include "suffuse/dem/inspect.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::dem {
namespace {

struct ContactSums {
    double force = 0, overlap_ratio = 0;
    std::int64_t count = 0;
};

ContactSums operator+(const ContactSums& a, const ContactSums& b) {
    return {a.force + b.force, std::max(a.overlap_ratio, b.overlap_ratio), a.count + b.count};
}

ContactSums sum_contacts(const World& world) {
    const contact::Contacts& contacts = world.contacts;
    const std::vector<double>& radius = world.grains.radius;
    return contact::sum_touching(contacts, radius.size(), ContactSums{}, [&](ContactSums& sum, std::size_t c) {
        const double normal = contact::normal_force(world.grains, contacts, world.material, c);
        sum.force += std::sqrt(normal * normal + norm2(contacts.shear_force[c]));
        const double smaller = std::min(radius[contacts.first[c]], radius[contacts.second[c]]);
        sum.overlap_ratio = std::max(sum.overlap_ratio, contacts.overlap[c] / smaller);
        ++sum.count;
    });
}

/// Of forces, `free` and `active`: grains that nobody holds.
struct GrainSums {
    double force = 0, active_force = 0, kinetic_energy = 0;
    std::int64_t free = 0, active = 0, rattlers = 0, single_contact = 0;
};

GrainSums operator+(const GrainSums& a, const GrainSums& b) {
    return {a.force + b.force,   a.active_force + b.active_force, a.kinetic_energy + b.kinetic_energy, a.free + b.free,
            a.active + b.active, a.rattlers + b.rattlers,         a.single_contact + b.single_contact};
}

GrainSums sum_grains(const World& world, const grains::GrainLoad* load) {
    const grains::Grains& grains = world.grains;
    const std::vector<int> count = coordination(world);
    const bool is_loaded = load != nullptr && !load->force.empty();
    return parallel_sum(grains.size(), 1024, GrainSums{}, [&](std::size_t begin, std::size_t end) {
        GrainSums sum;
        for (std::size_t g = begin; g < end; ++g) {
            const bool is_free = grains.motion[g] == grains::Motion::Free, is_active = is_free && count[g] >= 2;
            const double size = norm(is_loaded ? grains.force[g] + load->force[g] : grains.force[g]);
            sum.force += is_free ? size : 0;
            sum.active_force += is_active ? size : 0;
            sum.free += is_free ? 1 : 0;
            sum.active += is_active ? 1 : 0;
            sum.rattlers += count[g] < 2 ? 1 : 0;
            sum.single_contact += count[g] == 1 ? 1 : 0;
            const Vec3 fluctuation = grains.velocity[g] - world.cell.velocity_gradient * grains.position[g];
            sum.kinetic_energy +=
                0.5 * (grains.mass[g] * norm2(fluctuation) + grains.inertia[g] * norm2(grains.spin[g]));
        }
        return sum;
    });
}

} // namespace

Equilibrium measure_equilibrium(const World& world, const grains::GrainLoad* load) {
    const ContactSums contacts = sum_contacts(world);
    const GrainSums grains = sum_grains(world, load);
    Equilibrium result;
    result.contacts = contacts.count;
    result.max_overlap_ratio = contacts.overlap_ratio;
    result.rattlers = grains.rattlers;
    result.single_contact = grains.single_contact;
    result.kinetic_energy = grains.kinetic_energy;
    if (contacts.count == 0) {
        return result;
    }
    result.mean_contact_force = contacts.force / static_cast<double>(contacts.count);
    if (grains.active_force > 0) { // grains that just touch carry nothing, and nothing of it is unbalanced
        result.unbalanced_force = grains.active_force / static_cast<double>(grains.active) / result.mean_contact_force;
    }
    if (grains.force > 0) {
        result.unbalanced_force_all = grains.force / static_cast<double>(grains.free) / result.mean_contact_force;
    }
    return result;
}

} // namespace suffuse::dem
