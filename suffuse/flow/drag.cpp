#include "suffuse/flow/drag.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/raw_column.hpp"

#include <array>
#include <cmath>

namespace suffuse::flow {
namespace {

/// Excess of the shares of a throat over 1 beyond which it is not rounding.
constexpr double least_excess = 1e-9;

/// Force in excess of the balance, as a share of the whole, up to which the reference's formula is kept.
constexpr double small_excess = 1e-7;

/// Part of pressure difference x area that each grain of each throat receives [-].
RawColumn<std::array<double, 3>>
grain_shares(const pores::PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius) {
    RawColumn<std::array<double, 3>> share(network.throats.size());
    parallel_for(share.size(), 2048, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const pores::ThroatGeometry throat = pores::measure_throat(network, position, radius, t);
            share[t] = {throat.grain_share(0), throat.grain_share(1), throat.grain_share(2)};
        }
    });
    return share;
}

} // namespace

std::vector<Vec3> grain_forces(
    const pores::PoreNetwork& network, std::span<const double> pressure, const Vec3& gradient,
    std::span<const Vec3> position, std::span<const double> radius
) {
    expects(pressure.size() == network.pores.size(), "one pressure a pore");
    const pores::Throats& throats = network.throats;
    const std::size_t grains = radius.size();
    const RawColumn<std::array<double, 3>> share = grain_shares(network, position, radius);
    const auto drop = [&](std::size_t t) {
        const auto [p, q] = throats.side[t];
        return pressure[p] - pressure[q] - dot(gradient, cell::shift(network.h, throats.image[t]));
    };
    std::vector<Vec3> force(grains);
    Vec3 excess;
    for (std::size_t t = 0; t < throats.size(); ++t) {
        const double difference = drop(t);
        const auto grain = pores::grains_of(network, t).row;
        for (std::size_t k = 0; k < 3; ++k) {
            force[grain[k]] += (difference * share[t][k]) * throats.area[t];
        }
        if (std::abs(throats.covered[t] - 1) > least_excess) {
            excess += (difference * (throats.covered[t] - 1)) * throats.area[t];
        }
    }
    if (excess == Vec3{}) {
        return force;
    }

    // Where a grain reaches over the opposite edge of a facet the reference counts that part twice, and forces do not
    // quite add up to the gradient times the volume. A trifle is taken back from all grains alike, so that each stays
    // within rounding of the reference; in packings where it is more, the shares of these facets are brought to 1.
    const double whole = std::abs(determinant(network.h)) * norm(gradient);
    if (norm(excess) <= small_excess * whole) {
        std::vector<std::uint8_t> is_hidden(grains, 0);
        for (const std::uint32_t g : network.hidden) {
            is_hidden[g] = 1;
        }
        const Vec3 each = excess / static_cast<double>(grains - network.hidden.size());
        for (std::size_t g = 0; g < grains; ++g) {
            if (is_hidden[g] == 0) {
                force[g] -= each;
            }
        }
        return force;
    }
    for (std::size_t t = 0; t < throats.size(); ++t) {
        const double sum = throats.covered[t];
        if (!(std::abs(sum - 1) > least_excess)) {
            continue;
        }
        const double surplus = drop(t) * (1 - 1 / sum);
        const auto grain = pores::grains_of(network, t).row;
        for (std::size_t k = 0; k < 3; ++k) {
            force[grain[k]] -= (surplus * share[t][k]) * throats.area[t];
        }
    }
    return force;
}

} // namespace suffuse::flow
