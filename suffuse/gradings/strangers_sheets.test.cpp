// Sheets of twenty laboratories in the manner of their countries, written with their curves by somebody who had not
// seen the reader: tests/fixtures/sheets/.

#include "suffuse/base/read_text.hpp"
#include "suffuse/gradings/sheets_for_tests.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include <algorithm>
#include <sstream>

namespace suffuse::gradings {
namespace {

using namespace testing;

struct StrangersSheet {
    std::string file;
    std::vector<SheetSoil> soils;            ///< coarsest size first; none where it is refused
    std::vector<std::string> refusals, told; ///< words of errors and of remarks
};

std::string in_sheets(const std::string& file) {
    return test::in_checkout("tests/fixtures/sheets/" + file);
}

std::vector<StrangersSheet> read_strangers_sheets() {
    std::vector<StrangersSheet> sheets;
    std::istringstream lines(read_whole_file(in_sheets("curves.txt")));
    for (std::string line; std::getline(lines, line);) {
        const std::string word = line.substr(0, line.find(' '));
        const std::string rest = line.substr(std::min(line.find(' ') + 1, line.size()));
        if (line.empty() || word == "#") {
            continue;
        }
        if (word == "file") {
            sheets.push_back({rest, {}, {}, {}});
        } else if (word == "refused") {
            sheets.back().refusals.push_back(rest);
        } else if (word == "told") {
            sheets.back().told.push_back(rest);
        } else if (word == "soil") {
            sheets.back().soils.push_back({rest == "soil" ? "" : rest, {}});
        } else {
            sheets.back().soils.back().points.emplace_back(std::stod(word), std::stod(rest));
        }
    }
    return sheets;
}

std::string all_told(const ParsedSheet& parsed) {
    std::string told;
    for (const Diagnostic& remark : parsed.told) {
        told += (remark.code.starts_with("E") ? "error: " : "") + remark.message + "\n";
    }
    return told;
}

/// Shares are given to a hundredth of a percent, sizes to six digits.
void expect_curve(const SheetSoil& wanted, const NamedGrading& found, const std::string& file) {
    EXPECT_EQ(found.name, wanted.name) << file;
    std::string points;
    for (std::size_t k = found.grading.diameter.size(); k-- > 0;) {
        points += fmt::format("{:.6g} {:.4g}\n", 1e3 * found.grading.diameter[k], 100 * found.grading.passing[k]);
    }
    ASSERT_EQ(found.grading.diameter.size(), wanted.points.size()) << file << " " << wanted.name << "\n" << points;
    for (std::size_t k = 0; k < wanted.points.size(); ++k) {
        const std::size_t own = wanted.points.size() - 1 - k; // the reader's rise
        const auto [size, share] = wanted.points[k];
        EXPECT_NEAR(1e3 * found.grading.diameter[own], size, 1e-5 * size) << file << " " << wanted.name;
        EXPECT_NEAR(100 * found.grading.passing[own], share, 0.0051) << file << " " << wanted.name << " " << size;
    }
}

TEST(StrangersSheets, AreReadAsTheirWritersMeantThemOrRefusedWithAReason) {
    const auto sheets = read_strangers_sheets();
    ASSERT_EQ(sheets.size(), 20U);
    for (const StrangersSheet& sheet : sheets) {
        const ParsedSheet parsed = parse_sheet(read_whole_file(in_sheets(sheet.file)), sheet.file);
        const std::string told = all_told(parsed);
        EXPECT_EQ(parsed.soils.size(), sheet.soils.size()) << sheet.file << "\n" << told;
        for (std::size_t k = 0; k < std::min(parsed.soils.size(), sheet.soils.size()); ++k) {
            expect_curve(sheet.soils[k], parsed.soils[k], sheet.file);
        }
        for (const std::string& words : sheet.refusals) {
            EXPECT_NE(told.find("error: " + words), std::string::npos) << sheet.file << "\n" << told;
        }
        for (const std::string& words : sheet.told) {
            EXPECT_NE(told.find(words), std::string::npos) << sheet.file << "\n" << told;
        }
    }
}

TEST(StrangersSheets, ASlipMendedTheSummaryOfTestPitsGivesAllItsSoils) {
    std::string text = read_whole_file(in_sheets("10_resumen_calicatas.csv"));
    const std::size_t slip = text.find("94,8");
    ASSERT_NE(slip, std::string::npos);
    text.replace(slip, 4, "49,8");
    const ParsedSheet parsed = parse_sheet(text);
    ASSERT_EQ(parsed.soils.size(), 5U) << all_told(parsed);
    expect_curve(
        {"C-3 M-1 0,80-2,00",
         {{75, 100},
          {37.5, 100},
          {19, 98},
          {9.5, 93.5},
          {4.75, 85.4},
          {2, 70.2},
          {0.425, 49.8},
          {0.15, 33.7},
          {0.075, 23.1}}},
        parsed.soils[3], "summary"
    );
    expect_curve( // what was not tested is left out
        {"C-4 M-1 1,00-1,50", {{19, 100}, {9.5, 100}, {4.75, 100}, {2, 100}, {0.425, 98}, {0.15, 91.7}, {0.075, 79.6}}},
        parsed.soils[4], "summary"
    );
}

} // namespace
} // namespace suffuse::gradings
