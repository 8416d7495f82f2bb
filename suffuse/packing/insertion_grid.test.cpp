#include "suffuse/packing/insertion_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace suffuse::packing {
namespace {

TEST(InsertionGrid, DeepestOverlapEqualsTheSearchOverAllGrainsAndImages) {
    const double edge = 1;
    const std::vector<double> radius{0.24, 0.2, 0.1, 0.05, 0.05, 0.02, 0.011, 0.01};
    const std::vector<Vec3> position{{0.1, 0.1, 0.1}, {0.9, 0.5, 0.5},   {0.5, 0.02, 0.99}, {0.3, 0.6, 0.7},
                                     {0.7, 0.7, 0.2}, {0.99, 0.99, 0.5}, {0.5, 0.5, 0.0},   {0.01, 0.45, 0.2}};
    InsertionGrid grid(edge, radius);
    for (std::uint32_t g = 0; g < radius.size(); ++g) {
        grid.insert(g, position[g]);
    }
    for (int k = 0; k < 1000; ++k) {
        const Vec3 x{k % 10 * 0.1, k / 10 % 10 * 0.1, k / 100 * 0.1};
        double deepest = -1;
        for (std::size_t g = 0; g < radius.size(); ++g) {
            for (int image = 0; image < 27; ++image) {
                const Vec3 shift{image % 3 - 1.0, image / 3 % 3 - 1.0, image / 9 - 1.0};
                deepest = std::max(deepest, 0.15 + radius[g] - norm(position[g] + shift - x));
            }
        }
        const double found = grid.deepest_overlap(x, 0.15, edge);
        if (deepest > 0) {
            EXPECT_DOUBLE_EQ(found, deepest);
        } else {
            EXPECT_LE(found, 0);
        }
    }
}

} // namespace
} // namespace suffuse::packing
