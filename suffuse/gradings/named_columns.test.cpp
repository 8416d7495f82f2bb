#include "suffuse/gradings/sheets_for_tests.hpp"

namespace suffuse::gradings {
namespace {

using namespace testing;

ReadingOptions columns(const std::string& size, std::string ReadingOptions::*kind, const std::string& share) {
    ReadingOptions options;
    options.size = size;
    options.*kind = share;
    return options;
}

const std::string sheet = "Report 7\nA,B,C\n63,28,10\n200,22,60\n630,50,100\nchecked,by,hand\n1,2,3\n";
const SheetSoil passing{"", {{0.063, 10}, {0.2, 60}, {0.63, 100}}};

TEST(NamedColumns, AreFoundByHeadingOrNumberInTheirUnits) {
    for (const auto& options :
         {columns("A:um", &ReadingOptions::passing, "C"), columns("1:um", &ReadingOptions::passing, "3:%"),
          columns("a:um", &ReadingOptions::passing, "3")}) {
        const ParsedSheet parsed = parse_sheet(sheet, "sheet.csv", options);
        ASSERT_EQ(parsed.soils.size(), 1U) << messages_of(parsed);
        expect_soil(passing, parsed.soils.front(), options.size);
        EXPECT_NE(messages_of(parsed).find("read down to this line"), std::string::npos); // not silently
    }
}

TEST(NamedColumns, SayWhatTheSharesAre) {
    const ParsedSheet own = parse_sheet(sheet, "sheet.csv", columns("A:um", &ReadingOptions::share, "B"));
    ASSERT_EQ(own.soils.size(), 1U) << messages_of(own);
    expect_soil({"", {{0.063, 0}, {0.2, 28}, {0.63, 50}}}, own.soils.front(), "share");
    const ParsedSheet retained =
        parse_sheet("s,x\n2,10\n1,40\n0.5,90\n", "sheet.csv", columns("s:mm", &ReadingOptions::retained, "x"));
    ASSERT_EQ(retained.soils.size(), 1U) << messages_of(retained);
    expect_soil({"", {{0.5, 10}, {1, 60}, {2, 90}}}, retained.soils.front(), "retained");
    const ParsedSheet mass =
        parse_sheet("s,x\n2,50\n1,30\npan,20\n", "sheet.csv", columns("s:mm", &ReadingOptions::mass, "x:kg"));
    ASSERT_EQ(mass.soils.size(), 1U) << messages_of(mass);
    expect_soil({"", {{1, 20}, {2, 50}}}, mass.soils.front(), "mass");
}

TEST(NamedColumns, MayBeAllOfTheTableOrAcrossIt) {
    const ParsedSheet down =
        parse_sheet("s,P,Q\n1,20,30\n2,100,100\n", "sheet.csv", columns("s:mm", &ReadingOptions::passing, "all"));
    ASSERT_EQ(down.soils.size(), 2U) << messages_of(down);
    expect_soil({"Q", {{1, 30}, {2, 100}}}, down.soils.back(), "down");
    const ParsedSheet across = parse_sheet(
        "Sample,63,200,630\nP,10,60,100\nQ,0,50,100\n", "sheet.csv", columns("across:um", &ReadingOptions::passing, "P")
    );
    ASSERT_EQ(across.soils.size(), 1U) << messages_of(across);
    expect_soil(passing, across.soils.front(), "across");
}

TEST(NamedColumns, SoilsOfOneHeadingOrNoneAreNamedByTheirColumns) {
    const auto names_in = [](const std::string& text) {
        std::vector<std::string> names;
        const ParsedSheet parsed = parse_sheet(text, "sheet.csv", columns("1:mm", &ReadingOptions::passing, "all"));
        for (const NamedGrading& soil : parsed.soils) {
            names.push_back(soil.name);
        }
        EXPECT_EQ(names.size(), 3U) << messages_of(parsed);
        return names;
    };
    const std::string rows = "1,20,30,40\n2,90,80,70\n4,100,100,100\n";
    using Names = std::vector<std::string>;
    EXPECT_EQ(names_in("d [mm],TP1,TP1,TP2\n" + rows), Names({"TP1 (column 2)", "TP1 (column 3)", "TP2"}));
    EXPECT_EQ(names_in("d [mm],TP1,,\n" + rows), Names({"TP1", "column 3", "column 4"}));
    EXPECT_EQ(names_in(rows), Names({"column 2", "column 3", "column 4"}));
}

TEST(NamedColumns, LinesAndTablesAreChosen) {
    ReadingOptions options;
    options.rows = "4-6";
    const std::string two = "d [mm],passing [%]\n1,20\n2,100\nd [mm],passing [%]\n3,20\n4,100\n";
    expect_soil({"", {{3, 20}, {4, 100}}}, parse_sheet(two, "sheet.csv", options).soils.at(0), "rows");
    options.rows = "";
    options.sheet = 1;
    expect_soil({"", {{1, 20}, {2, 100}}}, parse_sheet(two, "sheet.csv", options).soils.at(0), "sheet");
    options.sheet = 3;
    EXPECT_NE(messages_of(parse_sheet(two, "sheet.csv", options)).find("the file has 2 tables"), std::string::npos);
}

TEST(NamedColumns, CumulativeMassesAreOfTheLargest) {
    const std::string masses = "Sieve (mm),Cumulative retained (g)\n19,0\n9.5,120\n2,600\n0.075,800\n";
    const ParsedSheet parsed = parse_sheet(masses, "sheet.csv", columns("1:mm", &ReadingOptions::retained, "2:g"));
    ASSERT_EQ(parsed.soils.size(), 1U) << messages_of(parsed);
    expect_soil({"", {{0.075, 0}, {2, 25}, {9.5, 85}, {19, 100}}}, parsed.soils.front(), "masses");
    EXPECT_NE(messages_of(parsed).find("a share of the largest, 800 g"), std::string::npos) << messages_of(parsed);
}

/// What is an error below is one in the first row of values, too.
TEST(NamedColumns, AFirstRowThatCannotBeReadIsAnError) {
    const std::string head = "d [mm],passing [%]\n", rows = "0.2,20\n0.6,55\n2,90\n";
    for (const std::string row : {"0.063,>5", "<0.1,~5", "0.063 approx,5", "~0.063,>5", "0.06.3,5"}) {
        for (const std::string& text :
             {head + row + "\n" + rows, row + "\n" + rows, "2026 report\n" + head + row + "\n" + rows}) {
            const ParsedSheet parsed = parse_sheet(text, "sheet.csv", columns("1:mm", &ReadingOptions::passing, "2"));
            EXPECT_TRUE(parsed.soils.empty()) << text;
        }
    }
}

/// Half of the grains in each of two classes, from 1 to 2 and from 2 to 4 mm: of mass, 1 : 8.
TEST(NamedColumns, SharesOfTheNumberOfGrainsAreWeighed) {
    ReadingOptions options;
    options.by = "number";
    const ParsedSheet parsed = parse_sheet("d [mm],passing [%]\n1,0\n2,50\n4,100\n", "sheet.csv", options);
    ASSERT_EQ(parsed.soils.size(), 1U) << messages_of(parsed);
    expect_soil({"", {{1, 0}, {2, 100.0 / 9}, {4, 100}}}, parsed.soils.front(), "number");
    EXPECT_NE(messages_of(parsed).find("converted to shares of mass"), std::string::npos);
    const ParsedSheet open = parse_sheet("d [mm],passing [%]\n1,5\n2,50\n4,100\n", "sheet.csv", options);
    EXPECT_NE(messages_of(open).find("a size that none is finer than"), std::string::npos);
    const ParsedSheet counted = parse_sheet("d [mm],Number finer (%)\n1,0\n2,50\n4,100\n", "sheet.csv", options);
    ASSERT_EQ(counted.soils.size(), 1U) << messages_of(counted);
    expect_soil({"", {{1, 0}, {2, 100.0 / 9}, {4, 100}}}, counted.soils.front(), "named as number");
    const ParsedSheet above = parse_sheet("Size (mm),Count\n4,10\n2,50\n1,40\n", "sheet.csv", options);
    EXPECT_NE(
        messages_of(above).find("10 % of the number of grains are coarser than 4 mm: 8 mm is assumed"),
        std::string::npos
    );
    EXPECT_EQ(messages_of(above).find("as shares by mass"), std::string::npos);
}

TEST(NamedColumns, ErrorsNameWhatIsWrong) {
    for (const auto& [options, words] : std::vector<std::pair<ReadingOptions, std::string>>{
             {columns("D", &ReadingOptions::passing, "C"), "size: there is no column `D`"},
             {columns("1", &ReadingOptions::share, "9"), "share: there is no column `9`"},
             {columns("1:g", &ReadingOptions::passing, "3"), "a unit does not fit"},
             {columns("1:mm", &ReadingOptions::passing, "1"), "column 1 is named twice: as size and as passing"},
             {columns("1", &ReadingOptions::mass, "3:%"), "a unit does not fit"},
             {columns("", &ReadingOptions::passing, "3"), "one of `passing`, `retained`, `share` and `mass`"},
             {columns("across", &ReadingOptions::passing, "3"), "no line has sizes in its columns"}}) {
        const ParsedSheet parsed = parse_sheet(sheet, "sheet.csv", options);
        EXPECT_TRUE(parsed.soils.empty());
        EXPECT_NE(messages_of(parsed).find(words), std::string::npos) << words << "\n" << messages_of(parsed);
    }
    const ParsedSheet one = parse_sheet("d,x\n1,5\n2,\n", "sheet.csv", columns("1", &ReadingOptions::share, "all"));
    EXPECT_NE(messages_of(one).find("no column has two numbers"), std::string::npos);
    ReadingOptions lines;
    lines.rows = "12";
    EXPECT_NE(messages_of(parse_sheet(sheet, "sheet.csv", lines)).find("are no lines"), std::string::npos);
}

/// A refusal has the flags of a command, and they read the file.
TEST(NamedColumns, ARefusalNamesTheOptionsThatWork) {
    const ParsedSheet refused = parse_sheet("d_mm,weight_percent\n2,5\n1,10\n0.5,15\n0.25,20\n0.125,22\n0.063,28\n");
    ASSERT_TRUE(refused.soils.empty());
    EXPECT_NE(
        refused.remarks.back().help.find("suffuse assess sheet.csv --size 1:mm --share 2 or --size 1:mm --retained 2"),
        std::string::npos
    ) << refused.remarks.back().help;
}

/// A command that reads something else than the sheet says is worse than none.
TEST(NamedColumns, ARefusalOffersNoReadingThatIsWrong) {
    for (const std::string text :
         {"Particle radius (um),finer (%)\n2000,100\n1000,70\n500,40\n100,10\n",              // a radius
          "d [mm],Number (%)\n8,0\n4,10\n2,30\n1,30\n0.5,20\n0.25,10\n",                      // a count
          "BS sieve,% passing\n8,100\n16,70\n40,40\n200,5\n",                                 // numbers are no mm
          "a,b,c\n1,5,8\n2,4,5\n3,100,4\n4,2,2\n",                                            // nothing is named
          "d [mm],TP1 passing [%],TP2 passing [%]\n8,100,100\n4,#N/A,95\n2,70,80\n1,50,60\n", // one of two soils
          "d [mm],passing [%]\n8,100\n4,90\n2,95\n\nd [mm],passing [%]\n1,40\n0.5,20\n"}) {   // one of two tables
        const ParsedSheet refused = parse_sheet(text);
        ASSERT_TRUE(refused.soils.empty()) << text;
        EXPECT_EQ(render(refused.remarks).find("say how to read it"), std::string::npos) << render(refused.remarks);
    }
    const ParsedSheet open = parse_sheet("Diameter,weight_percent\n2,5\n1,10\n0.5,15\n0.25,20\n0.125,22\n0.063,28\n");
    EXPECT_NE(render(open.remarks).find("--size 1:UNIT --share 2"), std::string::npos) << render(open.remarks);
}

TEST(NamedColumns, AllSoilsAreWithoutTheNumbersOfTheRows) {
    const ParsedSheet parsed = parse_sheet(
        "No.,d,P,Q\n1,4,100,100\n2,2,60,70\n3,1,20,30\n", "sheet.csv", columns("d:mm", &ReadingOptions::passing, "all")
    );
    ASSERT_EQ(parsed.soils.size(), 2U) << messages_of(parsed);
    EXPECT_EQ(parsed.soils.front().name, "P");
}

TEST(NamedColumns, ARefusalExchangesNoColumnsThatAreNamed) {
    for (const auto& [text, words, others] : std::vector<std::array<std::string, 3>>{
             {"size_mm,percent_passing\n10,100\n5,80\n5,75\n1,40\n0.1,5\n", "", "--size 2"},
             {"Sieve (mm),Cumulative retained (g)\n19,0\n9.5,120\n4.75,300\n2,500\n0.425,750\n0.075,900\n",
              "--size 1:mm --retained 2", "--size 2"},
             {"Sieve,% Retained\n#4,5\n#10,10\n#20,15\n#40,18\n#60,20\n#100,22\n",
              "--share 2 or --size 1:mm --retained 2", "--size 2"}}) {
        const ParsedSheet refused = parse_sheet(text);
        ASSERT_TRUE(refused.soils.empty()) << text;
        const std::string all = render(refused.remarks);
        EXPECT_NE(all.find(words), std::string::npos) << all;
        EXPECT_EQ(all.find(others), std::string::npos) << all;
    }
}

} // namespace
} // namespace suffuse::gradings
