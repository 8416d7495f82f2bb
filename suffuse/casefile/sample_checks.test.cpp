#include "suffuse/casefile/sample_checks.hpp"

#include "suffuse/casefile/case_for_tests.hpp"
#include "suffuse/gradings/read_grading.hpp"

#include <gtest/gtest.h>

#include "tests/support/reference.hpp"

namespace {

using namespace suffuse;
using namespace suffuse::casefile;
using namespace suffuse::casefile::testing;

/// Of grains, in "… about 12,300 grains …".
int advised_number(const Diagnostic& diagnostic) {
    std::string number = diagnostic.help.substr(diagnostic.help.find("about ") + 6);
    std::erase(number, ',');
    return std::stoi(number);
}

// 10,000 grains of this grading, settled at 100 kPa at a porosity of 0.4022 by the reference, make a cell of 3.895 mm;
// the estimate takes 0.4 and a curve where the reference has size classes: 2 % covers both.
TEST(SampleChecks, CellWidthMeetsTheReferencesSample) {
    grains::Soil soil;
    soil.whole = gradings::read_grading(test::in_checkout("examples/fontainebleau-2016/data/fontainebleau.csv"));
    EXPECT_NEAR(width_in_grains(soil, 10'000), 3.895 / 0.4, 0.02 * 3.895 / 0.4);
    EXPECT_NEAR(width_in_grains(soil, 80'000) / width_in_grains(soil, 10'000), 2, 1e-12); // cube root of 8
}

TEST(SampleChecks, ASampleTooSmallForItsLargestGrainIsAnError) {
    const Diagnostic found = find_problem(problems_of(replaced(good_case, "20000", "50")), "E601");
    EXPECT_EQ(found.line, 7);
    EXPECT_EQ(found.column, 13);
    EXPECT_NE(found.message.find("too small for its largest grain"), std::string::npos);
    EXPECT_NE(found.help.find("grains"), std::string::npos);
}

TEST(SampleChecks, TheNumberOfGrainsThatIsAdvisedIsEnough) {
    const Diagnostic found = find_problem(problems_of(replaced(good_case, "20000", "2000")), "W602");
    EXPECT_TRUE(found.is_warning);
    const int enough = advised_number(found);
    EXPECT_EQ(problems_of(replaced(good_case, "20000", std::to_string(enough))).size(), 0U);
    EXPECT_EQ(problems_of(replaced(good_case, "20000", std::to_string(enough - 200))).size(), 1U);
}

TEST(SampleChecks, FewFinesOrFewCoarseGrainsAreDoubtful) {
    // Of 20,000 grains from 0.1 to 0.4 mm, linear in log size, those below 0.1001 mm are a handful by number.
    const std::string few = replaced(good_case, "0.15 mm", "0.1001 mm");
    EXPECT_EQ(find_problem(problems_of(few), "W607").code, ""); // nothing is to leave
    const Diagnostic found = find_problem(problems_of(few + erode_stage), "W607");
    EXPECT_TRUE(found.is_warning) << found.message;
    EXPECT_EQ(found.line, 7);
    EXPECT_TRUE(find_problem(problems_of(replaced(good_case, "0.15 mm", "0.39 mm") + erode_stage), "W607").is_warning);
    EXPECT_EQ(problems_of(good_case + erode_stage).size(), 0U);
}

TEST(SampleChecks, GrainsThatCannotBeDrawnAreReportedBeforeTheRun) {
    const Diagnostic outside = find_problem(problems_of(replaced(good_case, "0.15 mm", "1 mm")), "E606");
    EXPECT_EQ(outside.line, 4); // where the size is requested
    EXPECT_EQ(outside.column, 24);
    EXPECT_NE(outside.message.find("leaves no fines or no skeleton"), std::string::npos);
    const Diagnostic few =
        find_problem(problems_of(replaced(good_case, "psd =", "grading_tolerance = \"0.01 %\"\npsd =")), "E606");
    EXPECT_EQ(few.line, 8);
    EXPECT_NE(few.message.find("particles"), std::string::npos);
    EXPECT_NE(few.help.find("--surrogate"), std::string::npos) << few.help;
    EXPECT_EQ(outside.help.find("--surrogate"), std::string::npos) << outside.help;
}

TEST(SampleChecks, ASkeletonThatWillBeTooNarrowToErodeIsReportedBeforeTheRun) {
    const std::string coarse = replaced(good_case, "0.15 mm", "0.3 mm");
    const auto with = [&](int particles) { return replaced(coarse, "20000", std::to_string(particles)) + erode_stage; };
    const Diagnostic found = find_problem(problems_of(with(1000)), "W610");
    EXPECT_TRUE(found.is_warning);
    EXPECT_EQ(found.line, 7);
    EXPECT_EQ(find_problem(problems_of(replaced(coarse, "20000", "1000")), "W610").code, ""); // nothing is eroded
    const int enough = advised_number(found);
    EXPECT_EQ(find_problem(problems_of(with(enough)), "W610").code, "") << found.help;
    EXPECT_EQ(find_problem(problems_of(with(enough * 9 / 10)), "W610").line, 7);
}

TEST(SampleChecks, ACellThatASampleSizeMakesTooNarrowIsReportedAtThatKey) {
    std::string text = replaced(good_case, "particles = 20000", "sample_size = { coarse_grains = 100 }");
    text = replaced(text, "psd = \"data/sand.csv\"", "coarse = { psd = \"data/sand.csv\" }");
    text = replaced(
        text, "fines = { finer_than = \"0.15 mm\" }", "fines = { psd = \"data/silt.csv\" }\nfines_content = \"10 %\""
    );
    const Diagnostic found = find_problem(problems_of(text), "W602");
    EXPECT_EQ(found.line, 8) << found.message;
}

TEST(SampleChecks, OnlyTheNarrowestVariantIsReported) {
    const auto list = problems_of(replaced(good_case, "20000", "20000\nsweep = { particles = [3000, 2000, 30000] }"));
    ASSERT_EQ(list.size(), 1U) << render(list);
    EXPECT_EQ(list[0].code, "W602");
    EXPECT_NE(list[0].message.find("one/particles=2000 is the narrowest"), std::string::npos) << list[0].message;
}

} // namespace
