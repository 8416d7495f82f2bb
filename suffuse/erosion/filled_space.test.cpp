#include "suffuse/erosion/filled_space.hpp"

#include <gtest/gtest.h>

#include <sys/resource.h>

namespace suffuse::erosion {
namespace {

/// Most memory that the program has held so far [kB].
long peak_memory() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    return used.ru_maxrss;
}

TEST(FilledSpace, TakesMemoryForItsGrainsNotForTheirSizeRatio) {
    constexpr double ratio = 30;
    constexpr long little = 100'000; // [kB]; bins as small as the fines took 1.2 GB
    const long before = peak_memory();
    FilledSpace space(diagonal({10, 10, 10}), 1 / ratio, 1000);
    std::uint32_t g = 0;
    for (double x = 0.5; x < 10; ++x) { // coarse ones that touch
        for (double y = 0.5; y < 10; ++y) {
            for (double z = 0.5; z < 10; ++z) {
                space.fill({x, y, z}, 0.5, g++);
            }
        }
    }
    EXPECT_LT(peak_memory() - before, little);
    EXPECT_TRUE(space.is_free({1, 1, 1}, 0.5 / ratio, 1000));
    EXPECT_FALSE(space.is_free({1, 1, 0.75}, 0.5 / ratio + 0.25, 1000));
    EXPECT_FALSE(space.is_free({10.5, -0.5, 0.5}, 0.5 / ratio, 1000)); // the image of a grain
    space.clear({0.5, 9.5, 0.5}, 0.5, 90);
    EXPECT_TRUE(space.is_free({10.5, -0.5, 0.5}, 0.5 / ratio, 1000));
}

} // namespace
} // namespace suffuse::erosion
