// What sheets write below a curve: reported as skipped, and compared with the curve.

#include "suffuse/gradings/sheets_for_tests.hpp"

#include <gtest/gtest.h>

namespace suffuse::gradings {
namespace {

using namespace testing;

// 10 % at 0.1 mm, 30 % at 0.4 mm, 60 % at 2 mm: Cu = 20, Cc = 0.8; gravel 20 % by 4.75 mm and 40 % by 2 mm.
const std::string curve = "d [mm],passing [%]\n9.5,100\n4.75,80\n2,60\n0.4,30\n0.1,10\n0.063,6\n";

std::string remarks_below(const std::string& rows) {
    const ParsedSheet parsed = parse_sheet(curve + rows);
    EXPECT_EQ(parsed.soils.size(), 1U) << render(parsed.remarks);
    if (parsed.soils.size() == 1) {
        EXPECT_EQ(parsed.soils.front().grading.diameter.size(), 6U);
    }
    std::string remarks;
    for (const Diagnostic& remark : parsed.remarks) {
        remarks += remark.message + "\n";
    }
    return remarks;
}

TEST(DerivedValues, ThoseThatAgreeWithTheCurveArePassedOverInOneLine) {
    const std::string remarks =
        remarks_below("D10 (mm),0.1\nD30,0.40\nD60,2.0\nCu,20\nCc,0.8\nGravel %,20\nSand %,74\nFines,6 %\n");
    EXPECT_EQ(
        remarks,
        "skipped as results because they are not sieves: `D10 (mm)`, `D30`, `D60`, `Cu`, `Cc`, `Gravel %`, `Sand %`, "
        "`Fines`\n"
    );
}

TEST(DerivedValues, ASizeOutsideOfItsNeighborsOnTheCurveIsReported) {
    const std::string remarks = remarks_below("D10,0.5\nD60,2.0\n");
    EXPECT_NE(
        remarks.find("D10 is given as 0.5 mm, and the curve has 0.0889 to 0.107 mm: the curve is taken"),
        std::string::npos
    ) << remarks;
    EXPECT_EQ(remarks.find("D60 is given"), std::string::npos) << remarks;
    EXPECT_NE(remarks_below("D10 [um],500\n").find("D10 [um] is given as 0.5 mm"), std::string::npos);
    EXPECT_EQ(remarks_below("D10 [um],100\n").find("is given"), std::string::npos);
}

TEST(DerivedValues, RatiosAndSharesAreComparedWithAllWaysToDrawTheCurve) {
    EXPECT_NE(remarks_below("Cu,900\n").find("Cu is given as 900"), std::string::npos);
    EXPECT_NE(remarks_below("Coefficient of curvature,3\n").find("is given as 3"), std::string::npos);
    EXPECT_EQ(remarks_below("Gravel,40,\n").find("is given"), std::string::npos); // by ISO 14688
    EXPECT_NE(
        remarks_below("Gravel,55\n")
            .find("Gravel is given as 55 %, and the curve has 20 % by ASTM D2487 and 40 % by ISO 14688"),
        std::string::npos
    );
    EXPECT_NE(
        remarks_below("Passing No. 200 sieve (%),20\n")
            .find("Passing No. 200 sieve (%) is given as 20 %, and the curve has 6 to 10 %"),
        std::string::npos
    );
    EXPECT_NE(remarks_below("Silt and clay,0.3\n").find("is given as 0.3 %"), std::string::npos);
}

TEST(DerivedValues, GravelIsItsOwnClassOrAllThatIsCoarserThanSand) {
    // Cobbles 20 % by 75 mm and by 63 mm, gravel 30 % down to 4.75 mm and to 2 mm.
    const auto remarks = [](const std::string& row) {
        const ParsedSheet parsed =
            parse_sheet("d [mm],passing [%]\n150,100\n75,80\n63,80\n4.75,50\n2,50\n0.063,6\n" + row);
        EXPECT_EQ(parsed.soils.size(), 1U) << render(parsed.remarks);
        return render(parsed.remarks);
    };
    for (const char* const agrees : {"Gravel %,30\n", "Gravel %,50\n", "Cobbles %,20\n"}) {
        EXPECT_EQ(remarks(agrees).find("is given as"), std::string::npos) << remarks(agrees);
    }
    for (const char* const differs : {"Gravel %,28\n", "Gravel %,52\n", "Cobbles %,22\n", "Cobbles %,18\n"}) {
        EXPECT_NE(remarks(differs).find("is given as"), std::string::npos) << remarks(differs);
    }
}

TEST(DerivedValues, NamesMayBeAboveTheirValuesOrNextToThem) {
    EXPECT_NE(remarks_below("\"Gravel %\",\"Sand %\"\n20,30\n").find("Sand % is given as 30 %"), std::string::npos);
    EXPECT_NE(remarks_below("D60 0.2 mm\nCu = 20\n").find("D60 is given as 0.2 mm"), std::string::npos);
    EXPECT_NE(remarks_below("Gravel 70 %\n").find("Gravel is given as 70 %"), std::string::npos);
    EXPECT_NE(remarks_below("D60= 0.2,D10= 0.1\n").find("D60 is given as 0.2 mm"), std::string::npos);
}

TEST(DerivedValues, OfManySoilsEachHasItsOwn) {
    const ParsedSheet parsed = parse_sheet("d [mm],A,B\n9.5,100,100\n2,60,80\n0.4,30,40\n0.1,10,20\nD10,0.1,3\n");
    ASSERT_EQ(parsed.soils.size(), 2U) << render(parsed.remarks);
    const std::string remarks = render(parsed.remarks);
    EXPECT_NE(remarks.find("B: D10 is given as 3 mm"), std::string::npos) << remarks;
    EXPECT_EQ(remarks.find("A: D10"), std::string::npos) << remarks;
}

TEST(DerivedValues, NamesMayBeJoinedBySlashes) {
    const std::string agree = "skipped as results because they are not sieves: `D10`, `D30`, `D60`, `Cu`, `Cc`\n";
    EXPECT_EQ(remarks_below("D10 / D30 / D60 / Cu / Cc,0.1 / 0.4 / 2 / 20 / 0.8\n"), agree);
    EXPECT_EQ(remarks_below("D10/D30/D60/Cu/Cc,0.1,0.4,2,20,0.8\n"), agree); // more cells than the table has columns
    EXPECT_EQ(remarks_below("D10 / D30 / D60 / Cu / Cc\n0.1 / 0.4 / 2 / 20 / 0.8\n"), agree);
    EXPECT_EQ(remarks_below("D10 / D30 / D60 = 0.1 / 0.4 / 2 mm\nCu / Cc: 20 / 0.8\n"), agree);
    EXPECT_EQ(remarks_below("D10/D30/D60,- / 0.4 / -\nCu/Cc,-/-\n"), agree);
    EXPECT_NE(remarks_below("D10 / D60,0.5 / 2\n").find("D10 is given as 0.5 mm"), std::string::npos);
    EXPECT_NE(remarks_below("D10/D60 (um),500/2000\n").find("D10 is given as 0.5 mm"), std::string::npos);
    EXPECT_NE(remarks_below("Cu / Cc,900,0.8\n").find("Cu is given as 900"), std::string::npos);
    EXPECT_NE(remarks_below("Silt/clay,30\n").find("Silt/clay is given as 30 %"), std::string::npos); // of the fines
}

TEST(DerivedValues, JoinedNamesTakeNoSieveForTheirValues) {
    const ParsedSheet parsed = parse_sheet("d [mm],passing [%]\n2,60\n0.4,30\nCu / Cc\n0.1,10\n");
    ASSERT_EQ(parsed.soils.size(), 1U) << render(parsed.remarks);
    EXPECT_EQ(parsed.soils.front().grading.diameter.size(), 3U);
}

TEST(DerivedValues, OfSievesAcrossTheyStandBelowTheSamples) {
    const std::string across = "Sample,9.5,4.75,2,0.4,0.1,0.063\nTP1,100,80,60,30,10,6\n";
    const ParsedSheet good = parse_sheet(across + ",,\nD10,D30,D60,Cu,Cc\n0.1,0.4,2,20,0.8\n");
    ASSERT_EQ(good.soils.size(), 1U) << render(good.remarks);
    EXPECT_EQ(render(good.remarks).find("is given as"), std::string::npos) << render(good.remarks);
    const ParsedSheet bad = parse_sheet(across + "D10 / D60,0.5 / 2\n");
    ASSERT_EQ(bad.soils.size(), 1U) << render(bad.remarks);
    EXPECT_NE(render(bad.remarks).find("D10 is given as 0.5 mm"), std::string::npos) << render(bad.remarks);
}

TEST(DerivedValues, ASampleOfThatNameIsNoDerivedValue) {
    const ParsedSheet parsed = parse_sheet(
        "Sample,d [mm],passing [%]\nSand,2,100\nSand,0.4,30\nSand,0.1,2\nGravel,63,100\nGravel,20,40\nGravel,2,5\n"
    );
    ASSERT_EQ(parsed.soils.size(), 2U) << render(parsed.remarks);
    expect_soil({"Sand", {{0.1, 2}, {0.4, 30}, {2, 100}}}, parsed.soils[0], "names");
    expect_soil({"Gravel", {{2, 5}, {20, 40}, {63, 100}}}, parsed.soils[1], "names");
}

} // namespace
} // namespace suffuse::gradings
