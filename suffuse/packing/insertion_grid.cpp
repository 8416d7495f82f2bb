#include "suffuse/packing/insertion_grid.hpp"

#include "suffuse/neighbors/grid.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::packing {

InsertionGrid::InsertionGrid(double edge, std::span<const double> radius)
    : edge_(edge), radius_(radius), level_of_(radius.size()), next_(radius.size(), -1), position_(radius.size()) {
    std::vector<std::size_t> count;
    for (std::size_t g = 0; g < radius.size(); ++g) {
        const auto level = static_cast<std::size_t>(neighbors::size_class(radius[g], radius.front()));
        level_of_[g] = static_cast<std::uint8_t>(level);
        if (level >= levels_.size()) {
            levels_.resize(level + 1);
            count.resize(level + 1, 0);
        }
        levels_[level].largest_radius = std::max(levels_[level].largest_radius, radius[g]);
        ++count[level];
    }
    for (std::size_t level = 0; level < levels_.size(); ++level) {
        if (count[level] == 0) {
            continue;
        }
        // Few fines in a large cell: more bins than a few per grain would only cost memory.
        const double most = std::cbrt(8.0 * static_cast<double>(count[level]) + 1.0);
        const double along = std::min(edge / (2 * levels_[level].largest_radius), most);
        levels_[level].bins.along.fill(std::max(1, static_cast<int>(along)));
        levels_[level].head.assign(levels_[level].bins.count(), -1);
    }
}

void InsertionGrid::insert(std::uint32_t g, const Vec3& position) {
    Level& level = levels_[level_of_[g]];
    level.used = true;
    std::int32_t& head = level.head[level.bins.bin_of(position / edge_)];
    next_[g] = head;
    head = static_cast<std::int32_t>(g);
    position_[g] = position;
}

double InsertionGrid::deepest_overlap(const Vec3& position, double radius, double enough) const {
    double deepest = -edge_;
    for (const Level& level : levels_) {
        if (!level.used) {
            continue;
        }
        deepest = std::max(deepest, deepest_in(level, position, radius, enough));
        if (deepest > enough) {
            break;
        }
    }
    return deepest;
}

double InsertionGrid::deepest_in(const Level& level, const Vec3& position, double radius, double enough) const {
    const double reach = radius + level.largest_radius;
    const Vec3 low = position - reach * Vec3{1, 1, 1}, high = position + reach * Vec3{1, 1, 1};
    double deepest = -edge_;
    level.bins.any_of(low / edge_, high / edge_, [&](std::size_t bin, const cell::Image& period) {
        const Vec3 image = edge_ * Vec3{double(period.a), double(period.b), double(period.c)};
        for (std::int32_t g = level.head[bin]; g >= 0; g = next_[static_cast<std::size_t>(g)]) {
            const auto row = static_cast<std::size_t>(g);
            deepest = std::max(deepest, radius + radius_[row] - norm(position_[row] + image - position));
        }
        return deepest > enough;
    });
    return deepest;
}

} // namespace suffuse::packing
