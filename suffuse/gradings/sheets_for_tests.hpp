#pragma once
// Sheets and the curves that are in them, for tests of the readers of gradings.

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/gradings/read_grading.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace suffuse::gradings::testing {

struct SheetSoil {
    std::string name;
    std::vector<std::pair<double, double>> points; ///< size [mm], passing [%]
};

struct SheetSample {
    std::string file, text;
    std::vector<SheetSoil> soils;
    std::string remark; ///< part of the expected remark; empty: none
};

struct ParsedSheet {
    std::vector<NamedGrading> soils;
    std::vector<Diagnostic> told;
};

inline ParsedSheet parse_sheet(const std::string& text, const std::string& file = "sheet.csv") {
    Problems problems;
    ParsedSheet parsed;
    parsed.soils = parse_gradings(std::make_shared<Source>(Source{file, text}), problems, CurveEnds::MayBeOpen);
    parsed.told = problems.sorted();
    return parsed;
}

/// Percents as printed to five digits.
inline void expect_soil(const SheetSoil& wanted, const NamedGrading& found, const std::string& file) {
    EXPECT_EQ(found.name, wanted.name) << file;
    ASSERT_EQ(found.grading.diameter.size(), wanted.points.size()) << file;
    for (std::size_t k = 0; k < wanted.points.size(); ++k) {
        EXPECT_NEAR(1e3 * found.grading.diameter[k], wanted.points[k].first, 1e-9 * wanted.points[k].first) << file;
        EXPECT_NEAR(100 * found.grading.passing[k], wanted.points[k].second, 6e-4) << file;
    }
}

inline void expect_sheets(const std::vector<SheetSample>& sheets) {
    for (const SheetSample& sheet : sheets) {
        const ParsedSheet parsed = parse_sheet(sheet.text, sheet.file);
        EXPECT_EQ(parsed.soils.size(), sheet.soils.size()) << sheet.file << "\n" << render(parsed.told);
        if (parsed.soils.size() != sheet.soils.size()) {
            continue;
        }
        for (std::size_t k = 0; k < sheet.soils.size(); ++k) {
            expect_soil(sheet.soils[k], parsed.soils[k], sheet.file);
        }
        std::string told = render(parsed.told); // which keeps the rest of many to itself
        for (const Diagnostic& remark : parsed.told) {
            told += "\n" + remark.message;
        }
        if (sheet.remark.empty()) {
            EXPECT_EQ(told.find("W508"), std::string::npos) << sheet.file << told;
        } else {
            EXPECT_NE(told.find(sheet.remark), std::string::npos) << sheet.file << told;
        }
    }
}

} // namespace suffuse::gradings::testing
