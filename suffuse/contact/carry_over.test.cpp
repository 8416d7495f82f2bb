#include "suffuse/contact/carry_over.hpp"

#include <gtest/gtest.h>

namespace suffuse::contact {
namespace {

using neighbors::Pair;

/// Adds a contact whose memory is told by one number.
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

TEST(CarryOver, KeepsTheMemoryOfKnownPairsAndGivesNoneToNewOnes) {
    const std::vector<Pair> pairs{{0, 1, {}}, {0, 3, {}}, {1, 2, {1, 0, 0}}};
    Contacts table;
    carry_over(three_contacts(), pairs, {}, table);
    ASSERT_EQ(table.size(), 3U);
    EXPECT_EQ(table.shear_force[0], (Vec3{1, 2, 0}));
    EXPECT_EQ(table.overlap[0], 0.1);
    EXPECT_FALSE(table.touches(1));
    EXPECT_EQ(table.shear_force[1], Vec3{});
    EXPECT_EQ(table.bending[2], (Vec3{0, 3, 9}));
}

TEST(CarryOver, NeverDropsATouchingPairAndDropsTheOthers) {
    Contacts table;
    carry_over(three_contacts(), std::vector<Pair>{{2, 5, {}}}, {}, table);
    EXPECT_EQ(table.first, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(table.second, (std::vector<std::uint32_t>{1, 2, 5}));
    EXPECT_EQ(touching_rows(three_contacts()).size(), 2U);
}

TEST(CarryOver, TellsPairsApartByTheirImage) {
    Contacts table;
    carry_over(three_contacts(), std::vector<Pair>{{1, 2, {}}, {1, 2, {1, 0, 0}}}, {}, table);
    ASSERT_EQ(table.size(), 3U); // (0,1) touches and stays
    EXPECT_FALSE(table.touches(1));
    EXPECT_TRUE(table.touches(2));
}

TEST(CarryOver, BringsOptionalColumnsWhenAskedAndWithoutBonds) {
    Contacts table;
    carry_over(three_contacts(), {}, {true, true}, table);
    EXPECT_EQ(table.twisting.size(), 2U);
    EXPECT_EQ(table.bonded, (std::vector<std::uint8_t>{0, 0}));
    EXPECT_EQ(optional_memory(table), (OptionalMemory{true, true}));
    EXPECT_EQ(optional_memory(three_contacts()), OptionalMemory{});
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
