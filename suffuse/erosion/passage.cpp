#include "suffuse/erosion/passage.hpp"

#include "suffuse/base/quantile.hpp"
#include "suffuse/pores/constrictions.hpp"
#include "suffuse/pores/locate.hpp"
#include "suffuse/pores/network.hpp"
#include "suffuse/pores/widest_path.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace suffuse::erosion {
namespace {

struct CoarseGrains {
    std::vector<Vec3> position;
    std::vector<double> radius;
};

CoarseGrains coarse_grains(const grains::Grains& grains) {
    CoarseGrains coarse;
    for (std::size_t g = 0; g < grains.size(); ++g) {
        if (grains.fine[g] != 0) {
            continue;
        }
        coarse.position.push_back(grains.position[g]);
        coarse.radius.push_back(grains.radius[g]);
    }
    return coarse;
}

/// Diameter of the widest path from where each grain of the world is [m].
std::vector<double> paths_of_grains(
    const pores::PoreNetwork& network, const CoarseGrains& coarse, const dem::World& world, const Vec3& direction
) {
    const std::vector<double> path = pores::widest_paths(network, pores::axis_along(world.cell.h, direction));
    const pores::PoreLocator locator(network, coarse.position);
    std::vector<double> diameter;
    for (const Vec3& x : world.grains.position) {
        diameter.push_back(path[locator.find(x).pore]);
    }
    return diameter;
}

} // namespace

std::optional<SkeletonDoubt> doubt_skeleton(const dem::World& world) {
    const CoarseGrains coarse = coarse_grains(world.grains);
    if (coarse.radius.size() < fewest_coarse) {
        return SkeletonDoubt{std::ssize(coarse.radius), 0};
    }
    const double diameter = 2 * upper_quantile(coarse.radius, 0.5);
    const Vec3 width = cell::widths(world.cell.h);
    const double narrow = std::min({width.x, width.y, width.z});
    if (narrow < narrowest_skeleton * diameter) {
        return SkeletonDoubt{std::ssize(coarse.radius), narrow / diameter};
    }
    return std::nullopt;
}

CoarseSkeleton
measure_coarse_skeleton(const dem::World& world, const Vec3& direction, bool with_paths, pores::VoidMerge merge) {
    const CoarseGrains coarse = coarse_grains(world.grains);
    const pores::PoreNetwork network = pores::build_network(world.cell.h, coarse.position, coarse.radius);
    CoarseSkeleton skeleton;
    for (std::size_t way = 0; way < pores::every_merge.size(); ++way) {
        Constrictions found =
            pores::find_constrictions(network, coarse.position, coarse.radius, pores::every_merge[way]);
        skeleton.by_merge[way] = {std::ssize(found.diameter), found.mean, found.median, found.d35};
        if (pores::every_merge[way] == merge) {
            skeleton.constrictions = std::move(found);
        }
    }
    if (with_paths) {
        skeleton.widest_path = paths_of_grains(network, coarse, world, direction);
    }
    return skeleton;
}

bool passes(const CoarseSkeleton& skeleton, ConstrictionSize size, std::size_t g, double d) {
    const bool by_sizes =
        size == ConstrictionSize::Mean || size == ConstrictionSize::Median || size == ConstrictionSize::D35;
    if (by_sizes && skeleton.constrictions.diameter.empty()) {
        return true; // all pores are one void: nothing is in the way
    }
    switch (size) {
    case ConstrictionSize::Mean:
        return d < skeleton.constrictions.mean;
    case ConstrictionSize::Median:
        return d < skeleton.constrictions.median;
    case ConstrictionSize::D35:
        return d < skeleton.constrictions.d35;
    case ConstrictionSize::WidestPath:
        return d < skeleton.widest_path[g];
    case ConstrictionSize::FlowPath: // follows the water: transport.hpp
    case ConstrictionSize::None:
        break;
    }
    return true;
}

} // namespace suffuse::erosion
