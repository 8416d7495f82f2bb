#include "suffuse/casefile/physics_checks.hpp"

#include "suffuse/casefile/case_for_tests.hpp"
#include "suffuse/casefile/read_grading.hpp"

#include <gtest/gtest.h>

#include "tests/support/reference.hpp"

namespace {

using namespace suffuse;
using namespace suffuse::casefile;
using namespace suffuse::casefile::testing;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

// 10,000 grains of this grading, settled at 100 kPa at a porosity of 0.4022 by the reference, make a cell of 3.895 mm;
// the estimate takes 0.4 and a curve where the reference has size classes: 2 % covers both.
TEST(PhysicsChecks, CellWidthMeetsTheReferencesSample) {
    grains::Soil soil;
    soil.whole = read_grading(test::in_checkout("examples/fontainebleau-2016/data/fontainebleau.csv"));
    EXPECT_NEAR(width_in_grains(soil, 10'000), 3.895 / 0.4, 0.02 * 3.895 / 0.4);
    EXPECT_NEAR(width_in_grains(soil, 80'000) / width_in_grains(soil, 10'000), 2, 1e-12); // cube root of 8
}

TEST(PhysicsChecks, ASampleTooSmallForItsLargestGrainIsAnError) {
    const Diagnostic found = find_problem(problems_of(replaced(good_case, "20000", "50")), "E601");
    EXPECT_EQ(found.line, 7);
    EXPECT_EQ(found.column, 13);
    EXPECT_NE(found.message.find("too small for its largest grain"), std::string::npos);
    EXPECT_NE(found.help.find("grains"), std::string::npos);
}

TEST(PhysicsChecks, TheNumberOfGrainsThatIsAdvisedIsEnough) {
    const Diagnostic found = find_problem(problems_of(replaced(good_case, "20000", "2000")), "W602");
    EXPECT_TRUE(found.is_warning);
    std::string number = found.help.substr(found.help.find("about ") + 6);
    std::erase(number, ',');
    EXPECT_EQ(problems_of(replaced(good_case, "20000", std::to_string(std::stoi(number)))).size(), 0U);
    EXPECT_EQ(problems_of(replaced(good_case, "20000", std::to_string(std::stoi(number) - 200))).size(), 1U);
}

// Settled at 100 kPa with 356 MPa, the reference's grains overlap by some thousandths of their radius.
TEST(PhysicsChecks, OverlapIsOfTheRightOrder) {
    EXPECT_GT(overlap_at(1e5, 356e6), 0.5e-3);
    EXPECT_LT(overlap_at(1e5, 356e6), 5e-3);
}

TEST(PhysicsChecks, APressureThatSqueezesGrainsIsDoubtfulThenAnError) {
    EXPECT_EQ(problems_of(good_case).size(), 0U);
    EXPECT_EQ(find_problem(problems_of(replaced(good_case, "100 kPa", "2 MPa")), "W603").line, 14);
    const Diagnostic found = find_problem(problems_of(replaced(good_case, "100 kPa", "20 MPa")), "E603");
    EXPECT_EQ(found.column, 12);
    EXPECT_NE(found.help.find("modulus"), std::string::npos);
}

TEST(PhysicsChecks, FineGrainsBetweenMuchCoarserOnesNeedAStifferContact) {
    EXPECT_DOUBLE_EQ(squeezed_overlap_at(2e5, 356e6, 8), 8 * squeezed_overlap_at(1e5, 356e6, 4));
    const std::string wide = replaced(
        replaced(
            good_case, "psd = \"data/sand.csv\"",
            "psd = { d = [\"0.1 mm\", \"1.2 mm\"], passing = [\"0 %\", \"100 %\"] }"
        ),
        "20000", "300000"
    );
    const Diagnostic found = find_problem(problems_of(wide), "W609");
    EXPECT_EQ(found.line, 14);
    const std::string advised =
        found.help.substr(found.help.find("of ") + 3, found.help.find(" makes") - found.help.find("of ") - 3);
    const std::string stiffer =
        replaced(wide, "schema = 1\n", "schema = 1\n[contact]\nmodulus = \"" + advised + "\"\n");
    EXPECT_EQ(find_problem(problems_of(stiffer), "W609").code, "");
    EXPECT_EQ(find_problem(problems_of(good_case), "W609").code, "");
}

TEST(PhysicsChecks, StressesOfOtherStagesAreCheckedToo) {
    const std::string head = good_case + "[[study.one.stage]]\nname = \"x\"\n";
    EXPECT_EQ(find_problem(problems_of(head + "do = \"settle\"\npressure = \"20 MPa\"\n"), "E603").line, 18);
    EXPECT_EQ(
        find_problem(problems_of(head + "do = \"settle\"\nstress = [\"20 MPa\", \"-\", \"-\"]\n"), "E603").line, 18
    );
}

TEST(PhysicsChecks, AGradientAboveTheCriticalOneIsDoubtful) {
    const std::string head = good_case + "[[study.one.stage]]\nname = \"x\"\ndo = \"flow\"\n";
    EXPECT_EQ(problems_of(head + "gradient = 0.9\n").size(), 0U);
    EXPECT_TRUE(find_problem(problems_of(head + "gradient = 1.1\n"), "W604").is_warning);
    EXPECT_EQ(find_problem(problems_of(head + "gradient = -1.1\n"), "W604").line, 18);
}

TEST(PhysicsChecks, TestsAndErosionNeedASampleThatCarriesAStress) {
    const std::string test = "[[study.one.stage]]\nname = \"x\"\ndo = \"triaxial\"\n";
    EXPECT_EQ(problems_of(good_case + test).size(), 0U);
    EXPECT_EQ(find_problem(problems_of(good_case + test + "from = \"cloud\"\n"), "E608").line, 17);
    const std::string import = R"(schema = 1
[[study.one.stage]]
name = "packing"
do = "import"
path = "packing.csv"
cell = ["1 cm", "1 cm", "1 cm"]
)";
    EXPECT_EQ(find_problem(problems_of(import + test), "E608").line, 9);
    for (const std::string verb : {"erode", "remove"}) {
        const std::string stage = "[[study.one.stage]]\nname = \"x\"\nfrom = \"cloud\"\ndo = \"" + verb + "\"\n";
        EXPECT_EQ(find_problem(problems_of(good_case + stage), "E608").line, 18) << verb;
    }
}

TEST(PhysicsChecks, ErosionNeedsFines) {
    const std::string erode = "[[study.one.stage]]\nname = \"x\"\ndo = \"erode\"\n";
    EXPECT_EQ(problems_of(good_case + erode).size(), 0U);
    EXPECT_EQ(
        find_problem(problems_of(replaced(good_case, "fines = { finer_than = \"0.15 mm\" }", "") + erode), "E605").line,
        17
    );
    const std::string two = replaced(
        replaced(
            good_case, "fines = { finer_than = \"0.15 mm\" }",
            "fines = { psd = \"data/silt.csv\" }\nfines_content = 0.0"
        ),
        "psd = \"data/sand.csv\"", "coarse = { psd = \"data/sand.csv\" }"
    );
    EXPECT_TRUE(find_problem(problems_of(two + erode), "W605").is_warning);
    // Of a packing from elsewhere, too: Kenney and Lau do not split this sand.
    const std::string imported = replaced(
        replaced(good_case, "{ finer_than = \"0.15 mm\" }", "\"kenney-lau\""), "do = \"pack\"",
        "do = \"import\"\npacking = \"packing.csv\"\ncell = [\"1 mm\", \"1 mm\", \"1 mm\"]"
    );
    EXPECT_NE(
        find_problem(problems_of(replaced(imported, "compact", "settle") + erode), "E605")
            .message.find("split does not exist"),
        std::string::npos
    );
}

TEST(PhysicsChecks, FewFinesOrFewCoarseGrainsAreDoubtful) {
    const std::string erode = "[[study.one.stage]]\nname = \"x\"\ndo = \"erode\"\n";
    // Of 20,000 grains from 0.1 to 0.4 mm, linear in log size, those below 0.1001 mm are a handful by number.
    const std::string few = replaced(good_case, "0.15 mm", "0.1001 mm");
    EXPECT_EQ(find_problem(problems_of(few), "W607").code, ""); // nothing is to leave
    const Diagnostic found = find_problem(problems_of(few + erode), "W607");
    EXPECT_TRUE(found.is_warning) << found.message;
    EXPECT_EQ(found.line, 7);
    EXPECT_TRUE(find_problem(problems_of(replaced(good_case, "0.15 mm", "0.39 mm") + erode), "W607").is_warning);
    EXPECT_EQ(problems_of(good_case + erode).size(), 0U);
}

TEST(PhysicsChecks, GrainsThatCannotBeDrawnAreReportedBeforeTheRun) {
    const Diagnostic outside = find_problem(problems_of(replaced(good_case, "0.15 mm", "1 mm")), "E606");
    EXPECT_EQ(outside.line, 7);
    EXPECT_NE(outside.message.find("leaves no fines or no skeleton"), std::string::npos);
    const Diagnostic few =
        find_problem(problems_of(replaced(good_case, "psd =", "grading_tolerance = \"0.01 %\"\npsd =")), "E606");
    EXPECT_EQ(few.line, 8);
    EXPECT_NE(few.message.find("particles"), std::string::npos);
}

TEST(PhysicsChecks, ASkeletonThatWillBeTooNarrowToErodeIsToldBeforeTheRun) {
    const std::string erode = "[[study.one.stage]]\nname = \"x\"\ndo = \"erode\"\n";
    const std::string coarse = replaced(good_case, "0.15 mm", "0.3 mm");
    const auto with = [&](int particles) { return replaced(coarse, "20000", std::to_string(particles)) + erode; };
    const Diagnostic found = find_problem(problems_of(with(1000)), "W610");
    EXPECT_TRUE(found.is_warning);
    EXPECT_EQ(found.line, 7);
    EXPECT_EQ(find_problem(problems_of(replaced(coarse, "20000", "1000")), "W610").code, ""); // nothing is eroded
    std::string number = found.help.substr(found.help.find("about ") + 6);
    std::erase(number, ',');
    const int enough = std::stoi(number);
    EXPECT_EQ(find_problem(problems_of(with(enough)), "W610").code, "") << found.help;
    EXPECT_EQ(find_problem(problems_of(with(enough * 9 / 10)), "W610").line, 7);
}

TEST(PhysicsChecks, OnlyTheNarrowestVariantIsReported) {
    const auto list = problems_of(replaced(good_case, "20000", "20000\nsweep = { particles = [3000, 2000, 30000] }"));
    ASSERT_EQ(list.size(), 1U) << render(list);
    EXPECT_EQ(list[0].code, "W602");
    EXPECT_NE(list[0].message.find("one/particles=2000 is the narrowest"), std::string::npos) << list[0].message;
}

} // namespace
