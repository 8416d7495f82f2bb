#include "suffuse/erosion/passed_throats.hpp"

#include "suffuse/pores/network.hpp"
#include "suffuse/pores/triangulation_check.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace suffuse::erosion {
namespace {

constexpr std::size_t nowhere = 4; ///< no facet
constexpr int most_pores = 10'000; ///< on the way between two looks: flat pores must not hold a grain forever

/// The rows of a column that are of coarse grains.
template <class T>
std::vector<T> of_coarse(const grains::Grains& grains, const std::vector<T>& column) {
    std::vector<T> chosen;
    for (std::size_t g = 0; g < grains.size(); ++g) {
        if (grains.fine[g] == 0) {
            chosen.push_back(column[g]);
        }
    }
    return chosen;
}

} // namespace

CoarsePores::CoarsePores(const dem::World& world)
    : position(of_coarse(world.grains, world.grains.position)),
      network(pores::build_network(world.cell.h, position, of_coarse(world.grains, world.grains.radius))),
      locator(network, position) {}

CoarseThroats::CoarseThroats(std::shared_ptr<const CoarsePores> pores, std::span<const Vec3> start)
    : pores_(std::move(pores)) {
    traveler_.reserve(start.size());
    for (const Vec3& at : start) {
        traveler_.push_back({at, pores_->locator.find(at)});
    }
}

std::size_t CoarseThroats::way_out(const Traveler& traveler, const Vec3& to, std::size_t came_by) const {
    const auto& [pore, image] = traveler.in;
    const pores::PoreNetwork& network = pores_->network;
    std::array<Vec3, 4> corner;
    for (std::size_t k = 0; k < 4; ++k) {
        corner[k] = pores_->position[network.pores.grain[pore][k]] +
                    shift(network.h, network.pores.grain_image[pore][k] + image);
    }
    const auto inside = [&](std::size_t k, const Vec3& x) { // of facet k, as a volume
        std::array<Vec3, 4> c = corner;
        c[k] = x;
        return pores::tetrahedron_volume(c[0], c[1], c[2], c[3]);
    };
    std::size_t out = nowhere;
    double earliest = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const double end = inside(k, to);
        if (k == came_by || !(end < 0)) {
            continue;
        }
        const double begin = inside(k, traveler.at), when = begin / (begin - end);
        if (out == nowhere || when < earliest) {
            out = k, earliest = when;
        }
    }
    return out;
}

void CoarseThroats::follow(std::size_t p, const Vec3& place, PassedThroats& passed) {
    const pores::PoreNetwork& network = pores_->network;
    Traveler& traveler = traveler_[p];
    std::size_t out = way_out(traveler, place, nowhere);
    for (int pores = 0; out != nowhere && pores < most_pores; ++pores) {
        const std::uint32_t pore = traveler.in.pore, throat = network.pores.throat[pore][out];
        if (!pores::is_internal(network.throats, throat)) {
            const auto side = static_cast<std::int64_t>(pores::side_of(network, pore, out));
            const std::int64_t through = 2 * static_cast<std::int64_t>(throat) + side;
            const bool comes_back = passed.last == (through ^ 1);
            const double width = 2 * network.throats.inscribed_radius[throat];
            passed.count += comes_back ? -1 : 1;
            passed.narrowest = passed.narrowest > 0 ? std::min(passed.narrowest, width) : width;
            passed.last = comes_back ? PassedThroats::never : through;
        }
        const std::size_t came_by = pores::corner_beyond(network, pore, out);
        const pores::PlacedPore beyond = pores::pore_beyond(network, pore, out);
        traveler.in = {beyond.pore, traveler.in.image + beyond.image};
        out = way_out(traveler, place, came_by);
    }
    traveler.at = place;
}

} // namespace suffuse::erosion
