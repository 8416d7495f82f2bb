#include "suffuse/dem/equilibrium.hpp"

#include "suffuse/contact/stress.hpp"
#include "suffuse/dem/inspect.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::dem {
namespace {

struct ContactSums {
    double force = 0, overlap_ratio = 0;
    std::int64_t count = 0;
};

ContactSums sum_contacts(const World& world) {
    const contact::Contacts& contacts = world.contacts;
    ContactSums sums; // one after the other over the contacts that touch: which others are listed must change no bit
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        if (!contacts.touches(c)) {
            continue;
        }
        const double r1 = world.grains.radius[contacts.first[c]], r2 = world.grains.radius[contacts.second[c]];
        const double normal = contact::normal_force(world.grains, contacts, world.material, c);
        sums.force += std::sqrt(normal * normal + norm2(contacts.shear_force[c]));
        sums.overlap_ratio = std::max(sums.overlap_ratio, contacts.overlap[c] / std::min(r1, r2));
        ++sums.count;
    }
    return sums;
}

} // namespace

Equilibrium measure_equilibrium(const World& world) {
    const grains::Grains& grains = world.grains;
    const ContactSums contacts = sum_contacts(world);
    Equilibrium result;
    result.contacts = contacts.count;
    result.max_overlap_ratio = contacts.overlap_ratio;
    const std::vector<int> count = coordination(world);
    double active_sum = 0, all_sum = 0;
    for (std::size_t g = 0; g < grains.size(); ++g) {
        const double size = norm(grains.force[g]);
        all_sum += size;
        if (count[g] >= 2) {
            active_sum += size;
        }
        result.rattlers += count[g] < 2 ? 1 : 0;
        result.single_contact += count[g] == 1 ? 1 : 0;
        const Vec3 fluctuation = grains.velocity[g] - world.cell.velocity_gradient * grains.position[g];
        result.kinetic_energy +=
            0.5 * (grains.mass[g] * norm2(fluctuation) + grains.inertia[g] * norm2(grains.spin[g]));
    }
    if (contacts.count == 0) {
        return result;
    }
    const auto total = static_cast<double>(grains.size());
    const double active = total - static_cast<double>(result.rattlers);
    result.mean_contact_force = contacts.force / static_cast<double>(contacts.count);
    if (active > 0) {
        result.unbalanced_force = active_sum / active / result.mean_contact_force;
    }
    result.unbalanced_force_all = all_sum / total / result.mean_contact_force;
    return result;
}

} // namespace suffuse::dem
