#include "suffuse/erosion/lodging.hpp"

#include "suffuse/neighbors/pairs.hpp"

#include <algorithm>

namespace suffuse::erosion {
namespace {

/// Spheres of which no two that overlap may be filled at once: the grains that stay, and for each that is held the
/// place where it was and those where it may lie.
struct Spots {
    std::vector<Vec3> position; ///< [m]
    std::vector<double> radius; ///< [m]
    std::vector<std::uint8_t> is_filled;
    std::vector<std::vector<std::uint32_t>> overlaps; ///< of each, other spots

    std::uint32_t add(const Vec3& x, double r, bool filled) {
        position.push_back(x), radius.push_back(r), is_filled.push_back(filled ? 1 : 0);
        return static_cast<std::uint32_t>(position.size() - 1);
    }

    void find_overlaps(const Mat3& h) {
        overlaps.resize(position.size());
        for (const neighbors::Pair& pair : neighbors::find_pairs(h, position, radius, 0)) {
            const std::uint32_t a = pair.first, b = pair.second;
            const double distance = norm(position[b] + shift(h, pair.image) - position[a]);
            const double overlap = radius[a] + radius[b] - distance;
            if (a != b && overlap > lodging_overlap * std::min(radius[a], radius[b])) {
                overlaps[a].push_back(b), overlaps[b].push_back(a);
            }
        }
    }

    /// @param own spot of the grain that asks
    [[nodiscard]] bool is_free(std::uint32_t spot, std::uint32_t own) const {
        return std::none_of(overlaps[spot].begin(), overlaps[spot].end(), [&](std::uint32_t other) {
            return other != own && is_filled[other] != 0;
        });
    }
};

/// A grain that is held, and its spots: where it was, then its places in the order of its wish.
struct Held {
    std::size_t journey = 0;
    std::uint32_t origin = 0, first_place = 0, end_of_places = 0;
};

} // namespace

std::vector<std::optional<Vec3>> find_places(const dem::World& world, std::span<const Journey> journeys) {
    const grains::Grains& grains = world.grains;
    std::vector<std::uint8_t> travels(grains.size(), 0);
    Spots spots;
    std::vector<Held> waiting;
    for (std::size_t j = 0; j < journeys.size(); ++j) {
        const Journey& journey = journeys[j];
        travels[journey.row] = 1;
        if (!journey.constriction) {
            continue;
        }
        const double radius = grains.radius[journey.row];
        Held held{j, spots.add(grains.position[journey.row], radius, true), 0, 0};
        held.first_place = held.origin + 1;
        for (const Vec3& place : journey.places) {
            spots.add(place, radius, false);
        }
        held.end_of_places = static_cast<std::uint32_t>(spots.position.size());
        waiting.push_back(held);
    }
    for (std::size_t g = 0; g < grains.size(); ++g) {
        if (travels[g] == 0) {
            spots.add(grains.position[g], grains.radius[g], true);
        }
    }
    spots.find_overlaps(world.cell.h);

    std::vector<std::optional<Vec3>> places(journeys.size());
    for (bool has_moved = true; has_moved;) { // each grain moves once at most
        const std::size_t before = waiting.size();
        std::erase_if(waiting, [&](const Held& held) {
            for (std::uint32_t spot = held.first_place; spot < held.end_of_places; ++spot) {
                if (spots.is_free(spot, held.origin)) {
                    spots.is_filled[held.origin] = 0;
                    spots.is_filled[spot] = 1;
                    places[held.journey] = spots.position[spot];
                    return true;
                }
            }
            return false;
        });
        has_moved = waiting.size() < before;
    }
    return places;
}

} // namespace suffuse::erosion
