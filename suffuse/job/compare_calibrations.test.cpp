#include "suffuse/job/compare_calibrations.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/record/folder.hpp"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"

namespace suffuse::job {
namespace {

using nlohmann::json;

json answer(double friction) {
    const json parameter = {
        {"best", friction}, {"low", friction - 0.02}, {"high", friction + 0.02}, {"unit", "deg"}, {"unit_size", 0.5}};
    return {
        {"title", "sand"},
        {"soil", "sand"},
        {"seed", 1},
        {"particles", 500},
        {"complete", true},
        {"parameters", {{"contact.friction", parameter}}},
        {"fit", {{{"target", "low"}, {"curves", {{{"quantity", "stress_ratio"}, {"relative_misfit", 0.1}}}}}}},
        {"held_out", json::array()}};
}

class CompareCalibrations : public testing::Test {
protected:
    record::Comparison compared(const json& first, const json& second, double tolerance = 0) {
        for (const auto& [name, content] : {std::pair("a", first), {"b", second}}) {
            std::filesystem::create_directories(folder / name);
            record::write_json(folder / name / "calibration.json", content);
        }
        return compare_calibrations(folder / "a", folder / "b", tolerance);
    }

    test::TempFolder folder;
};

TEST_F(CompareCalibrations, EqualOnesDifferInNothing) {
    const record::Comparison found = compared(answer(0.5), answer(0.5));
    EXPECT_TRUE(found.differences.empty());
    EXPECT_TRUE(found.circumstances.empty());
    EXPECT_EQ(found.numbers, 4);
}

TEST_F(CompareCalibrations, NumbersAreInTheUnitOfTheFirstOneAndIntervalsThatDoNotOverlapAreNamed) {
    json other = answer(0.6);
    other["parameters"]["contact.friction"]["unit"] = "rad";
    other["parameters"]["contact.friction"]["unit_size"] = 1;
    const record::Comparison found = compared(answer(0.5), other);
    ASSERT_EQ(found.differences.size(), 3U);
    const auto best =
        std::ranges::find(found.differences, "contact.friction, likeliest [deg]", &record::Difference::where);
    ASSERT_NE(best, found.differences.end());
    EXPECT_EQ(best->first, "1");
    EXPECT_EQ(best->second, "1.2");
    EXPECT_NEAR(best->relative, 1.0 / 6, 1e-12);
    EXPECT_EQ(found.circumstances, std::vector<std::string>{"contact.friction: the intervals do not overlap"});
    EXPECT_TRUE(compared(answer(0.5), other, 0.5).differences.empty());
}

TEST_F(CompareCalibrations, WhatOneOfThemLacksComesFirst) {
    json other = answer(0.51);
    other["seed"] = 2;
    other["parameters"]["void_ratio"] = {{"best", 0.6}, {"low", 0.5}, {"high", 0.7}, {"unit", ""}, {"unit_size", 1}};
    const record::Comparison found = compared(answer(0.5), other);
    ASSERT_EQ(found.differences.size(), 6U);
    EXPECT_EQ(found.differences[0].about, record::Relevance::Presence);
    EXPECT_EQ(found.differences[0].first, "missing");
    EXPECT_EQ(found.circumstances, std::vector<std::string>{"seed: 1 and 2"});
}

TEST_F(CompareCalibrations, OneWithoutAnAnswerIsNamed) {
    std::filesystem::create_directories(folder / "empty");
    EXPECT_THROW(compare_calibrations(folder / "empty", folder / "empty", 0), IoError);
}

} // namespace
} // namespace suffuse::job
