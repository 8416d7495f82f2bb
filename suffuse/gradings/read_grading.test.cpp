// The order in which rows come, the choice of a sample, and how much is read at all: sheets that are made up here.
// Those of laboratories are in tests/sheets/.

#include "suffuse/gradings/sheets_for_tests.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace suffuse::gradings {
namespace {

using namespace testing;

TEST(ReadGrading, SievesAndAHydrometerMayRunInAnyDirection) {
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
            ASSERT_EQ(parsed.soils.size(), 1U) << text << render(parsed.remarks);
            expect_soil(
                {"", {{0.002, 5}, {0.006, 10}, {0.02, 20}, {0.075, 35}, {0.2, 50}, {0.5, 80}, {2, 100}}},
                parsed.soils.front(), text
            );
        }
    }
}

TEST(ReadGrading, RowsOfAnAgsFileMayComeInAnyOrder) {
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
            ASSERT_EQ(parsed.soils.size(), 1U) << render(parsed.remarks);
            expect_soil({"", {{0.002, 1}, {0.02, 2}, {0.063, 3}, {0.2, 21}, {2, 100}}}, parsed.soils.front(), "ags");
        }
    }
}

TEST(ReadGrading, OneSampleIsChosenByNameAndAWrongNameIsAnsweredWithThoseThereAre) {
    const auto source =
        std::make_shared<Source>(Source{"w.csv", "d [mm],TP1,TP2\n0.063,4,6\n0.2,15,20\n2,70,75\n6.3,100,100\n"});
    const GradingFile one = read_gradings(source, CurveEnds::MayBeOpen, "tp2");
    ASSERT_EQ(one.soils.size(), 1U);
    EXPECT_EQ(one.soils.front().name, "TP2");
    const auto capitals = std::make_shared<Source>(Source{"c.csv", "d [mm],A,a\n0.2,0,0\n0.5,20,70\n2,100,100\n"});
    EXPECT_EQ(read_gradings(capitals, CurveEnds::MayBeOpen, "a").soils.front().grading.passing[1], 0.7);
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

TEST(ReadGrading, AFileOfOneSoilMustHaveTheNameToo) {
    const auto read = [](const std::string& text, const std::string& sample) -> std::string {
        try {
            const auto source = std::make_shared<Source>(Source{"s.csv", text});
            return read_gradings(source, CurveEnds::MayBeOpen, sample).soils.front().sample;
        } catch (const CaseError& problem) {
            return problem.what();
        }
    };
    const std::string rows = "0.063,5\n0.2,20\n2,90\n6,100\n";
    const std::string column = "Sample,d [mm],passing [%]\nTP9,0.063,5\nTP9,0.2,20\nTP9,2,90\nTP9,6,100\n";
    const std::string across = "Sample,6 mm,2 mm,0.2 mm\nTP9,100,90,20\n";
    for (const std::string& text :
         {column, "Sample: TP9\nd [mm],passing [%]\n" + rows, "d [mm],TP9\n" + rows, "d [mm],TP9 passing [%]\n" + rows,
          across}) {
        EXPECT_EQ(read(text, "tp9"), "TP9") << text;
        EXPECT_NE(read(text, "B2").find("no sample B2; it has TP9"), std::string::npos) << read(text, "B2");
    }
    EXPECT_NE(read("d [mm],passing [%]\n" + rows, "TP1").find("names no sample"), std::string::npos);
}

TEST(ReadGrading, Utf16OfEitherOrderIsReadAndAFileThatEndsWithinASignIsRefused) {
    const std::u16string text = u"Sample,d [mm],Durchgang [%]\n\U0001F3D6\u00f6,0.2,0\n\U0001F3D6\u00f6,2,100\n";
    for (const bool is_big : {false, true}) {
        std::string bytes = is_big ? "\xFE\xFF" : "\xFF\xFE";
        for (const char16_t unit : text) {
            const auto high = static_cast<char>(unit >> 8U), low = static_cast<char>(unit & 0xFFU);
            bytes += is_big ? std::string{high, low} : std::string{low, high};
        }
        const ParsedSheet parsed = parse_sheet(bytes);
        ASSERT_EQ(parsed.soils.size(), 1U) << render(parsed.remarks);
        EXPECT_EQ(parsed.soils.front().sample, "\U0001F3D6\u00f6");
        expect_soil({"", {{0.2, 0}, {2, 100}}}, parsed.soils.front(), "utf16");
        bytes.pop_back();
        EXPECT_NE(render(parse_sheet(bytes).remarks).find("UTF-16 text that is cut off"), std::string::npos);
    }
    EXPECT_TRUE(parse_sheet("\xFF\xFE\x3c\xd8\x41\x42").soils.empty()); // half of a pair
}

/// Where each cell's column was counted from the start of its line, 32,000 columns took a minute: these would take
/// hours.
TEST(ReadGrading, ATableOfFourHundredThousandColumnsIsRefused) {
    std::string text(400'000, ',');
    text += "\n";
    EXPECT_TRUE(parse_sheet("d" + text + "1" + text).soils.empty());
    std::string names = "d";
    for (int k = 0; k < 400'000; ++k) {
        names += ",a";
    }
    const ParsedSheet parsed = parse_sheet(names + "\n1,2\n");
    EXPECT_NE(render(parsed.remarks).find("400001 columns"), std::string::npos)
        << render(parsed.remarks).substr(0, 300);
}

} // namespace
} // namespace suffuse::gradings
