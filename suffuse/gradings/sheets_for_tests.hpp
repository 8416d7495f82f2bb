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

struct ParsedSheet {
    std::vector<NamedGrading> soils;
    std::vector<Diagnostic> remarks;
};

inline ParsedSheet
parse_sheet(const std::string& text, const std::string& file = "sheet.csv", const ReadingOptions& options = {}) {
    Problems problems;
    ParsedSheet parsed;
    const auto source = std::make_shared<Source>(Source{file, text});
    parsed.soils = parse_gradings(source, problems, CurveEnds::MayBeOpen, options);
    parsed.remarks = problems.sorted();
    return parsed;
}

/// A message a line; a page of them keeps the rest of many to itself.
inline std::string messages_of(const ParsedSheet& parsed) {
    std::string remarks;
    for (const Diagnostic& remark : parsed.remarks) {
        remarks += remark.message + "\n";
    }
    return remarks;
}

struct SheetTolerance {
    double size = 1e-9, passing = 6e-4; ///< of the size; [%], as printed to five digits
};

inline void expect_soil(
    const SheetSoil& wanted, const NamedGrading& found, const std::string& file, const SheetTolerance& tolerance = {}
) {
    EXPECT_EQ(found.name, wanted.name) << file;
    const std::vector<double>& diameter = found.grading.diameter;
    ASSERT_EQ(diameter.size(), wanted.points.size()) << file << " " << wanted.name;
    for (std::size_t k = 0; k < wanted.points.size(); ++k) {
        const auto [size, share] = wanted.points[k];
        EXPECT_NEAR(1e3 * diameter[k], size, tolerance.size * size) << file << " " << wanted.name;
        EXPECT_NEAR(100 * found.grading.passing[k], share, tolerance.passing)
            << file << " " << wanted.name << " " << size;
    }
}

} // namespace suffuse::gradings::testing
