#include "suffuse/neighbors/pair_list.hpp"

#include <gtest/gtest.h>

namespace suffuse::neighbors {
namespace {

TEST(PairList, GivesBackThePairsThatItWasMadeFrom) {
    const std::vector<Pair> pairs{
        {0, 2, {0, 0, 0}}, {0, 2, {1, 0, -3}}, {2, 2, {0, 1, 0}}, {2, 3, {0, 0, 0}}, {3, 4, {1, 0, -3}}};
    const PairList list(pairs, 6); // grain 1 comes first in no pair, nor does grain 5
    ASSERT_EQ(list.size(), pairs.size());
    std::vector<Pair> found;
    list.for_each_of(0, list.grains(), [&](std::size_t k, const Pair& pair) {
        EXPECT_EQ(k, found.size());
        found.push_back(pair);
    });
    EXPECT_EQ(found, pairs);
}

TEST(PairList, OfSomeFirstGrainsCountsAllPairs) {
    const std::vector<Pair> pairs{{0, 1, {}}, {1, 2, {}}, {1, 3, {}}, {2, 3, {}}};
    const PairList list(pairs, 4);
    std::vector<std::size_t> rows;
    list.for_each_of(1, 3, [&](std::size_t k, const Pair& pair) {
        EXPECT_EQ(pair, pairs[k]);
        rows.push_back(k);
    });
    EXPECT_EQ(rows, (std::vector<std::size_t>{1, 2, 3}));
}

TEST(PairList, WithoutPairsHasNothingToVisit) {
    const PairList none;
    EXPECT_EQ(none.grains(), 0);
    none.for_each_of(0, none.grains(), [](std::size_t, const Pair&) { FAIL(); });
}

} // namespace
} // namespace suffuse::neighbors
