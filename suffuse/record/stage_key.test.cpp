#include "suffuse/record/stage_key.hpp"

#include "suffuse/casefile/case_for_tests.hpp"

#include <gtest/gtest.h>

namespace suffuse::record {
namespace {

using casefile::Case;
using casefile::Variant;

/// Keys of the first stages of `full_case`'s study "main", after a change.
template <class Change>
std::string after(Change change, std::size_t stage = 0, const std::string& start_state = "") {
    Case what = casefile::testing::load(casefile::testing::full_case);
    change(what, what.studies[0].variants[0]);
    const Variant& variant = what.studies[0].variants[0];
    return key_of_stage(what, variant, variant.stages[stage], start_state);
}

void leave(Case&, Variant&) {}

TEST(StageKey, EverythingThatDecidesTheNumbersOfAStageChangesItAndNoNameDoes) {
    const std::string key = after(leave);
    EXPECT_EQ(compare_keys(key, after(leave)), SameStage::Yes);
    EXPECT_EQ(compare_keys(key, after([](Case&, Variant& v) { ++v.seed; })), SameStage::No);
    EXPECT_EQ(compare_keys(key, after([](Case&, Variant& v) { v.material.modulus *= 1.01; })), SameStage::No);
    EXPECT_EQ(compare_keys(key, after([](Case&, Variant& v) { ++v.particles; })), SameStage::No);
    EXPECT_EQ(compare_keys(key, after([](Case& c, Variant&) { c.balance.patience += 1; })), SameStage::No);
    EXPECT_EQ(compare_keys(key, after(leave, 0, "0123456789abcdef")), SameStage::No);
    EXPECT_EQ(compare_keys(key, after(leave, 1)), SameStage::No);
    EXPECT_EQ(compare_keys(key, after([](Case&, Variant& v) { v.stages[0].name = "other"; })), SameStage::Yes);
    EXPECT_EQ(compare_keys(key, after([](Case& c, Variant&) { c.title = "other"; })), SameStage::Yes);
}

TEST(StageKey, ContentsOfImportedFilesChangeIt) {
    Case what = casefile::testing::load(casefile::testing::full_case);
    Variant& variant = what.studies[0].variants[0];
    variant.stages[0].spec = casefile::ImportSpec{.path = "/packings/p.csv"};
    const auto key = [&](const Sums& files) { return key_of_stage(what, variant, variant.stages[0], "", files); };
    const Sums one = {{"packing", std::string(64, '1')}}, other = {{"packing", std::string(64, '2')}};
    EXPECT_EQ(compare_keys(key(one), key(one)), SameStage::Yes);
    EXPECT_EQ(compare_keys(key(one), key(other)), SameStage::No);
    EXPECT_EQ(compare_keys(key({}), key(one)), SameStage::No) << "of a version that did not record them";
}

TEST(StageKey, OfAnotherFormOrNoneCannotBeCompared) {
    const std::string key = after(leave);
    EXPECT_EQ(compare_keys("", key), SameStage::Unknown);
    EXPECT_EQ(compare_keys("00000000" + key.substr(8), key), SameStage::Unknown);
    EXPECT_EQ(key.size(), 8 + 1 + 64U);
}

} // namespace
} // namespace suffuse::record
