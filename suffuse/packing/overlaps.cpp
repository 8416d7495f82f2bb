#include "suffuse/packing/overlaps.hpp"

#include "suffuse/dem/inspect.hpp"
#include "suffuse/neighbors/pairs.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::packing {
namespace {

bool is_overlapping(const neighbors::Pair& pair, const Mat3& h, std::span<const Vec3> x, std::span<const double> r) {
    const double sum = r[pair.first] + r[pair.second];
    return norm2(x[pair.second] + cell::shift(h, pair.image) - x[pair.first]) < sum * sum;
}

/// Pushes overlapping pairs apart, one after another, the lighter grain moving further. @return whether any overlapped.
bool push_apart(
    std::span<const neighbors::Pair> pairs, const Mat3& h, std::span<const double> radius, std::vector<Vec3>& position
) {
    constexpr double slack = 1e-3; // of the smaller radius: aiming at a gap ends in finitely many sweeps
    bool moved = false;
    for (const neighbors::Pair& pair : pairs) {
        const auto i = pair.first, j = pair.second;
        const double ri = radius[i], rj = radius[j];
        const Vec3 branch = position[j] + cell::shift(h, pair.image) - position[i];
        const double square = norm2(branch);
        if (square >= (ri + rj) * (ri + rj)) {
            continue;
        }
        moved = true;
        const double distance = std::sqrt(square);
        const Vec3 normal = distance > 0 ? branch / distance : Vec3{1, 0, 0};
        const double push = ri + rj + slack * std::min(ri, rj) - distance;
        const double vi = ri * ri * ri, vj = rj * rj * rj;
        position[i] -= push * vj / (vi + vj) * normal;
        position[j] += push * vi / (vi + vj) * normal;
    }
    return moved;
}

} // namespace

bool clear_overlaps(const Mat3& h, std::span<const double> radius, std::vector<Vec3>& position, int most_rounds) {
    constexpr int sweeps = 12; // the search for pairs is redone every round
    if (radius.empty()) {
        return true;
    }
    const double margin = 0.2 * *std::min_element(radius.begin(), radius.end());
    for (int round = 0; round < most_rounds; ++round) {
        const std::vector<neighbors::Pair> pairs = neighbors::find_pairs(h, position, radius, margin);
        if (std::ranges::none_of(pairs, [&](const auto& p) { return is_overlapping(p, h, position, radius); })) {
            return true;
        }
        for (int sweep = 0; sweep < sweeps && push_apart(pairs, h, radius, position); ++sweep) {
        }
    }
    return false;
}

bool bring_to_porosity(dem::World& world, double porosity, int most_rounds) {
    const double scale = std::cbrt((1 - dem::porosity(world)) / (1 - porosity));
    world.cell.h = scale * world.cell.h;
    world.cell.velocity_gradient = {};
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        world.grains.position[g] *= scale;
        world.grains.velocity[g] = world.grains.spin[g] = {};
        world.grains.force[g] = world.grains.torque[g] = {};
    }
    world.contacts = {};
    return clear_overlaps(world.cell.h, world.grains.radius, world.grains.position, most_rounds);
}

double bring_near_touching(dem::World& world) {
    constexpr double step = 0.02;   // of porosity
    constexpr int easy_rounds = 25; // overlaps of one step clear within these until grains are about to jam
    for (double porosity = dem::porosity(world) - step; porosity > step; porosity -= step) {
        const dem::World before = world;
        if (!bring_to_porosity(world, porosity, easy_rounds)) {
            world = before;
            break;
        }
    }
    return dem::porosity(world);
}

} // namespace suffuse::packing
