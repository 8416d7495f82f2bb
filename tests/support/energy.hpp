#pragma once
// Energies of a world, written out from their definitions: what conservation tests add up.

#include "suffuse/contact/stress.hpp"
#include "suffuse/dem/world.hpp"

namespace suffuse::test {

struct Energy {
    double kinetic = 0; ///< of the motion against the mean motion, and of spin [J]
    double elastic = 0; ///< of the normal, shear, rolling and twisting springs [J]

    [[nodiscard]] double total() const { return kinetic + elastic; }
};

inline Energy energy_of(const dem::World& world) {
    Energy energy;
    const auto& g = world.grains;
    for (std::size_t k = 0; k < g.size(); ++k) {
        const Vec3 fluctuation = g.velocity[k] - world.cell.velocity_gradient * g.position[k];
        energy.kinetic += 0.5 * (g.mass[k] * norm2(fluctuation) + g.inertia[k] * norm2(g.spin[k]));
    }
    const grains::Material& m = world.material;
    const contact::Contacts& contacts = world.contacts;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        if (!contacts.touches(c)) {
            continue;
        }
        const double r1 = g.radius[contacts.first[c]], r2 = g.radius[contacts.second[c]];
        const double kn = contact::normal_stiffness(m, r1, r2, 0), ks = m.shear_ratio * kn;
        energy.elastic += 0.5 * kn * contacts.overlap[c] * contacts.overlap[c];
        if (ks > 0) {
            energy.elastic += 0.5 * norm2(contacts.shear_force[c]) / ks;
        }
        if (m.rolling_stiffness > 0) {
            energy.elastic += 0.5 * norm2(contacts.bending[c]) / (m.rolling_stiffness * ks * r1 * r2);
        }
        if (m.twisting_stiffness > 0) {
            energy.elastic += 0.5 * norm2(contacts.twisting[c]) / (m.twisting_stiffness * ks * r1 * r2);
        }
    }
    return energy;
}

inline Vec3 momentum_of(const dem::World& world) {
    Vec3 sum;
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        sum += world.grains.mass[g] * world.grains.velocity[g];
    }
    return sum;
}

} // namespace suffuse::test
