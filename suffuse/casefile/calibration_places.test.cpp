#include "suffuse/casefile/calibration_places.hpp"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"
#include <fstream>

namespace suffuse::casefile {
namespace {

/// The lines of its errors, by their codes.
std::vector<std::pair<std::string, int>> errors_of(const std::string& contact, const std::string& unknowns) {
    const test::TempFolder folder;
    std::ofstream(folder / "t.csv") << "axial strain [%],q [kPa]\n0,0\n1,100\n";
    std::ofstream(folder / "case.toml") << "schema = 1\n[contact]\n"
                                        << contact << R"(
[soil.sand]
psd = { d = ["0.1 mm", "0.2 mm"], passing = ["0 %", "100 %"] }
[calibrate]
soil = "sand"
targets = [{ file = "t.csv", pressure = "100 kPa" }]
[calibrate.unknowns]
)" << unknowns << "\n";
    std::vector<std::pair<std::string, int>> found;
    try {
        load_calibration((folder / "case.toml").string());
    } catch (const CaseProblems& problems) {
        for (const Diagnostic& problem : problems.problems) {
            if (!problem.is_warning) {
                EXPECT_EQ(problem.file, (folder / "case.toml").string());
                found.emplace_back(problem.code, problem.line);
            }
        }
    }
    return found;
}

const std::string sought = "void_ratio = [0.6, 0.7]\n\"contact.friction\" = [\"20 deg\", \"40 deg\"]";

TEST(CalibrationPlaces, AWrongKeyOfTheCaseHasItsOwnLine) {
    const auto errors = errors_of("modulus = \"1 GPa\"\nfrictoin = 0.5", sought);
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0].second, 4);
}

TEST(CalibrationPlaces, AKeyThatIsMissingIsNamedAtItsTable) {
    const auto errors = errors_of("law = \"hertz-mindlin\"\npoisson = 0.2", sought);
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0], std::pair(std::string("E201"), 2));
}

TEST(CalibrationPlaces, AValueThatNoSampleCanHaveIsNamedAtItsUnknown) {
    const auto errors =
        errors_of("modulus = \"1 GPa\"", sought + "\n\"contact.rolling_friction\" = [\"1 kPa\", \"2 kPa\"]");
    ASSERT_FALSE(errors.empty());
    EXPECT_EQ(errors[0].second, 12);
}

TEST(CalibrationPlaces, AnUnknownThatNoSampleCanHaveIsNamedAtItsLineOnce) {
    const auto errors = errors_of("modulus = \"1 GPa\"", sought + "\n\"contact.frictoin\" = [0.1, 0.2]");
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0].second, 12);
}

} // namespace
} // namespace suffuse::casefile
