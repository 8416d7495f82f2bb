// Gradings of the kinds that people store, re-typed small from public files of the field: each stands for its kind.

#include "suffuse/gradings/sheets_for_tests.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

namespace suffuse::gradings {
namespace {

using namespace testing;

TEST(FieldGradings, EachKindGivesItsCurve) {
    expect_sheets({
        {"ags4-one-sample.ags",
         "\"GROUP\",\"PROJ\"\n"
         "\"HEADING\",\"PROJ_ID\"\n"
         "\"UNIT\",\"\"\n"
         "\"TYPE\",\"ID\"\n"
         "\"DATA\",\"P1\"\n"
         "\n"
         "\"GROUP\",\"GRAT\"\n"
         "\"HEADING\",\"LOCA_ID\",\"SAMP_TOP\",\"SAMP_REF\",\"SAMP_TYPE\",\"SAMP_ID\",\"SPEC_REF\",\"SPEC_DPTH\","
         "\"GRAT_SIZE\",\"GRAT_PERP\",\"GRAT_TYPE\",\"GRAT_REM\",\"FILE_FSET\"\n"
         "\"UNIT\",\"\",\"m\",\"\",\"\",\"\",\"\",\"m\",\"mm\",\"%\",\"\",\"\",\"\"\n"
         "\"TYPE\",\"ID\",\"2DP\",\"X\",\"PA\",\"ID\",\"X\",\"2DP\",\"3SF\",\"0DP\",\"PA\",\"X\",\"X\"\n"
         "\"DATA\",\"A1\",\"1.20\",\"1\",\"B\",\"\",\"1\",\"1.20\",\"20\",\"100\",\"WS\",\"\",\"\"\n"
         "\"DATA\",\"A1\",\"1.20\",\"1\",\"B\",\"\",\"1\",\"1.20\",\"6.3\",\"82\",\"WS\",\"\",\"\"\n"
         "\"DATA\",\"A1\",\"1.20\",\"1\",\"B\",\"\",\"1\",\"1.20\",\"2\",\"61\",\"WS\",\"\",\"\"\n"
         "\"DATA\",\"A1\",\"1.20\",\"1\",\"B\",\"\",\"1\",\"1.20\",\"0.6\",\"40\",\"WS\",\"\",\"\"\n"
         "\"DATA\",\"A1\",\"1.20\",\"1\",\"B\",\"\",\"1\",\"1.20\",\"0.2\",\"15\",\"WS\",\"\",\"\"\n"
         "\"DATA\",\"A1\",\"1.20\",\"1\",\"B\",\"\",\"1\",\"1.20\",\"0.063\",\"4\",\"WS\",\"\",\"\"\n"
         "\"DATA\",\"A1\",\"1.20\",\"1\",\"B\",\"\",\"1\",\"1.20\",\"0.02\",\"0\",\"HY\",\"\",\"\"\n",
         {{"", {{0.02, 0}, {0.063, 4}, {0.2, 15}, {0.6, 40}, {2, 61}, {6.3, 82}, {20, 100}}}},
         ""},
        {"blank-cells.csv",
         "Sieve (mm),Passing (%)\n"
         "75,\n"
         "50,\n"
         "37.5,100\n"
         "19,95\n"
         "9.5,80\n"
         "4.75,66\n"
         "2,\n"
         "0.425,30\n"
         "0.075,9\n",
         {{"", {{0.075, 9}, {0.425, 30}, {4.75, 66}, {9.5, 80}, {19, 95}, {37.5, 100}}}},
         "the sieves 75, 50, 2 without a value"},
        {"blanks-between.dat",
         "size passing\n"
         "0.063 4\n"
         "0.2 15\n"
         "0.63 40\n"
         "2 70\n"
         "6.3 100\n",
         {{"", {{0.063, 4}, {0.2, 15}, {0.63, 40}, {2, 70}, {6.3, 100}}}},
         ""},
        {"cp1252-um.csv",
         "Size [\265m],Passing [%]\n"
         "63,4\n"
         "200,15\n"
         "2000,100\n",
         {{"", {{0.063, 4}, {0.2, 15}, {2, 100}}}},
         "Windows-1252"},
        {"hash-rows-control.csv",
         "Sieve No.,Opening (mm),Percent Finer\n"
         "75 mm,75,100\n"
         "37.5 mm,37.5,92\n"
         "19 mm,19,78\n"
         "9.5 mm,9.5,61\n"
         "No. 4,4.75,45\n"
         "No. 10,2.0,33\n"
         "No. 40,0.425,18\n"
         "No. 100,0.150,9\n"
         "No. 200,0.075,6\n",
         {{"", {{0.075, 6}, {0.15, 9}, {0.425, 18}, {2, 33}, {4.75, 45}, {9.5, 61}, {19, 78}, {37.5, 92}, {75, 100}}}},
         "sizes are read from `Opening (mm)`"},
        {"hash-rows-us-sieves.csv",
         "Sieve No.,Opening (mm),Percent Finer\n"
         "\"3\"\"\",75,100\n"
         "\"1-1/2\"\"\",37.5,92\n"
         "\"3/4\"\"\",19,78\n"
         "\"3/8\"\"\",9.5,61\n"
         "#4,4.75,45\n"
         "#10,2.0,33\n"
         "#40,0.425,18\n"
         "#100,0.150,9\n"
         "#200,0.075,6\n",
         {{"", {{0.075, 6}, {0.15, 9}, {0.425, 18}, {2, 33}, {4.75, 45}, {9.5, 61}, {19, 78}, {37.5, 92}, {75, 100}}}},
         "not read: `Sieve No.`"},
        {"inches-quoted.csv",
         "Sieve Size,% Passing\n"
         "\"1-1/2\"\"\",100\n"
         "\"3/4\"\"\",92\n"
         "\"3/8\"\"\",81\n"
         "No. 4,70\n"
         "No. 10,55\n"
         "No. 40,30\n"
         "No. 100,14\n"
         "No. 200,9.5\n",
         {{"", {{0.075, 9.5}, {0.15, 14}, {0.425, 30}, {2, 55}, {4.75, 70}, {9.5, 81}, {19, 92}, {37.5, 100}}}},
         ""},
        {"many-samples-wide.csv",
         "d [mm],TP1,TP2,TP3\n"
         "0.063,4,6,8\n"
         "0.2,15,20,22\n"
         "0.63,40,45,50\n"
         "2,70,75,80\n"
         "6.3,100,100,100\n",
         {{"TP1", {{0.063, 4}, {0.2, 15}, {0.63, 40}, {2, 70}, {6.3, 100}}},
          {"TP2", {{0.063, 6}, {0.2, 20}, {0.63, 45}, {2, 75}, {6.3, 100}}},
          {"TP3", {{0.063, 8}, {0.2, 22}, {0.63, 50}, {2, 80}, {6.3, 100}}}},
         "3 columns are read as cumulative shares"},
        {"micron.csv",
         "Sieve Size,% Finer\n"
         "4.75 mm,98\n"
         "2 mm,90\n"
         "1 mm,75\n"
         "600 micron,60\n"
         "425 micron,45\n"
         "300 micron,30\n"
         "150 micron,12\n"
         "75 micron,3\n",
         {{"", {{0.075, 3}, {0.15, 12}, {0.3, 30}, {0.425, 45}, {0.6, 60}, {1, 75}, {2, 90}, {4.75, 98}}}},
         ""},
        {"pan-total-rows.csv",
         "Sieve (mm),Individual retained (%)\n"
         "4.75,4\n"
         "2.36,9\n"
         "1.18,18\n"
         "0.6,28\n"
         "0.3,26\n"
         "0.15,10\n"
         "0.075,3\n"
         "Pan,2\n"
         "Total,100\n",
         {{"", {{0.075, 2}, {0.15, 5}, {0.3, 15}, {0.6, 41}, {1.18, 69}, {2.36, 87}, {4.75, 96}}}},
         "`Total` is passed over"},
        {"phi.csv",
         "phi,cumulative percent\n"
         "-1,2\n"
         "0,15\n"
         "1,45\n"
         "2,80\n"
         "3,97\n"
         "4,99.5\n",
         {{"", {{0.0625, 0.5}, {0.125, 3}, {0.25, 20}, {0.5, 55}, {1, 85}, {2, 98}}}},
         "retained on a sieve and all coarser"},
        {"sieve-hydrometer-join.csv",
         "Particle size (mm),Percent finer\n"
         "4.75,100\n"
         "2,90\n"
         "0.425,60\n"
         "0.15,40\n"
         "0.075,30.2\n"
         "0.075,30.0\n"
         "0.05,25\n"
         "0.02,15\n"
         "0.005,8\n"
         "0.002,5\n",
         {{"",
           {{0.002, 5},
            {0.005, 8},
            {0.02, 15},
            {0.05, 25},
            {0.075, 30.1},
            {0.15, 40},
            {0.425, 60},
            {2, 90},
            {4.75, 100}}}},
         "joined as 30.1 %"},
        {"sieve-numbers.csv",
         "Sieve No.,Percent Finer\n"
         "4,95\n"
         "10,81\n"
         "20,66\n"
         "40,50\n"
         "140,8.5\n"
         "200,4.8\n",
         {{"", {{0.075, 4.8}, {0.106, 8.5}, {0.425, 50}, {0.85, 66}, {2, 81}, {4.75, 95}}}},
         ""},
        {"two-size-columns.csv",
         "Sieve,Opening (mm),Percent Finer\n"
         "3/8\",9.5,98\n"
         "#4,4.75,95\n"
         "#10,2.0,81\n"
         "#20,0.85,66\n"
         "#40,0.425,50\n"
         "#140,0.106,8.5\n"
         "#200,0.075,4.8\n",
         {{"", {{0.075, 4.8}, {0.106, 8.5}, {0.425, 50}, {0.85, 66}, {2, 81}, {4.75, 95}, {9.5, 98}}}},
         "not read: `Sieve`"},
        {"units-line.csv",
         "Sieve size,Passing\n"
         "mm,%\n"
         "6.3,100\n"
         "2,70\n"
         "0.63,40\n"
         "0.2,15\n"
         "0.063,4\n",
         {{"", {{0.063, 4}, {0.2, 15}, {0.63, 40}, {2, 70}, {6.3, 100}}}},
         ""},
        {"weight-retained-pan.csv",
         "Sieve Size (mm),Weight Retained (g)\n"
         "4.75,100\n"
         "2.36,150\n"
         "1.18,180\n"
         "0.6,120\n"
         "0.3,90\n"
         "0.15,40\n"
         "0.075,10\n"
         "Pan,5\n",
         {{"",
           {{0.075, 0.71942},
            {0.15, 2.1583},
            {0.3, 7.9137},
            {0.6, 20.863},
            {1.18, 38.129},
            {2.36, 64.029},
            {4.75, 85.612}}}},
         "read as retained on each sieve alone"},
    });
}

TEST(FieldGradings, RowsThatBeginWithASieveNumberAreNoComments) {
    const auto soils =
        parse_sheet("Sieve No.,Percent Finer\n#4,95 # washed\n#10,81\n# dried at 105 C\n#200,4.8\n").soils;
    ASSERT_EQ(soils.size(), 1U);
    expect_soil({"", {{0.075, 4.8}, {2, 81}, {4.75, 95}}}, soils.front(), "comments");
    const ParsedSheet blank = parse_sheet("Sieve No.,Percent Finer\n# 4,95\n#10,81\n#200,4.8\n");
    EXPECT_NE(render(blank.told).find("without a blank"), std::string::npos) << render(blank.told);
}

TEST(FieldGradings, WhatCannotBeReadIsAnErrorWithItsPlace) {
    for (const auto& [text, line, says] : std::vector<std::tuple<std::string, int, std::string>>{
             {"Sieve No.,Percent Finer\n4,95\n#0.2,81\n200,4.8\n", 3, "no sieve number of ASTM E11"},
             {"Sieve No.,Percent Finer\n4,95\n10,81\n3000,4.8\n", 4, "no sieve number of ASTM E11"},
             {"d [mm],passing [%]\n4,95\n2,n.d.\n1,20\n", 3, "is not a number"},
             {"d [mm],passing [%]\n4,95\nsee note,80\n1,20\n", 3, "is not a number"},
             {"Rozmiar,Przesiew\n4,95\n2,60\n1,20\n", 1, "`d` is missing"}, // a language that is not known
             {"d [mm],passing [%]\n0.1,40\n0.075,30\n0.075,33\n0.05,15\n", 3, "the grading is not monotonic"},
             {"Sieve (mm),Mass of sieve (g),Mass of sieve + soil (g)\n2,400,380\n1,300,350\npan,200,210\n", 2,
              "exchanged"},
             {"d [mm],passing [%]\n2,100\n1,50\npan,3\n", 4, "passes the pan"},
             {"PK\x03\x04 and more", 0, "workbook (.xlsx"},
             {"\xD0\xCF\x11\xE0\xA1", 0, "save the sheet as CSV"},
             {"%PDF-1.4", 0, "PDF"},
             {"\"**PROJ\"\n\"*PROJ_ID\"\n", 0, "AGS 4"},
             {"\"GROUP\",\"PROJ\"\n\"HEADING\",\"PROJ_ID\"\n", 0, "no rows in a group GRAT"},
         }) {
        const ParsedSheet parsed = parse_sheet(text);
        EXPECT_TRUE(parsed.soils.empty()) << text;
        const auto error = std::ranges::find_if(parsed.told, [](const Diagnostic& d) { return !d.is_warning; });
        ASSERT_NE(error, parsed.told.end()) << text;
        EXPECT_EQ(error->line, line) << render(parsed.told);
        EXPECT_NE((error->message + error->help).find(says), std::string::npos) << render(parsed.told);
    }
}

TEST(FieldGradings, SamplesOfOneAgsFileAreToldApartByLocationAndDepth) {
    const std::string head = "\"GROUP\",\"GRAT\"\n\"HEADING\",\"LOCA_ID\",\"SAMP_TOP\",\"GRAT_SIZE\",\"GRAT_PERP\"\n"
                             "\"UNIT\",\"\",\"m\",\"mm\",\"%\"\n\"TYPE\",\"ID\",\"2DP\",\"3SF\",\"0DP\"\n";
    const ParsedSheet parsed = parse_sheet(
        head + "\"DATA\",\"A1\",\"1.20\",\"2\",\"100\"\n\"DATA\",\"A1\",\"1.20\",\"0.2\",\"5\"\n"
               "\"DATA\",\"A1\",\"3.00\",\"2\",\"90\"\n\"DATA\",\"A1\",\"3.00\",\"0.2\",\"8\"\n"
               "\"DATA\",\"B2\",\"1.20\",\"2\",\"70\"\n\"DATA\",\"B2\",\"1.20\",\"0.2\",\"9\"\n"
    );
    ASSERT_EQ(parsed.soils.size(), 3U) << render(parsed.told);
    expect_soil({"A1 3.00 m", {{0.2, 8}, {2, 90}}}, parsed.soils[1], "ags");
    expect_soil({"B2 1.20 m", {{0.2, 9}, {2, 70}}}, parsed.soils[2], "ags");
}

TEST(FieldGradings, OneSampleIsChosenByNameAndAWrongNameIsAnsweredWithThoseThereAre) {
    const auto source =
        std::make_shared<Source>(Source{"w.csv", "d [mm],TP1,TP2\n0.063,4,6\n0.2,15,20\n2,70,75\n6.3,100,100\n"});
    const GradingFile one = read_gradings(source, CurveEnds::MayBeOpen, "tp2");
    ASSERT_EQ(one.soils.size(), 1U);
    EXPECT_EQ(one.soils.front().name, "TP2");
    try {
        read_gradings(source, CurveEnds::MayBeOpen, "TP7");
        FAIL();
    } catch (const CaseError& problem) {
        EXPECT_NE(std::string(problem.what()).find("it has TP1, TP2"), std::string::npos) << problem.what();
    }
    Problems problems;
    EXPECT_FALSE(parse_grading(source, problems, CurveEnds::MayBeOpen));
    EXPECT_NE(render(problems.sorted()).find("--sample NAME"), std::string::npos);
}

TEST(FieldGradings, SievesAndAHydrometerInTwoRunsAreJoined) {
    const ParsedSheet parsed =
        parse_sheet("Size (mm),Finer (%)\n2,100\n0.5,80\n0.075,35\n0.08,35.6\n0.02,20\n0.002,5\n");
    ASSERT_EQ(parsed.soils.size(), 1U) << render(parsed.told);
    expect_soil(
        {"", {{0.002, 5}, {0.02, 20}, {0.075, 35}, {0.08, 35.6}, {0.5, 80}, {2, 100}}}, parsed.soils.front(), "runs"
    );
    EXPECT_NE(render(parsed.told).find("a second run of sizes"), std::string::npos);
}

TEST(FieldGradings, SievesAndAHydrometerMayRunInAnyDirection) {
    const std::vector<std::string> sieves{"2,100\n", "0.5,80\n", "0.2,50\n", "0.075,35\n"};
    const std::vector<std::string> hydrometer{"0.02,20\n", "0.006,10\n", "0.002,5\n"};
    for (const bool sieves_rise : {false, true}) {
        for (const bool hydrometer_rises : {false, true}) {
            auto first = sieves, second = hydrometer;
            if (sieves_rise) {
                std::ranges::reverse(first);
            }
            if (hydrometer_rises) {
                std::ranges::reverse(second);
            }
            std::string text = "Size (mm),Finer (%)\n";
            first.insert(first.end(), second.begin(), second.end());
            for (const std::string& line : first) {
                text += line;
            }
            const ParsedSheet parsed = parse_sheet(text);
            ASSERT_EQ(parsed.soils.size(), 1U) << text << render(parsed.told);
            expect_soil(
                {"", {{0.002, 5}, {0.006, 10}, {0.02, 20}, {0.075, 35}, {0.2, 50}, {0.5, 80}, {2, 100}}},
                parsed.soils.front(), text
            );
        }
    }
}

TEST(FieldGradings, RowsOfAnAgsFileMayComeInAnyOrder) {
    const std::string head = "\"GROUP\",\"GRAT\"\n\"HEADING\",\"LOCA_ID\",\"SAMP_TOP\",\"GRAT_SIZE\",\"GRAT_PERP\","
                             "\"GRAT_TYPE\"\n\"UNIT\",\"\",\"m\",\"mm\",\"%\",\"\"\n";
    const auto row = [](const char* size, const char* passing, const char* type) {
        return fmt::format("\"DATA\",\"A1\",\"1.20\",\"{}\",\"{}\",\"{}\"\n", size, passing, type);
    };
    const std::string sieves = row("0.063", "3", "WS") + row("0.2", "21", "WS") + row("2", "100", "WS");
    for (const std::string& hydrometer :
         {row("0.002", "1", "HY") + row("0.02", "2", "HY"), row("0.02", "2", "HY") + row("0.002", "1", "HY")}) {
        for (const std::string& rows : {sieves + hydrometer, hydrometer + sieves}) {
            const ParsedSheet parsed = parse_sheet(head + rows);
            ASSERT_EQ(parsed.soils.size(), 1U) << render(parsed.told);
            expect_soil({"", {{0.002, 1}, {0.02, 2}, {0.063, 3}, {0.2, 21}, {2, 100}}}, parsed.soils.front(), "ags");
        }
    }
}

TEST(FieldGradings, NumbersMayHaveExponents) {
    const ParsedSheet parsed =
        parse_sheet("# d[mm] passing[%]\n1.000e-01 0.000e+00\n2.000e+00 5.000e+01\n4.000E+00 1.000e+02\n");
    ASSERT_EQ(parsed.soils.size(), 1U) << render(parsed.told);
    expect_soil({"", {{0.1, 0}, {2, 50}, {4, 100}}}, parsed.soils.front(), "exponents");
}

TEST(FieldGradings, ALineOfWordsBelowTheHeadingsIsNoSecondLineOfThem) { // found by the fuzz test
    const ParsedSheet parsed = parse_sheet("Sieve Non,Percent Finer\nent Finer\n4,95\n10,81\n");
    EXPECT_TRUE(parsed.soils.empty());
    EXPECT_NE(render(parsed.told).find("\"ent Finer\" is not a number"), std::string::npos) << render(parsed.told);
}

TEST(FieldGradings, RockfillInMetersIsNoForgottenUnit) {
    const ParsedSheet parsed = parse_sheet("d [m],passing [%]\n0.1,0\n0.3,40\n1,100\n");
    ASSERT_EQ(parsed.soils.size(), 1U) << render(parsed.told);
    expect_soil({"", {{100, 0}, {300, 40}, {1000, 100}}}, parsed.soils.front(), "rockfill");
    EXPECT_TRUE(parse_sheet("d,passing\n100,0\n300,40\n1000,100\n").soils.empty());
}

/// Where each cell's column was counted from the start of its line, 32,000 columns took a minute: these would take
/// hours.
TEST(FieldGradings, ATableOfFourHundredThousandColumnsIsRefused) {
    std::string text(400'000, ',');
    text += "\n";
    EXPECT_TRUE(parse_sheet("d" + text + "1" + text).soils.empty());
    std::string names = "d";
    for (int k = 0; k < 400'000; ++k) {
        names += ",a";
    }
    const ParsedSheet parsed = parse_sheet(names + "\n1,2\n");
    EXPECT_NE(render(parsed.told).find("400001 columns"), std::string::npos) << render(parsed.told).substr(0, 300);
}

} // namespace
} // namespace suffuse::gradings
