#include "suffuse/dem/stable_dt.hpp"

#include "suffuse/contact/stress.hpp"
#include "suffuse/dem/inspect.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace suffuse::dem {
namespace {

struct Motions {
    std::vector<Vec3> shift; ///< of each grain
    std::vector<Vec3> turn;
};

/// `out` = K `in`: forces and torques that the springs of all touching contacts oppose to the motions.
void apply_stiffness(const World& world, double shear_ratio, const Motions& in, Motions& out) {
    const contact::Contacts& contacts = world.contacts;
    const grains::Material& material = world.material;
    std::fill(out.shift.begin(), out.shift.end(), Vec3{});
    std::fill(out.turn.begin(), out.turn.end(), Vec3{});
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        if (!contacts.touches(c)) {
            continue;
        }
        const std::uint32_t i = contacts.first[c], j = contacts.second[c];
        const double r1 = world.grains.radius[i], r2 = world.grains.radius[j];
        const double kn = contact::normal_stiffness(material, r1, r2), ks = shear_ratio * kn;
        const Vec3 n = contacts.normal[c];
        const Vec3 apart = in.shift[j] - in.shift[i];
        const double opening = dot(n, apart);
        const Vec3 slip = apart - opening * n - cross(r1 * in.turn[i] + r2 * in.turn[j], n);
        const Vec3 roll = in.turn[j] - in.turn[i];
        const Vec3 twist = dot(n, roll) * n;
        const Vec3 force = kn * opening * n + ks * slip;
        const Vec3 moment =
            ks * r1 * r2 * (material.rolling_stiffness * (roll - twist) + material.twisting_stiffness * twist);
        const Vec3 arm = cross(n, ks * slip);
        out.shift[i] -= force;
        out.shift[j] += force;
        out.turn[i] -= r1 * arm + moment;
        out.turn[j] += moment - r2 * arm;
    }
}

} // namespace

double highest_frequency(const World& world, int iterations) {
    const grains::Grains& grains = world.grains;
    Motions x{std::vector<Vec3>(grains.size()), std::vector<Vec3>(grains.size())}, force = x;
    for (std::size_t g = 0; g < grains.size(); ++g) { // any start that is not orthogonal to the stiffest mode
        const double phase = 1.7 * static_cast<double>(g);
        x.shift[g] = {std::sin(phase), std::cos(1.3 * phase), std::sin(2.1 * phase)};
        x.turn[g] = (1 / grains.radius[g]) * Vec3{std::cos(phase), std::sin(1.9 * phase), std::cos(2.3 * phase)};
    }
    const double shear_ratio = contacts_only_push(world) ? 0 : world.material.shear_ratio;
    double square = 0;
    for (int k = 0; k < iterations; ++k) {
        apply_stiffness(world, shear_ratio, x, force);
        double energy = 0, inertia = 0;
        for (std::size_t g = 0; g < grains.size(); ++g) {
            energy += dot(x.shift[g], force.shift[g]) + dot(x.turn[g], force.turn[g]);
            inertia += grains.mass[g] * norm2(x.shift[g]) + grains.inertia[g] * norm2(x.turn[g]);
        }
        if (!(energy > 0)) {
            return 0;
        }
        square = energy / inertia;
        const double scale = 1 / (square * std::sqrt(inertia));
        for (std::size_t g = 0; g < grains.size(); ++g) {
            x.shift[g] = scale / grains.mass[g] * force.shift[g];
            x.turn[g] = scale / grains.inertia[g] * force.turn[g];
        }
    }
    return std::sqrt(square);
}

double stable_time_step(const World& world, double safety) {
    // Two equal grains of radius r: the normal mode has omega^2 = 2 k/m with k = E r; rolling in opposite sense has
    // omega^2 = 2 kr/I with kr = alpha ks r^2, and the slip spring adds to it.
    const grains::Material& m = world.material;
    const double turning =
        contacts_only_push(world) ? 0 : m.shear_ratio * (std::max(m.rolling_stiffness, m.twisting_stiffness) + 1);
    double pair = 0; // the highest
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        const double r = world.grains.radius[g], k = m.modulus * r;
        const double square = std::max(2 * k / world.grains.mass[g], 2 * turning * k * r * r / world.grains.inertia[g]);
        pair = std::max(pair, std::sqrt(square));
    }
    return safety * 2 / std::max(pair, highest_frequency(world));
}

} // namespace suffuse::dem
