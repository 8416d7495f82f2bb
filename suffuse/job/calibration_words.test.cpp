#include "suffuse/job/calibration_words.hpp"

#include <gtest/gtest.h>

namespace suffuse::job {
namespace {

using nlohmann::json;

json parameter(double best, double low, double high, const char* unit, double size) {
    return {{"best", best}, {"low", low},        {"high", high},      {"range", {0.1 * low, 10 * high}},
            {"unit", unit}, {"unit_size", size}, {"identified", true}};
}

json answer() {
    return {
        {"parameters",
         {{"contact.friction", parameter(0.5236, 0.4363, 0.6109, "deg", 0.01745329)},
          {"contact.modulus", parameter(4.14e9, 3.1e9, 5.7e9, "GPa", 1e9)},
          {"void_ratio.low", parameter(0.6, 0.58, 0.62, "", 1)}}},
        {"fit", {{{"target", "low"}, {"curves", {{{"quantity", "stress_ratio"}, {"relative_misfit", 0.05}}}}}}},
        {"rounds", {{{"samples", 16}, {"failed", 1}}}}};
}

TEST(CalibrationWords, SayTheParametersWithTheirIntervalsInTheUnitsOfTheCase) {
    EXPECT_EQ(
        verdict_of(answer()),
        std::vector<std::string>{"The tests give friction 30° (25 to 35°), modulus 4.14 GPa (3.1 to 5.7 GPa) and void "
                                 "ratio of low 0.6 (0.58 to 0.62)."}
    );
    EXPECT_TRUE(doubts_on(answer()).empty());
}

TEST(CalibrationWords, NameWhatTheTestsLeaveOpen) {
    json found = answer();
    found["parameters"]["contact.friction"]["identified"] = false;
    ASSERT_EQ(verdict_of(found).size(), 2U);
    EXPECT_EQ(verdict_of(found)[1], "They do not identify friction.");
    found["parameters"]["void_ratio.low"]["identified"] = false;
    EXPECT_EQ(verdict_of(found)[1], "They do not identify friction or void ratio of low.");
    for (json& each : found["parameters"]) {
        each["identified"] = false;
    }
    EXPECT_EQ(verdict_of(found), std::vector<std::string>{"These tests identify none of the parameters."});
}

TEST(CalibrationWords, DoubtBoundsLargeMisfitsAndManyFailures) {
    json found = answer();
    found["parameters"]["contact.modulus"]["bound"] = "high";
    found["fit"][0]["curves"][0]["relative_misfit"] = 0.5;
    found["rounds"][0]["failed"] = 8;
    const std::vector<std::string> doubts = doubts_on(found);
    ASSERT_EQ(doubts.size(), 3U);
    EXPECT_EQ(doubts[0], "Modulus is at the upper end of its range, 57 GPa: raise it, or distrust the model.");
    EXPECT_NE(doubts[1].find("miss the stress ratio of low by 50 %"), std::string::npos);
    EXPECT_EQ(doubts[2].rfind("8 of 16 samples failed", 0), 0U);
}

} // namespace
} // namespace suffuse::job
