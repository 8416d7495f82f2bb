#include "suffuse/erosion/lodging.hpp"

#include "suffuse/erosion/filled_space.hpp"

#include <algorithm>

namespace suffuse::erosion {

std::vector<std::optional<Vec3>> find_places(const dem::World& world, std::span<const Journey> journeys) {
    const grains::Grains& grains = world.grains;
    std::vector<std::uint8_t> has_left(grains.size(), 0);
    std::vector<std::size_t> waiting; // journeys
    double largest = 0;
    for (std::size_t j = 0; j < journeys.size(); ++j) {
        has_left[journeys[j].row] = journeys[j].constriction ? 0 : 1;
        if (!journeys[j].places.empty()) {
            waiting.push_back(j);
            largest = std::max(largest, grains.radius[journeys[j].row]);
        }
    }
    std::vector<std::optional<Vec3>> places(journeys.size());
    if (waiting.empty()) {
        return places;
    }
    FilledSpace space(world.cell.h, 2 * largest, grains.size());
    for (std::uint32_t g = 0; g < grains.size(); ++g) {
        if (has_left[g] == 0) {
            space.fill(grains.position[g], grains.radius[g], g);
        }
    }
    for (bool has_moved = true; has_moved;) { // each grain moves once at most
        const std::size_t before = waiting.size();
        std::erase_if(waiting, [&](std::size_t j) {
            const std::uint32_t g = journeys[j].row;
            const double radius = grains.radius[g];
            const auto free = std::find_if(journeys[j].places.begin(), journeys[j].places.end(), [&](const Vec3& x) {
                return space.is_free(x, radius, g);
            });
            if (free == journeys[j].places.end()) {
                return false;
            }
            space.clear(grains.position[g], radius, g);
            space.fill(*free, radius, g);
            places[j] = *free;
            return true;
        });
        has_moved = waiting.size() < before;
    }
    return places;
}

} // namespace suffuse::erosion
