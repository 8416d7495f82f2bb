#include "suffuse/packing/insertion_grid.hpp"

#include "suffuse/neighbors/grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::packing {
namespace {

/// Grid cell of a home coordinate; rounding may put a grain at the far face.
std::size_t slot(double x, double edge, int cells) {
    return static_cast<std::size_t>(std::clamp(static_cast<int>(x / edge * cells), 0, cells - 1));
}

std::size_t flat(std::size_t a, std::size_t b, std::size_t c, int cells) {
    const auto n = static_cast<std::size_t>(cells);
    return (a * n + b) * n + c;
}

/// The grid cells along one axis within `reach` of `x`, counted on beyond the faces of the cube.
struct Reach {
    int first, last;

    Reach(double x, double reach, double width)
        : first(static_cast<int>(std::floor((x - reach) / width))),
          last(static_cast<int>(std::floor((x + reach) / width))) {}
};

int period(int k, int cells) {
    return k >= 0 ? k / cells : (k + 1) / cells - 1;
}

} // namespace

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
        // Few fines in a large cell: more grid cells than a few per grain would only cost memory.
        const double most = std::cbrt(8.0 * static_cast<double>(count[level]) + 1.0);
        const double cells = std::min(edge / (2 * levels_[level].largest_radius), most);
        levels_[level].cells = std::max(1, static_cast<int>(cells));
        const auto n = static_cast<std::size_t>(levels_[level].cells);
        levels_[level].head.assign(n * n * n, -1);
    }
}

void InsertionGrid::insert(std::uint32_t g, const Vec3& position) {
    Level& level = levels_[level_of_[g]];
    level.used = true;
    const int n = level.cells;
    auto& head =
        level.head[flat(slot(position.x, edge_, n), slot(position.y, edge_, n), slot(position.z, edge_, n), n)];
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
    const double reach = radius + level.largest_radius, width = edge_ / level.cells;
    const std::array<Reach, 3> range{
        Reach(position.x, reach, width), Reach(position.y, reach, width), Reach(position.z, reach, width)};
    double deepest = -edge_;
    for (int a = range[0].first; a <= range[0].last; ++a) {
        const int pa = period(a, level.cells);
        for (int b = range[1].first; b <= range[1].last; ++b) {
            const int pb = period(b, level.cells);
            for (int c = range[2].first; c <= range[2].last; ++c) {
                const int pc = period(c, level.cells);
                const Vec3 image{pa * edge_, pb * edge_, pc * edge_};
                const auto home = [&](int k, int p) { return static_cast<std::size_t>(k - p * level.cells); };
                for (std::int32_t g = level.head[flat(home(a, pa), home(b, pb), home(c, pc), level.cells)]; g >= 0;
                     g = next_[static_cast<std::size_t>(g)]) {
                    const auto row = static_cast<std::size_t>(g);
                    const double overlap = radius + radius_[row] - norm(position_[row] + image - position);
                    deepest = std::max(deepest, overlap);
                }
                if (deepest > enough) {
                    return deepest;
                }
            }
        }
    }
    return deepest;
}

} // namespace suffuse::packing
