// Several tables in a sheet, notes around them, and sieves that stand across.

#include "suffuse/gradings/sheets_for_tests.hpp"

#include <gtest/gtest.h>

namespace suffuse::gradings {
namespace {

using namespace testing;

std::string told_by(const ParsedSheet& parsed) {
    std::string told;
    for (const Diagnostic& remark : parsed.told) {
        told += remark.message + "\n";
    }
    return told;
}

TEST(SheetTables, ALastSieveThatCannotBeReadIsAnErrorAndNoNote) {
    for (const char* row : {"O.075,8", "fine sieve,8", "No.2OO,8"}) {
        const ParsedSheet parsed =
            parse_sheet(std::string("d [mm],passing [%]\n4.75,100\n2,60\n0.4,30\n") + row + "\n");
        EXPECT_TRUE(parsed.soils.empty()) << row;
        EXPECT_NE(told_by(parsed).find("is not a number"), std::string::npos) << row << told_by(parsed);
    }
}

TEST(SheetTables, NotesApartFromTheTableAreToldAndPassedOver) {
    const ParsedSheet parsed =
        parse_sheet("d [mm],passing [%]\n4.75,100\n2,60\n0.4,30\nRemarks: washed\n\nTested at,25\nOperator,J. K.\n");
    ASSERT_EQ(parsed.soils.size(), 1U) << told_by(parsed);
    EXPECT_EQ(parsed.soils.front().grading.diameter.size(), 3U);
    EXPECT_NE(
        told_by(parsed).find("passed over as notes, for they are no sieves: `Remarks: washed`, `Tested at`, `Operator`"
        ),
        std::string::npos
    ) << told_by(parsed);
}

TEST(SheetTables, AWordBetweenSievesIsATitleAndAnUnreadableSieveThereAnError) {
    const ParsedSheet parsed = parse_sheet("d [mm],passing [%]\n2,100\n0.4,30\nHYDROMETER,\n0.05,9\n0.02,4\n");
    ASSERT_EQ(parsed.soils.size(), 1U) << told_by(parsed);
    EXPECT_NE(told_by(parsed).find("`HYDROMETER`"), std::string::npos) << told_by(parsed);
    EXPECT_TRUE(parse_sheet("d [mm],passing [%]\n2,100\nO.4,30\n0.05,9\n").soils.empty());
}

TEST(SheetTables, TablesWithoutNamesThatDoNotGoOnAreTwoSoils) {
    const ParsedSheet parsed =
        parse_sheet("d [mm],passing [%]\n2,100\n0.4,30\n0.1,3\n\nd [mm],passing [%]\n4,100\n0.4,50\n0.1,7\n");
    ASSERT_EQ(parsed.soils.size(), 2U) << told_by(parsed);
    EXPECT_EQ(parsed.soils[0].name, "table 1");
    EXPECT_EQ(parsed.soils[1].name, "table 2");
}

TEST(SheetTables, TwoSamplesSideBySideHaveTheNamesAboveThem) {
    const ParsedSheet parsed =
        parse_sheet("TP1,,TP2,\nd [mm],passing [%],d [mm],passing [%]\n4,100,8,100\n1,50,2,40\n0.1,5,0.5,10\n,,0.1,2\n"
        );
    ASSERT_EQ(parsed.soils.size(), 2U) << told_by(parsed);
    expect_soil({"TP1", {{0.1, 5}, {1, 50}, {4, 100}}}, parsed.soils[0], "beside");
    expect_soil({"TP2", {{0.1, 2}, {0.5, 10}, {2, 40}, {8, 100}}}, parsed.soils[1], "beside");
}

TEST(SheetTables, SievesMayStandAcrossInManyWays) {
    expect_sheets({
        {"one-sample.csv",
         "Sieve (mm),4.75,2,0.425,0.075\nPassing (%),100,70,30,6\nRetained (%),0,30,40,24\n",
         {{"", {{0.075, 6}, {0.425, 30}, {2, 70}, {4.75, 100}}}},
         "the sieves stand across"},
        {"words-at-sizes.csv",
         "ID,% Passing #4,% Passing #40,% Passing #200\nA,100,40,8\nB,90,35,5\n",
         {{"A", {{0.075, 8}, {0.425, 40}, {4.75, 100}}}, {"B", {{0.075, 5}, {0.425, 35}, {4.75, 90}}}},
         "3 sieves, 2 samples"},
        {"numbers-alone.csv",
         "#4,#10,#40,#200\n100,85,60,18.4\n",
         {{"", {{0.075, 18.4}, {0.425, 60}, {2, 85}, {4.75, 100}}}},
         "4 sieves, 1 sample"},
        {"plain-sizes.csv",
         "Sample;Depth (m);20;6,3;2;0,2;0,063\nBK1;1,5;100;80;55;20;8,5\nBK1;3,0;;100;90;33;12\n",
         {{"BK1 1,5", {{0.063, 8.5}, {0.2, 20}, {2, 55}, {6.3, 80}, {20, 100}}},
          {"BK1 3,0", {{0.063, 12}, {0.2, 33}, {2, 90}, {6.3, 100}}}},
         "the sieves stand across"},
        {"unit-beside.csv",
         "Sieve,um,2000,425,75\nPassing,%,100,60,8\n",
         {{"", {{0.075, 8}, {0.425, 60}, {2, 100}}}},
         "the sieves stand across"},
        {"headings-in-two-rows.csv",
         "Pit;Sample;Passing;;;PI\n;;#4;#40;#200;\nA;1;100;60;8;NP\nA;2;90;50;7;12\n",
         {{"A 1", {{0.075, 8}, {0.425, 60}, {4.75, 100}}}, {"A 2", {{0.075, 7}, {0.425, 50}, {4.75, 90}}}},
         "not read: `PI`"},
        {"masses.csv",
         "Mass retained (g),,,,\nSample,#4,#10,#40,#200,Pan\nA,0,100,200,150,50\nB,0,60,60,60,20\n",
         {{"A", {{0.075, 10}, {0.425, 40}, {2, 80}, {4.75, 100}}},
          {"B", {{0.075, 10}, {0.425, 40}, {2, 70}, {4.75, 100}}}},
         "`Pan` is what passed the finest sieve"},
        {"with-results.csv",
         "Sample,19 mm,4.75 mm,0.425 mm,0.075 mm,Gravel %,D60\nS1,100,80,30,5,20,2\nS2,100,70,40,9,12,2\n",
         {{"S1", {{0.075, 5}, {0.425, 30}, {4.75, 80}, {19, 100}}},
          {"S2", {{0.075, 9}, {0.425, 40}, {4.75, 70}, {19, 100}}}},
         "S2: Gravel % is given as 12 %"},
    });
}

TEST(SheetTables, TablesBesideEachOtherThatGoOnAreOneUnlessTheyHaveNames) {
    const std::string curve = "d [um],passing [%],d [um],passing [%]\n1,0,16,40\n2,5,63,80\n4,12,250,100\n";
    const ParsedSheet one = parse_sheet(curve);
    ASSERT_EQ(one.soils.size(), 1U) << told_by(one);
    expect_soil({"", {{0.001, 0}, {0.002, 5}, {0.004, 12}, {0.016, 40}, {0.063, 80}, {0.25, 100}}}, one.soils[0], "on");
    EXPECT_NE(told_by(one).find("2 tables beside each other go on from one to the next"), std::string::npos);
    EXPECT_EQ(parse_sheet("TP1,,TP2,\n" + curve).soils.size(), 2U);
    const ParsedSheet two = parse_sheet("d [um],passing [%],d [um],passing [%]\n1,0,16,10\n2,5,63,80\n4,12,250,100\n");
    EXPECT_EQ(two.soils.size(), 2U) << told_by(two); // less passes the coarser size
}

TEST(SheetTables, NamesMayStandAboveHeadingsThatSayTheSame) {
    expect_sheets({
        {"names-above.csv",
         "Borehole,B1,B1,B2\nDepth (m),1,2,1\nSieve (mm),% Passing,% Passing,% Passing\n"
         "4,100,100,100\n1,60,50,40\n0.1,9,8,-\n",
         {{"B1 1", {{0.1, 9}, {1, 60}, {4, 100}}},
          {"B1 2", {{0.1, 8}, {1, 50}, {4, 100}}},
          {"B2 1", {{1, 40}, {4, 100}}}},
         "skipped 2 title lines"},
        {"name-over-two.csv",
         ",P1,,P2,\nSieve (mm),Retained (g),Retained (%),Retained (g),Retained (%)\n"
         "4,0,0,0,0\n1,100,66.7,50,33.3\n0.1,30,20,70,46.7\nPan,20,13.3,30,20\n",
         {{"P1", {{0.1, 13.3333}, {1, 33.3333}, {4, 100}}}, {"P2", {{0.1, 20}, {1, 66.6667}, {4, 100}}}},
         "`Pan` is what passed the finest sieve"},
    });
    EXPECT_TRUE(parse_sheet("Sieve (mm),% Passing,% Passing\n4,100,100\n1,60,50\n0.1,9,8\n").soils.empty());
}

TEST(SheetTables, MassesAreReadBesidePercentsOnlyWhereTheseAreTheirs) {
    const std::string head = "Sieve (mm),Retained on sieve (g),Retained on sieve (%)\n4,0,0\n";
    const ParsedSheet same = parse_sheet(head + "1,200,66.7\n0.1,60,20\nPan,40,13.3\n");
    ASSERT_EQ(same.soils.size(), 1U) << told_by(same);
    expect_soil({"", {{0.1, 13.3333}, {1, 33.3333}, {4, 100}}}, same.soils[0], "masses");
    const ParsedSheet washed = parse_sheet(head + "1,200,50\n0.1,60,15\nPan,40,35\n"); // 400 g before washing
    ASSERT_EQ(washed.soils.size(), 1U) << told_by(washed);
    expect_soil({"", {{0.1, 35}, {1, 50}, {4, 100}}}, washed.soils[0], "percents");
}

TEST(SheetTables, OfTwoColumnsOfPassingThatOfTheTotalSampleIsRead) {
    const ParsedSheet parsed = parse_sheet("d [mm],% finer -#10,% finer total\n0.06,60,29\n0.02,45,22\n0.002,16,8\n");
    ASSERT_EQ(parsed.soils.size(), 1U) << told_by(parsed);
    expect_soil({"", {{0.002, 8}, {0.02, 22}, {0.06, 29}}}, parsed.soils[0], "total");
    EXPECT_TRUE(parse_sheet("d [mm],% finer,% finer\n0.06,60,29\n0.02,45,22\n0.002,16,8\n").soils.empty());
}

TEST(SheetTables, ColumnsMayBeSetOffByWideBlanksWithSomeLeftOut) {
    const ParsedSheet parsed = parse_sheet(
        "   Sieving                Sedimentation\n"
        "   Particle   % Passing   Particle   % Passing\n"
        "   Size mm                Size mm\n"
        "   ----------------------------------------\n"
        "   2             100      0.03          20\n"
        "   0.6            70      0.01          12\n"
        "   0.1            30\n",
        "sheet.txt"
    );
    ASSERT_EQ(parsed.soils.size(), 1U) << told_by(parsed);
    expect_soil({"", {{0.01, 12}, {0.03, 20}, {0.1, 30}, {0.6, 70}, {2, 100}}}, parsed.soils[0], "wide");
}

TEST(SheetTables, AHydrometerThatPassesMoreThanTheFinestSieveIsRefused) {
    const ParsedSheet parsed =
        parse_sheet("d [mm],passing [%]\n2,100\n0.6,80\n0.075,58\n\nHydrometer\nd [mm],passing [%]\n0.07,94\n0.01,40\n"
        );
    EXPECT_TRUE(parsed.soils.empty());
    EXPECT_NE(
        told_by(parsed).find("the second table does not go on with the curve above: 94 % pass 0.07 mm"),
        std::string::npos
    ) << told_by(parsed);
}

TEST(SheetTables, ARowWithMoreValuesThanHeadingsIsAnErrorInEveryKindOfTable) {
    for (const char* text :
         {"Sample,4.75 mm,0.4 mm,0.1 mm\nA,100,40,8\nB,90,35,0,5\n",
          "d [mm],passing [%],d [mm],passing [%]\n4,100,8,100\n1,50,2,40\n0.1,5,0.5,10,7\n"}) {
        const ParsedSheet parsed = parse_sheet(text);
        EXPECT_TRUE(parsed.soils.empty()) << text;
        EXPECT_NE(told_by(parsed).find("values where the header names"), std::string::npos) << told_by(parsed);
    }
}

TEST(SheetTables, OtherSievesAcrossFurtherDownAreRefusedAndTheSameAreNot) {
    const std::string first = "Sample,4.75 mm,0.4 mm,0.1 mm\nA,100,40,8\n";
    const ParsedSheet other = parse_sheet(first + "Sample,19 mm,2 mm,0.06 mm\nB,100,35,5\n");
    EXPECT_TRUE(other.soils.empty());
    EXPECT_NE(told_by(other).find("a second row of sieves across"), std::string::npos) << told_by(other);
    EXPECT_EQ(parse_sheet(first + "Sample,4.75 mm,0.4 mm,0.1 mm\nB,100,35,5\n").soils.size(), 2U);
}

TEST(SheetTables, MergedCellsLeaveTheSampleToItsFirstRow) {
    const ParsedSheet parsed =
        parse_sheet("Sample,Depth (m),Sieve (mm),Passing "
                    "(%)\nTP1,1.5,19,100\n,,4.75,80\n,,0.1,6\nTP2,2,19,100\n,,4.75,90\n,,0.1,7\n");
    ASSERT_EQ(parsed.soils.size(), 2U) << told_by(parsed);
    expect_soil({"TP1 1.5", {{0.1, 6}, {4.75, 80}, {19, 100}}}, parsed.soils[0], "merged");
    expect_soil({"TP2 2", {{0.1, 7}, {4.75, 90}, {19, 100}}}, parsed.soils[1], "merged");
    EXPECT_NE(told_by(parsed).find("a row that names no sample is of the one above"), std::string::npos);
}

TEST(SheetTables, NumberedSamplesOverSizesAreNotSievesAcross) {
    const ParsedSheet parsed = parse_sheet("size,1,2,3\n4.75,100,100,100\n0.6,40,60,70\n0.075,5,9,12\n");
    ASSERT_EQ(parsed.soils.size(), 3U) << told_by(parsed);
    expect_soil({"2", {{0.075, 9}, {0.6, 60}, {4.75, 100}}}, parsed.soils[1], "numbered");
    for (const char* names : {"0.5 m,1.0 m,2.0 m", "TP1 (0.5 m),TP2 (1 m),TP3 (2 m)"}) { // depths
        const ParsedSheet deep =
            parse_sheet(std::string("d [mm],") + names + "\n4.75,100,100,100\n0.6,40,60,70\n0.075,5,9,12\n");
        ASSERT_EQ(deep.soils.size(), 3U) << told_by(deep);
        EXPECT_EQ(deep.soils[2].grading.diameter.size(), 3U);
        EXPECT_NEAR(deep.soils[2].grading.passing[1], 0.7, 1e-12) << names;
    }
}

TEST(SheetTables, AStatedDryMassTellsWhatWasWashedAway) {
    const std::string rows = "Sieve (mm),Retained (g)\n4.75,0\n2,100\n0.4,200\n0.075,60\nPan,10\n";
    const ParsedSheet washed = parse_sheet("Total dry mass (g):,500\n" + rows);
    ASSERT_EQ(washed.soils.size(), 1U) << told_by(washed);
    expect_soil({"", {{0.075, 28}, {0.4, 40}, {2, 80}, {4.75, 100}}}, washed.soils.front(), "washed");
    EXPECT_NE(told_by(washed).find("the 130 g that are not held passed the finest sieve"), std::string::npos);
    const ParsedSheet split = parse_sheet("Total dry mass (g):,5000\n" + rows);
    EXPECT_TRUE(split.soils.empty());
    EXPECT_NE(told_by(split).find("was the rest washed away, or the sample split?"), std::string::npos)
        << told_by(split);
    const ParsedSheet after = parse_sheet("Dry mass after washing (g):,370\n" + rows);
    ASSERT_EQ(after.soils.size(), 1U) << told_by(after);
    EXPECT_NEAR(after.soils.front().grading.passing.front(), 10.0 / 370, 1e-12);
    const ParsedSheet kilograms =
        parse_sheet("Total dry mass: 0.5 kg\nSieve (mm),Cumulative retained (g)\n4.75,0\n2,100\n0.4,300\n0.075,450\n");
    ASSERT_EQ(kilograms.soils.size(), 1U) << told_by(kilograms);
    expect_soil({"", {{0.075, 10}, {0.4, 40}, {2, 80}, {4.75, 100}}}, kilograms.soils.front(), "kilograms");
}

TEST(SheetTables, WhatIsBoundedByASignIsReadByWhatItsColumnHolds) {
    expect_sheets({
        {"coarser-than.csv",
         "Size (mm),Retained (g)\n> 20,50\n20-2,100\n2-0.2,150\n0-0.2,200\n",
         {{"", {{0.2, 40}, {2, 70}, {20, 90}}}},
         "read as what lies between two sieves"},
        {"minus-200.csv",
         "Sieve,Wt. ret.,% pass\n3/4,0,100\n3/8,55,94.5\n4,110,83.5\n10,160,67.5\n40,300,37.5\n200,275,10\n-200,100,\n",
         {{"", {{0.075, 10}, {0.425, 37.5}, {2, 67.5}, {4.75, 83.5}, {9.5, 94.5}, {19, 100}}}},
         "plain sizes are read as sieve numbers"},
        {"cumulative-and-pan.csv",
         "Sieve (mm),Cumulative retained (g)\n4,0\n1,250\n0.1,450\nPan,50\n",
         {{"", {{0.1, 10}, {1, 50}, {4, 100}}}},
         "read as its own mass"},
    });
    const ParsedSheet parsed = parse_sheet("Size (mm),Passing (%)\n> 20,5\n20,95\n2,40\n");
    EXPECT_TRUE(parsed.soils.empty());
    EXPECT_NE(told_by(parsed).find("\"> 20\" in a table of what passes"), std::string::npos) << told_by(parsed);
}

} // namespace
} // namespace suffuse::gradings
