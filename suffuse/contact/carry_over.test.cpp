#include "suffuse/contact/carry_over.hpp"

#include "suffuse/base/random.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace suffuse::contact {
namespace {

using neighbors::Pair;

/// Adds a contact whose memory is given by one number.
void add(Contacts& contacts, const Pair& pair, double mark, bool touching = true) {
    contacts.first.push_back(pair.first);
    contacts.second.push_back(pair.second);
    contacts.image.push_back(pair.image);
    contacts.shear_force.push_back(touching ? Vec3{mark, 2 * mark, 0} : Vec3{});
    contacts.bending.push_back(touching ? Vec3{0, mark, 3 * mark} : Vec3{});
    contacts.normal.push_back(touching ? Vec3{0, 0, 1} : Vec3{});
    contacts.overlap.push_back(touching ? 0.1 * mark : 0);
}

Contacts three_contacts() {
    Contacts contacts;
    add(contacts, {0, 1, {}}, 1);
    add(contacts, {0, 2, {}}, 2, false);
    add(contacts, {1, 2, {1, 0, 0}}, 3);
    return contacts;
}

Contacts carried(Contacts table, const std::vector<Pair>& pairs, const OptionalMemory& memory = {}) {
    carry_over(table, neighbors::PairList(pairs, 10), {}, memory);
    return table;
}

TEST(CarryOver, KeepsTheMemoryOfKnownPairsAndGivesNoneToNewOnes) {
    const std::vector<Pair> pairs{{0, 1, {}}, {0, 3, {}}, {1, 2, {1, 0, 0}}};
    const Contacts table = carried(three_contacts(), pairs);
    ASSERT_EQ(table.size(), 3U);
    EXPECT_EQ(table.shear_force[0], (Vec3{1, 2, 0}));
    EXPECT_EQ(table.overlap[0], 0.1);
    EXPECT_FALSE(table.touches(1));
    EXPECT_EQ(table.shear_force[1], Vec3{});
    EXPECT_EQ(table.bending[2], (Vec3{0, 3, 9}));
}

TEST(CarryOver, NeverDropsATouchingPairAndDropsTheOthers) {
    const Contacts table = carried(three_contacts(), {{2, 5, {}}});
    EXPECT_EQ(table.first, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(table.second, (std::vector<std::uint32_t>{1, 2, 5}));
    EXPECT_EQ(touching_rows(three_contacts()).size(), 2U);
}

TEST(CarryOver, DistinguishesPairsByTheirImage) {
    const Contacts table = carried(three_contacts(), {{1, 2, {}}, {1, 2, {1, 0, 0}}});
    ASSERT_EQ(table.size(), 3U); // (0,1) touches and stays
    EXPECT_FALSE(table.touches(1));
    EXPECT_TRUE(table.touches(2));
}

TEST(CarryOver, BringsOptionalColumnsOnRequestAndWithoutBonds) {
    const Contacts table = carried(three_contacts(), {}, {true, true});
    EXPECT_EQ(table.twisting.size(), 2U);
    EXPECT_EQ(table.bonded, (std::vector<std::uint8_t>{0, 0}));
    EXPECT_EQ(optional_memory(table), (OptionalMemory{true, true}));
    EXPECT_EQ(optional_memory(three_contacts()), OptionalMemory{});
}

TEST(CarryOver, OfLongTablesGivesEveryPairItsOwnMemoryAgainAndAgain) {
    // The same storage through many lists, against a dictionary from pairs to their marks. The grains lie so far apart
    // that a table is merged in several runs.
    constexpr std::uint32_t grains = 60 * 70;
    RandomStream random(3, "tables");
    Contacts table;
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> marks; // of the touching pairs
    double next_mark = 1;
    for (int round = 0; round < 30; ++round) {
        std::vector<Pair> pairs;
        for (std::uint32_t i = 0; i < grains; i += 70) {
            for (std::uint32_t j = i + 70; j < grains; j += 70) {
                if (random.uniform() < 0.1) {
                    pairs.push_back({i, j, {}});
                }
            }
        }
        carry_over(table, neighbors::PairList(pairs, grains), {}, {});
        std::set<std::pair<std::uint32_t, std::uint32_t>> wanted;
        for (const Pair& pair : pairs) {
            wanted.insert({pair.first, pair.second});
        }
        for (const auto& [pair, mark] : marks) {
            wanted.insert(pair);
        }
        ASSERT_EQ(table.size(), wanted.size());
        auto want = wanted.begin();
        for (std::size_t c = 0; c < table.size(); ++c, ++want) {
            ASSERT_EQ((std::pair{table.first[c], table.second[c]}), *want);
            const auto mark = marks.find(*want);
            ASSERT_EQ(table.shear_force[c].x, mark == marks.end() ? 0 : mark->second);
            ASSERT_EQ(table.bending[c].z, mark == marks.end() ? 0 : 3 * mark->second);
            ASSERT_EQ(table.touches(c), mark != marks.end());
            // Some contacts open, some begin.
            const double draw = random.uniform();
            if (draw < 0.3) {
                marks.erase(*want);
                table.shear_force.set(c, {}), table.bending.set(c, {}), table.normal.set(c, {}), table.overlap[c] = 0;
            } else if (draw < 0.6) {
                marks[*want] = ++next_mark;
                table.shear_force.set(c, {next_mark, 2 * next_mark, 0});
                table.bending.set(c, {0, next_mark, 3 * next_mark});
                table.normal.set(c, {0, 0, 1});
            }
        }
    }
}

TEST(CarryOver, PartsATableAndJoinsItAgain) {
    for (const bool is_bonded : {false, true}) {
        Contacts whole = three_contacts();
        whole.bonded.resize(is_bonded ? 3 : 0, 1);
        const Contacts middle = chosen_rows(whole, std::vector<std::uint8_t>{0, 1, 0});
        const Contacts ends = chosen_rows(whole, std::vector<std::uint8_t>{1, 0, 1});
        EXPECT_EQ(middle.second, (std::vector<std::uint32_t>{2}));
        EXPECT_EQ(ends.shear_force[1], (Vec3{3, 6, 0}));
        const Contacts again = joined(ends, middle);
        EXPECT_EQ(again.first, whole.first);
        EXPECT_EQ(again.second, whole.second);
        EXPECT_EQ(again.image, whole.image);
        EXPECT_EQ(again.shear_force.y, whole.shear_force.y);
        EXPECT_EQ(again.bending.z, whole.bending.z);
        EXPECT_EQ(again.overlap, whole.overlap);
        EXPECT_EQ(again.bonded, whole.bonded);
    }
}

TEST(CarryOver, JoinsTablesOfWhichOneHasNoBonds) {
    Contacts bonded;
    add(bonded, {0, 3, {}}, 4);
    bonded.bonded = {1};
    EXPECT_EQ(joined(three_contacts(), bonded).bonded, (std::vector<std::uint8_t>{0, 0, 1, 0}));
    EXPECT_EQ(joined(bonded, three_contacts()).bonded, (std::vector<std::uint8_t>{0, 0, 1, 0}));
}

TEST(Renumbering, TurnsSignsAroundWhereTheOrderOfTwoGrainsTurns) {
    const std::vector<std::uint32_t> new_row{2, 0, 1};
    const Contacts table = renumbered(three_contacts(), new_row);
    ASSERT_EQ(table.size(), 3U);
    // (1,2) -> (0,1) keeps its order, (0,1) -> (2,0) turns around and so does its image.
    EXPECT_EQ(table.first, (std::vector<std::uint32_t>{0, 0, 1}));
    EXPECT_EQ(table.second, (std::vector<std::uint32_t>{1, 2, 2}));
    EXPECT_EQ(table.shear_force[0], (Vec3{3, 6, 0}));
    EXPECT_EQ(table.image[0], (cell::Image{1, 0, 0}));
    EXPECT_EQ(table.shear_force[1], (Vec3{-1, -2, 0}));
    EXPECT_EQ(table.normal[1], (Vec3{0, 0, -1}));
    EXPECT_EQ(table.overlap[1], 0.1); // a length keeps its sign
}

TEST(Renumbering, ThereAndBackIsNoChangeAtAll) {
    const std::vector<std::uint32_t> there{2, 0, 1}, back{1, 2, 0};
    const Contacts start = three_contacts(), end = renumbered(renumbered(start, there), back);
    EXPECT_EQ(end.first, start.first);
    EXPECT_EQ(end.image, start.image);
    EXPECT_EQ(end.shear_force.y, start.shear_force.y);
    EXPECT_EQ(end.bending.z, start.bending.z);
    EXPECT_EQ(end.overlap, start.overlap);
}

TEST(Renumbering, TakesTheContactsOfRemovedGrainsAway) {
    const std::vector<std::uint32_t> new_row{removed_row, 0, 1};
    const Contacts table = renumbered(three_contacts(), new_row);
    ASSERT_EQ(table.size(), 1U);
    EXPECT_EQ(table.first[0], 0U);
    EXPECT_EQ(table.second[0], 1U);
    EXPECT_EQ(table.shear_force[0], (Vec3{3, 6, 0}));
}

} // namespace
} // namespace suffuse::contact
