#include "suffuse/pores/constrictions.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/quantile.hpp"
#include "suffuse/pores/facet_room.hpp"
#include "suffuse/pores/triangulation_check.hpp"

#include <algorithm>
#include <numeric>

namespace suffuse::pores {
namespace {

constexpr std::size_t block = 1024;

struct Skeleton {
    const PoreNetwork& network;
    std::span<const Vec3> position;
    std::span<const double> radius;

    [[nodiscard]] Vec3 center(std::uint32_t g, const cell::Image& image) const {
        return position[g] + shift(network.h, image);
    }
};

/// What may reach into the facet of a throat, relative to its first grain at `origin`.
class Surroundings {
public:
    Surroundings(const Skeleton& skeleton, std::size_t t, const Vec3& origin)
        : skeleton_(skeleton), origin_(origin), pore_(skeleton.network.throats.side[t]) {
        image_[1] = skeleton.network.throats.image[t];
        opposite_[0] = skeleton.network.throats.facet[t];
        opposite_[1] = corner_beyond(skeleton.network, pore_[0], opposite_[0]);
    }

    /// The far corners of its two tetrahedra.
    void add_corners(NearGrains& near) const {
        for (std::size_t s = 0; s < 2; ++s) {
            add(near, pore_[s], opposite_[s], image_[s]);
        }
    }

    /// Those of the six tetrahedra behind them.
    void add_beyond(NearGrains& near) const {
        for (std::size_t s = 0; s < 2; ++s) {
            const std::uint32_t p = pore_[s];
            for (std::size_t k = 0; k < 4; ++k) {
                if (k != opposite_[s]) {
                    const PlacedPore beyond = pore_beyond(skeleton_.network, p, k);
                    add(near, beyond.pore, corner_beyond(skeleton_.network, p, k), image_[s] + beyond.image);
                }
            }
        }
    }

private:
    void add(NearGrains& near, std::uint32_t p, std::size_t k, const cell::Image& image) const {
        const Pores& pores = skeleton_.network.pores;
        const std::uint32_t g = pores.grain[p][k];
        near.add(skeleton_.center(g, pores.grain_image[p][k] + image) - origin_, skeleton_.radius[g]);
    }

    const Skeleton& skeleton_;
    Vec3 origin_;
    std::array<std::uint32_t, 2> pore_;
    std::array<std::size_t, 2> opposite_{};
    std::array<cell::Image, 2> image_{}; ///< by which the pores are moved from their own places
};

/// The largest sphere in the facet of a throat; its center is where the network has it.
InscribedCircle find_constriction(const Skeleton& skeleton, std::size_t t) {
    const auto [x, r] = spheres_of(skeleton.network, skeleton.position, skeleton.radius, t);
    const Vec3 b = x[1] - x[0], c = x[2] - x[0];
    NearGrains near;
    const Surroundings around(skeleton, t, x[0]);
    around.add_corners(near);
    around.add_beyond(near);
    InscribedCircle circle = inscribed_circle(b, c, r);
    if (!circle.is_inside || !is_free(circle, near)) {
        circle = largest_in_facet(b, c, r, circle, near);
    }
    circle.center += x[0];
    return circle;
}

Constrictions sizes_of(const Throats& throats, std::span<const std::uint32_t> constricted) {
    expects(throats.inscribed_radius.size() == throats.size(), "constrictions are measured before they are counted");
    Constrictions result;
    for (const std::uint32_t t : constricted) {
        result.diameter.push_back(2 * throats.inscribed_radius[t]);
        result.center.push_back(throats.center[t]);
    }
    if (result.diameter.empty()) {
        return result;
    }
    std::vector<double> sorted = result.diameter;
    std::sort(sorted.begin(), sorted.end());
    result.mean = std::accumulate(sorted.begin(), sorted.end(), 0.0) / static_cast<double>(sorted.size());
    result.median = quantile_of_sorted(sorted, 0.5);
    result.d35 = quantile_of_sorted(sorted, 0.35);
    return result;
}

} // namespace

void measure_constrictions(PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius) {
    Throats& throats = network.throats;
    resize_columns(throats.size(), throats.inscribed_radius, throats.center);
    const Skeleton skeleton{network, position, radius};
    parallel_for(throats.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const InscribedCircle sphere = find_constriction(skeleton, t);
            throats.inscribed_radius[t] = sphere.radius;
            throats.center[t] = sphere.center;
        }
    });
}

Constrictions find_constrictions(const PoreNetwork& network) {
    return sizes_of(network.throats, throats_between_voids(network, {}, {}, VoidMerge::None));
}

Constrictions find_constrictions(
    const PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius, VoidMerge merge
) {
    return sizes_of(network.throats, throats_between_voids(network, position, radius, merge));
}

Constrictions
find_constrictions(const Mat3& h, std::span<const Vec3> position, std::span<const double> radius, VoidMerge merge) {
    return find_constrictions(build_network(h, position, radius), position, radius, merge);
}

} // namespace suffuse::pores
