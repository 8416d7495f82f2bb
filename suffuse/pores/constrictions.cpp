#include "suffuse/pores/constrictions.hpp"

#include "suffuse/base/quantile.hpp"

#include <algorithm>
#include <numeric>

namespace suffuse::pores {
namespace {

Constrictions sizes_of(const Throats& throats, std::span<const std::uint32_t> constricted) {
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
