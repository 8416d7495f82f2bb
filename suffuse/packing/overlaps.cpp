#include "suffuse/packing/overlaps.hpp"

#include "suffuse/dem/inspect.hpp"
#include "suffuse/neighbors/pairs.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::packing {
namespace {

/// Pairs within a margin, requested again and again while grains move a little: chosen from a wider list, which is made
/// anew when a grain has moved too far for it.
class NearPairs {
public:
    NearPairs(const Mat3& h, std::span<const double> radius, std::size_t fixed)
        : h_(h), radius_(radius), fixed_(fixed), margin_(0.2 * *std::min_element(radius.begin(), radius.end())) {}

    const std::vector<neighbors::Pair>& find(const std::vector<Vec3>& position) {
        if (!reaches(position)) {
            wide_ = neighbors::find_pairs(h_, position, radius_, wide_margins * margin_);
            std::erase_if(wide_, [&](const neighbors::Pair& pair) { return pair.second < fixed_; });
            listed_at_ = position;
        }
        near_.clear();
        for (const neighbors::Pair& pair : wide_) {
            if (is_within(pair, position, margin_)) {
                near_.push_back(pair);
            }
        }
        return near_;
    }

    [[nodiscard]] bool any_overlaps(const std::vector<Vec3>& position) const {
        return std::ranges::any_of(near_, [&](const auto& pair) { return is_within(pair, position, 0); });
    }

private:
    static constexpr double wide_margins = 3; // two of them are for the motion of a pair

    [[nodiscard]] bool reaches(const std::vector<Vec3>& position) const {
        const double allowed = 0.5 * (wide_margins - 1) * margin_;
        for (std::size_t g = 0; g < listed_at_.size(); ++g) {
            if (norm2(position[g] - listed_at_[g]) > allowed * allowed) {
                return false;
            }
        }
        return !listed_at_.empty();
    }

    [[nodiscard]] bool is_within(const neighbors::Pair& pair, const std::vector<Vec3>& position, double margin) const {
        const double limit = radius_[pair.first] + radius_[pair.second] + margin;
        const Vec3 branch = position[pair.second] + cell::shift(h_, pair.image) - position[pair.first];
        return norm2(branch) < limit * limit;
    }

    const Mat3& h_;
    std::span<const double> radius_;
    std::size_t fixed_; ///< rows before this one stay
    double margin_;     ///< [m]
    std::vector<neighbors::Pair> wide_, near_;
    std::vector<Vec3> listed_at_; ///< where grains were when the wider list was made [m]
};

/// Pushes overlapping pairs apart, one after another, the lighter grain moving further, and of one that is fixed the
/// other alone. @return whether any overlapped.
bool push_apart(
    std::span<const neighbors::Pair> pairs, const Mat3& h, std::span<const double> radius, std::vector<Vec3>& position,
    std::size_t fixed
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
        const double of_i = i < fixed ? 0 : push * vj / (vi + vj), of_j = i < fixed ? push : push * vi / (vi + vj);
        position[i] -= of_i * normal;
        position[j] += of_j * normal;
    }
    return moved;
}

/// Brings each grain back between its planes.
void keep_between(const Slabs& slabs, std::span<const double> radius, std::vector<Vec3>& position) {
    for (std::size_t g = 0; g < position.size(); ++g) {
        double& at = position[g][slabs.axis];
        at = std::clamp(at, slabs.low[g] + radius[g], slabs.high[g] - radius[g]);
    }
}

/// @param fixed rows before this one stay; @param slabs may be null
bool clear(
    const Mat3& h, std::span<const double> radius, std::vector<Vec3>& position, std::size_t fixed, const Slabs* slabs,
    int most_rounds, const Pulse& pulse
) {
    constexpr int sweeps = 12; // over the pairs that are near when a round begins
    if (radius.empty()) {
        return true;
    }
    NearPairs near(h, radius, fixed);
    for (int round = 0; round < most_rounds; ++round) {
        const std::vector<neighbors::Pair>& pairs = near.find(position);
        if (!near.any_overlaps(position)) {
            return true;
        }
        for (int sweep = 0; sweep < sweeps && push_apart(pairs, h, radius, position, fixed); ++sweep) {
            beat(pulse, "part", round);
            if (slabs != nullptr) {
                keep_between(*slabs, radius, position);
            }
        }
    }
    return false;
}

} // namespace

bool clear_overlaps(
    const Mat3& h, std::span<const double> radius, std::vector<Vec3>& position, int most_rounds, const Pulse& pulse
) {
    return clear_overlaps_around(h, radius, position, 0, most_rounds, pulse);
}

bool clear_overlaps_around(
    const Mat3& h, std::span<const double> radius, std::vector<Vec3>& position, std::size_t fixed, int most_rounds,
    const Pulse& pulse
) {
    return clear(h, radius, position, fixed, nullptr, most_rounds, pulse);
}

bool clear_overlaps_between(
    const Mat3& h, std::span<const double> radius, std::vector<Vec3>& position, const Slabs& slabs, int most_rounds,
    const Pulse& pulse
) {
    return clear(h, radius, position, 0, &slabs, most_rounds, pulse);
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
