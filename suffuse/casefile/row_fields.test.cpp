// Rows of a study: values of several keys that belong together.
#include "suffuse/base/constants.hpp"
#include "suffuse/casefile/bind.hpp"
#include "suffuse/casefile/case_for_tests.hpp"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"
#include <cmath>
#include <fstream>

namespace {

using namespace suffuse;
using namespace suffuse::casefile;
using namespace suffuse::casefile::testing;

std::string with_rows(const std::string& line) {
    std::string text = good_case;
    const std::string after = "particles = 20000\n";
    return text.insert(text.find(after) + after.size(), line + "\n");
}

const std::string two_rows =
    R"(rows = { "contact.friction" = ["20 deg", "30 deg"], "stage.initial.pressure" = ["50 kPa", "200 kPa"], seed = [4, 9] })";

const Variant& copy_of(const Case& c, int k) {
    return c.studies.at(0).variants.at(static_cast<std::size_t>(k));
}

void expect_two_rows(const Case& c) {
    ASSERT_EQ(c.studies.at(0).variants.size(), 2U) << "values belong together, and do not multiply";
    EXPECT_EQ(copy_of(c, 0).folder, "one/row=1");
    EXPECT_EQ(copy_of(c, 1).folder, "one/row=2");
    EXPECT_NEAR(copy_of(c, 0).material.friction, radians(20), 1e-12);
    EXPECT_NEAR(copy_of(c, 1).material.friction, radians(30), 1e-12);
    EXPECT_EQ(std::get<packing::CompactSpec>(copy_of(c, 0).stages.at(1).spec).pressure, 50e3);
    EXPECT_EQ(std::get<packing::CompactSpec>(copy_of(c, 1).stages.at(1).spec).pressure, 200e3);
    EXPECT_EQ(copy_of(c, 1).values.at("contact.friction"), Scalar(std::string("30 deg"))) << "in tables of results";
    EXPECT_EQ(copy_of(c, 1).seed, 9U);
}

/// "E207: message" of the first problem.
std::string first_problem(const std::string& text, const std::string& folder = data_folder()) {
    try {
        load_case_text(text, "case.toml", folder);
    } catch (const CaseProblems& found) {
        return found.problems.front().code + ": " + found.problems.front().message;
    }
    return "none";
}

TEST(RowsOfAStudy, AreCopiesWithAllValuesOfTheirRow) {
    const Case c = load(with_rows(two_rows));
    expect_two_rows(c);
    expect_two_rows(load_case_text(resolved_toml(c), "resolved.toml", "/nowhere").value);
}

TEST(RowsOfAStudy, MultiplyWithASweepWhichMayChooseAmongThem) {
    const Case c = load(with_rows(two_rows + "\nsweep = { row = [2], \"contact.rolling_friction\" = [0.1, 0.2] }"));
    ASSERT_EQ(c.studies.at(0).variants.size(), 2U);
    EXPECT_EQ(copy_of(c, 1).folder, "one/row=2/rolling_friction=0.2");
    EXPECT_NEAR(copy_of(c, 1).material.friction, radians(30), 1e-12);
}

TEST(RowsOfAStudy, MayStandInAFile) {
    const test::TempFolder folder;
    std::filesystem::copy(data_folder() + "/data", folder / "data");
    std::ofstream(folder / "twenty.csv") << "# of a posterior\ncontact.friction, stage.initial.pressure,seed\r\n"
                                            "20 deg,50 kPa,4\n\n\"30 deg\",200 kPa,9\n";
    const Case c = load_case_text(with_rows("rows = \"twenty.csv\""), "case.toml", folder.path().string()).value;
    expect_two_rows(c);
    expect_two_rows(load_case_text(resolved_toml(c), "resolved.toml", "/nowhere").value);
    std::ofstream(folder / "twenty.csv") << "contact.friction,seed\n20 deg,4\n30 deg\n";
    const std::string problem = first_problem(with_rows("rows = \"twenty.csv\""), folder.path().string());
    EXPECT_NE(problem.find("twenty.csv:3 has not a value for each heading"), std::string::npos) << problem;
    std::ofstream(folder / "twenty.csv") << "seed,contact.friction,seed\n4,20 deg,5\n";
    const std::string twice = first_problem(with_rows("rows = \"twenty.csv\""), folder.path().string());
    EXPECT_NE(twice.find("twenty.csv:1 has the heading `seed` twice"), std::string::npos) << twice;
}

TEST(RowsOfAStudy, AreRefusedWhereTheyDoNotFit) {
    EXPECT_EQ(first_problem(with_rows("rows = 3")).substr(0, 4), "E205");
    EXPECT_EQ(first_problem(with_rows("rows = \"none.csv\"")).substr(0, 4), "E501");
    EXPECT_EQ(
        first_problem(with_rows("rows = { seed = [1, 2], \"contact.friction\" = [\"20 deg\"] }")),
        "E205: `rows` needs a value of each key in each row"
    );
    EXPECT_EQ(
        first_problem(with_rows("rows = { seed = [1, 2] }\nsweep = { seed = [3] }")),
        "E207: `seed` is in `rows` and in `sweep`"
    );
    EXPECT_EQ(
        first_problem(with_rows("rows = { seed = [1, 2] }\nsweep = { row = [3] }")),
        "E203: the sweep over `row` has values that no row has: 1 to 2"
    );
    const std::string unknown = first_problem(with_rows("rows = { \"contact.frixion\" = [1, 2] }"));
    EXPECT_NE(unknown.find("frixion"), std::string::npos) << unknown;
}

} // namespace
