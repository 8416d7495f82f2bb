#include "suffuse/cell/bins.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace suffuse::cell {
namespace {

const Bins bins{{2, 3, 5}};

TEST(Bins, EachPointOfTheCellHasOneOfThem) {
    std::set<std::size_t> met;
    for (int k = 0; k < 1000; ++k) {
        met.insert(bins.bin_of({k % 10 * 0.1, k / 10 % 10 * 0.1, k / 100 * 0.1}));
    }
    EXPECT_EQ(met.size(), bins.count());
    EXPECT_EQ(*met.rbegin(), bins.count() - 1);
    EXPECT_EQ(bins.bin_of({1, 1, 1}), bins.count() - 1); // rounding puts points on the far face
    EXPECT_EQ(bins.bin_of({-1e-17, -1e-17, -1e-17}), 0U);
}

TEST(Bins, ABoxReachesIntoThoseOfAllItsPointsWithTheirPeriods) {
    const Vec3 low{-1.3, 0.35, 0.1}, high{0.4, 0.36, 2.05};
    std::set<std::pair<std::size_t, Image>> expected, visited;
    constexpr int steps = 200; // finer than the bins
    for (int i = 0; i <= steps; ++i) {
        for (int j = 0; j <= steps; ++j) {
            const double x = low.x + i * (high.x - low.x) / steps, z = low.z + j * (high.z - low.z) / steps;
            const Image period{static_cast<int>(std::floor(x)), 0, static_cast<int>(std::floor(z))};
            expected.emplace(bins.bin_of({x - period.a, low.y, z - period.c}), period);
        }
    }
    std::size_t visits = 0;
    bins.for_each(low, high, [&](std::size_t bin, const Image& period) {
        visited.emplace(bin, period);
        ++visits;
    });
    EXPECT_EQ(visited, expected);
    EXPECT_EQ(visits, expected.size()); // each once
}

TEST(Bins, ASearchEndsAtTheFirstThatIsWanted) {
    int calls = 0;
    const auto is_third = [&](std::size_t, const Image&) { return ++calls == 3; };
    EXPECT_TRUE(bins.any_of({0, 0, 0}, {0.9, 0.9, 0.9}, is_third));
    EXPECT_EQ(calls, 3);
    EXPECT_FALSE(bins.any_of({0, 0, 0}, {0.9, 0.9, 0.9}, [](std::size_t, const Image&) { return false; }));
}

} // namespace
} // namespace suffuse::cell
