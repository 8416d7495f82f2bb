#include "suffuse/erosion/passage.hpp"

#include "suffuse/pores/network.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace suffuse::erosion {
namespace {

constexpr double narrowest_cell = 5;     // coarse diameters: below, the skeleton sees its own images
constexpr std::size_t fewest_coarse = 50; // grains, for a distribution of constrictions to mean anything

struct CoarseGrains {
    std::vector<Vec3> position;
    std::vector<double> radius;
};

CoarseGrains coarse_grains(const grains::Grains& grains) {
    CoarseGrains coarse;
    for (std::size_t g = 0; g < grains.size(); ++g) {
        if (grains.fine[g] != 0) { continue; }
        coarse.position.push_back(grains.position[g]);
        coarse.radius.push_back(grains.radius[g]);
    }
    return coarse;
}

/// Size below which a share of the facets lies, by number.
double size_at(const std::vector<double>& sorted, double share) {
    if (sorted.empty()) { return 0; }
    const double rank = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(rank);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (rank - std::floor(rank)) * (sorted[above] - sorted[below]);
}

Constrictions describe(const pores::Throats& throats) {
    Constrictions result;
    for (std::size_t t = 0; t < throats.size(); ++t) {
        if (pores::is_internal(throats, t)) { continue; } // an artificial cut through one void
        result.diameter.push_back(2 * throats.inscribed_radius[t]);
        result.center.push_back(throats.center[t]);
    }
    if (result.diameter.empty()) { return result; }
    std::vector<double> sorted = result.diameter;
    std::sort(sorted.begin(), sorted.end());
    result.mean = std::accumulate(sorted.begin(), sorted.end(), 0.0) / static_cast<double>(sorted.size());
    result.median = size_at(sorted, 0.5);
    result.d35 = size_at(sorted, 0.35);
    return result;
}

} // namespace

std::optional<std::string> skeleton_complaint(const dem::World& world) {
    const CoarseGrains coarse = coarse_grains(world.grains);
    if (coarse.radius.size() < fewest_coarse) {
        return fmt::format(
            "the coarse skeleton has {} grains left: too few for its constrictions to mean anything", coarse.radius.size()
        );
    }
    std::vector<double> radius = coarse.radius;
    std::nth_element(radius.begin(), radius.begin() + static_cast<std::ptrdiff_t>(radius.size() / 2), radius.end());
    const double diameter = 2 * radius[radius.size() / 2];
    const Vec3 width = cell::widths(world.cell.h);
    const double narrow = std::min({width.x, width.y, width.z});
    if (narrow < narrowest_cell * diameter) {
        return fmt::format(
            "the cell is only {:.1f} coarse diameters wide (at least {} wanted): the coarse skeleton has lost its meaning",
            narrow / diameter, narrowest_cell
        );
    }
    return std::nullopt;
}

CoarseSkeleton measure_coarse_skeleton(const dem::World& world, const Vec3& direction, bool with_paths) {
    const CoarseGrains coarse = coarse_grains(world.grains);
    const pores::PoreNetwork network = pores::build_network(world.cell.h, coarse.position, coarse.radius);
    CoarseSkeleton skeleton{describe(network.throats), {}};
    (void)direction, (void)with_paths;
    return skeleton;
}

bool passes(const CoarseSkeleton& skeleton, ConstrictionSize size, std::size_t g, double d) {
    switch (size) {
    case ConstrictionSize::Mean:
        return d < skeleton.constrictions.mean;
    case ConstrictionSize::Median:
        return d < skeleton.constrictions.median;
    case ConstrictionSize::D35:
        return d < skeleton.constrictions.d35;
    case ConstrictionSize::WidestPath:
        return d < skeleton.widest_path[g];
    case ConstrictionSize::None:
        break;
    }
    return true;
}

} // namespace suffuse::erosion
