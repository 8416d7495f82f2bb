#include "suffuse/base/random.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace suffuse {
namespace {

TEST(Random, PhiloxMeetsTheKnownAnswersOfItsAuthors) { // kat_vectors of Random123, philox 4x32 with ten rounds
    EXPECT_EQ(philox4x32({0, 0, 0, 0}, {0, 0}), (PhiloxCounter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
    EXPECT_EQ(
        philox4x32({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
        (PhiloxCounter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd})
    );
    EXPECT_EQ(
        philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
        (PhiloxCounter{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1})
    );
}

TEST(Random, StreamsDifferBySeedPurposeAndIndexAndRepeatThemselves) {
    const auto first = [](std::uint64_t seed, const char* purpose, std::uint64_t index) {
        return RandomStream(seed, purpose, index).uniform();
    };
    const double value = first(1, "cloud", 2);
    EXPECT_EQ(value, first(1, "cloud", 2));
    EXPECT_NE(value, first(2, "cloud", 2));
    EXPECT_NE(value, first(1ULL + (1ULL << 32), "cloud", 2));
    EXPECT_NE(value, first(1, "probe", 2));
    EXPECT_NE(value, first(1, "cloud", 3));
    EXPECT_NE(value, first(1, "cloud", 2ULL + (1ULL << 32)));
}

TEST(Random, UniformFillsTheUnitIntervalEvenly) {
    constexpr int draws = 100000, bins = 10;
    std::vector<int> count(bins, 0);
    RandomStream stream(7, "test");
    for (int k = 0; k < draws; ++k) {
        const double u = stream.uniform();
        ASSERT_TRUE(u >= 0 && u < 1);
        ++count[static_cast<std::size_t>(u * bins)];
    }
    double chi2 = 0;
    for (const int n : count) {
        chi2 += (n - draws / bins) * (n - draws / bins) / (1.0 * draws / bins);
    }
    EXPECT_LT(chi2, 27.9); // 0.1 % quantile of chi-square with nine degrees of freedom; the seed is fixed
    EXPECT_GT(chi2, 1.2);  // and the other side: too even would not be random either
}

TEST(Random, NormalHasMeanZeroVarianceOneAndNoSkew) {
    constexpr int draws = 100000;
    RandomStream stream(7, "normal");
    double sum = 0, square = 0, cube = 0;
    for (int k = 0; k < draws; ++k) {
        const double v = stream.normal();
        sum += v, square += v * v, cube += v * v * v;
    }
    // Four standard errors: 1/sqrt(n), sqrt(2/n), sqrt(15/n).
    EXPECT_NEAR(sum / draws, 0, 4 * std::sqrt(1.0 / draws));
    EXPECT_NEAR(square / draws, 1, 4 * std::sqrt(2.0 / draws));
    EXPECT_NEAR(cube / draws, 0, 4 * std::sqrt(15.0 / draws));
}

} // namespace
} // namespace suffuse
