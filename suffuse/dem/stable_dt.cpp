#include "suffuse/dem/stable_dt.hpp"

#include "suffuse/contact/stress.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/neighbors/pairs.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace suffuse::dem {
namespace {

struct Motions {
    std::vector<Vec3> shift; ///< of each grain
    std::vector<Vec3> turn;
};

/// Where springs act.
struct Touching {
    std::uint32_t first, second;
    Vec3 normal;
};

/// The contacts that the last step found; before the first step those of the geometry.
std::vector<Touching> touching_pairs(const World& world) {
    std::vector<Touching> pairs;
    const contact::Contacts& contacts = world.contacts;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        if (contacts.touches(c)) {
            pairs.push_back({contacts.first[c], contacts.second[c], contacts.normal[c]});
        }
    }
    if (contacts.size() > 0) {
        return pairs;
    }
    const grains::Grains& grains = world.grains;
    for (const neighbors::Pair& pair : neighbors::find_pairs(world.cell.h, grains.position, grains.radius, 0)) {
        const Vec3 branch =
            grains.position[pair.second] + cell::shift(world.cell.h, pair.image) - grains.position[pair.first];
        pairs.push_back({pair.first, pair.second, branch / norm(branch)});
    }
    return pairs;
}

/// `out` = K `in`: forces and torques that the springs of all touching contacts oppose to the motions.
void apply_stiffness(
    const World& world, const std::vector<Touching>& pairs, double shear_ratio, const Motions& in, Motions& out
) {
    const grains::Material& material = world.material;
    std::fill(out.shift.begin(), out.shift.end(), Vec3{});
    std::fill(out.turn.begin(), out.turn.end(), Vec3{});
    for (const auto& [i, j, n] : pairs) {
        const double r1 = world.grains.radius[i], r2 = world.grains.radius[j];
        const double kn = contact::normal_stiffness(material, r1, r2), ks = shear_ratio * kn;
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
    const std::vector<Touching> pairs = touching_pairs(world);
    double square = 0;
    for (int k = 0; k < iterations; ++k) {
        apply_stiffness(world, pairs, shear_ratio, x, force);
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

double
pair_frequency(const grains::Material& material, double shear_ratio, const Inertia& first, const Inertia& second) {
    const double r1 = first.radius, r2 = second.radius;
    const double kn = contact::normal_stiffness(material, r1, r2), ks = shear_ratio * kn, arm = ks * r1 * r2;
    const double lightness = 1 / first.mass + 1 / second.mass, agility = 1 / first.turning + 1 / second.turning;
    // Shear and rolling spring each act along one direction of (shift, turn, turn), scaled by the roots of the inertia:
    // of the two modes that they span, the higher.
    const double slip = ks * (lightness + r1 * r1 / first.turning + r2 * r2 / second.turning);
    const double roll = material.rolling_stiffness * arm * agility;
    const double lever = r1 / first.turning - r2 / second.turning;
    const double coupling = ks * material.rolling_stiffness * arm * lever * lever;
    const double half = 0.5 * (slip - roll);
    const double rolling = 0.5 * (slip + roll) + std::sqrt(half * half + coupling);
    return std::sqrt(std::max({kn * lightness, rolling, material.twisting_stiffness * arm * agility}));
}

double stable_time_step(const World& world, double safety) {
    const grains::Grains& grains = world.grains;
    const double shear_ratio = contacts_only_push(world) ? 0 : world.material.shear_ratio;
    const auto grain = [&](std::size_t g) { return Inertia{grains.radius[g], grains.mass[g], grains.inertia[g]}; };
    const auto largest =
        static_cast<std::size_t>(std::max_element(grains.radius.begin(), grains.radius.end()) - grains.radius.begin());
    double highest = highest_frequency(world);
    for (std::size_t g = 0; g < grains.size(); ++g) {
        for (const std::size_t other : {g, largest}) {
            highest = std::max(highest, pair_frequency(world.material, shear_ratio, grain(g), grain(other)));
        }
    }
    return safety * 2 / highest;
}

} // namespace suffuse::dem
