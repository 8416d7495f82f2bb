#include "suffuse/casefile/wide_checks.hpp"

#include "suffuse/casefile/case_for_tests.hpp"

#include <gtest/gtest.h>

#include <string>

namespace suffuse::casefile {
namespace {

using namespace testing;

TEST(WideChecks, FineGrainsBetweenMuchCoarserOnesNeedAStifferContact) {
    EXPECT_DOUBLE_EQ(squeezed_overlap_at(2e5, {}, 8), 8 * squeezed_overlap_at(1e5, {}, 4));
    const std::string wide = replaced(
        replaced(
            good_case, "psd = \"data/sand.csv\"",
            "psd = { d = [\"0.1 mm\", \"1.2 mm\"], passing = [\"0 %\", \"100 %\"] }"
        ),
        "20000", "300000"
    );
    const Diagnostic found = find_problem(problems_of(wide), "W609");
    EXPECT_EQ(found.line, 14);
    const std::size_t quote = found.help.find('"');
    const std::string advised = found.help.substr(quote + 1, found.help.find('"', quote + 1) - quote - 1);
    const std::string stiffer =
        replaced(wide, "schema = 1\n", "schema = 1\n[contact]\nmodulus = \"" + advised + "\"\n");
    EXPECT_EQ(find_problem(problems_of(stiffer), "W609").code, "");
    EXPECT_EQ(find_problem(problems_of(good_case), "W609").code, "");
}

TEST(WideChecks, AWideGradingNeedsTheProtocolForWideGradingsAndANarrowOneAnother) {
    const auto with = [](const std::string& finest, const std::string& protocol) {
        const std::string soil = "coarse = { psd = { d = [\"1 mm\", \"1.2 mm\"], passing = [\"0 %\", \"100 %\"] } }\n"
                                 "fines = { psd = { d = [\"" +
                                 finest +
                                 "\", \"0.7 mm\"], passing = [\"0 %\", \"100 %\"] } }\nfines_content = \"20 %\"";
        return problems_of(replaced(
            replaced(good_case, "psd = \"data/sand.csv\"\nfines = { finer_than = \"0.15 mm\" }", soil),
            "pressure = \"100 kPa\"", "pressure = \"1 kPa\"\nprotocol = \"" + protocol + "\""
        ));
    };
    for (const std::string protocol : {"faithful", "slow", "swift"}) {
        const Diagnostic found = find_problem(with("0.08 mm", protocol), "W616"); // fifteen times
        EXPECT_TRUE(found.is_warning) << protocol;
        EXPECT_NE(found.message.find(protocol), std::string::npos);
        EXPECT_NE(found.help.find("wide"), std::string::npos);
        EXPECT_EQ(find_problem(with("0.6 mm", protocol), "W616").code, "") << protocol;
    }
    EXPECT_EQ(find_problem(with("0.12 mm", "swift"), "W616").is_warning, true); // ten times: only swift fails
    EXPECT_EQ(find_problem(with("0.12 mm", "faithful"), "W616").code, "");
    const std::string curve = "psd = { d = [\"0.08 mm\", \"1.2 mm\"], passing = [\"0 %\", \"100 %\"] }";
    EXPECT_EQ(find_problem(problems_of(replaced(good_case, "psd = \"data/sand.csv\"", curve)), "W616").code, "")
        << "a curve without a gap was not looked at";
    EXPECT_EQ(find_problem(with("0.08 mm", "wide"), "W616").code, "");
    EXPECT_EQ(find_problem(with("0.08 mm", "wide"), "W615").code, "");
    const Diagnostic narrow = find_problem(with("0.6 mm", "wide"), "W615");
    EXPECT_TRUE(narrow.is_warning);
    EXPECT_NE(narrow.help.find("faithful"), std::string::npos);
}

TEST(WideChecks, WideWarnsOfFinesThatOverlapByMoreThanFivePercentWithTheModulusThatHelps) {
    const auto with = [](const std::string& modulus, const std::string& protocol) {
        const std::string psd = "psd = { d = [\"0.08 mm\", \"1.2 mm\"], passing = [\"0 %\", \"100 %\"] }";
        return problems_of(replaced(
            replaced(
                replaced(good_case, "psd = \"data/sand.csv\"", psd), "schema = 1\n",
                "schema = 1\n[contact]\nmodulus = \"" + modulus + "\"\n"
            ),
            "pressure = \"100 kPa\"", "pressure = \"100 kPa\"\nprotocol = \"" + protocol + "\""
        ));
    };
    const Diagnostic found = find_problem(with("1.5 GPa", "wide"), "W609");
    EXPECT_NE(found.help.find("keeps trapped fines below 5 %"), std::string::npos) << found.help;
    EXPECT_EQ(find_problem(with("1.5 GPa", "faithful"), "W609").code, ""); // which promises no more than 10 %
    const std::size_t quote = found.help.find('"');
    const std::string advised = found.help.substr(quote + 1, found.help.find('"', quote + 1) - quote - 1);
    EXPECT_EQ(find_problem(with(advised, "wide"), "W609").code, "") << advised;
}

} // namespace
} // namespace suffuse::casefile
