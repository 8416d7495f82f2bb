// A calibration as a user runs it, with samples of few grains: stopped, continued, and only priced.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/program.hpp"
#include <cmath>

namespace suffuse {
namespace {

using test::Cli;
using test::ProgramResult;

const std::string few_grains = R"(schema = 1
title = "few grains"
seed = 2
[grain]
density = "2650 kg/m^3"
[contact]
shear_ratio = 0.42
rolling_stiffness = 7.5
rolling_friction = 0.2
[soil.sand]
psd = { d = ["0.13 mm", "0.14 mm", "0.15 mm"], passing = ["0 %", "50 %", "100 %"] }
[calibrate]
soil = "sand"
particles = 120
samples = 16
targets = [{ name = "t", file = "t.csv", pressure = "100 kPa", strain = 0.01, contraction = "positive", void_ratio_tolerance = 0.03 }]
unknowns = { "contact.modulus" = ["100 MPa", "1 GPa", "log"], "contact.friction" = ["20 deg", "40 deg"], void_ratio = [0.6, 0.75] }
)";

class CalibrateVerb : public Cli {
protected:
    CalibrateVerb() {
        test::write_to(folder / "case.toml", few_grains);
        std::string text = "axial strain [%],q [kPa],volumetric strain [%],p [kPa],operator\n";
        for (int k = 0; k <= 20; ++k) {
            const double q = 200 * (1 - std::exp(-0.4 * k));
            text += fmt::format("{},{},{},{},ab\n", 0.1 * k, q, 0.01 * k, 100 + q / 3);
        }
        test::write_to(folder / "t.csv", text);
    }

    /// Of the calibration in "whole", as it ended and as `report` writes it again.
    void expect_report(const nlohmann::json& answer) {
        const std::string page = test::read_all(folder / "whole/report.html");
        EXPECT_NE(page.find("own-calibration-corner"), std::string::npos);
        EXPECT_NE(page.find("How the records were read"), std::string::npos);
        EXPECT_NE(page.find("(geometric)"), std::string::npos) << "mean of a modulus";
        EXPECT_EQ(page.find("id=\"unfinished\""), std::string::npos);
        std::filesystem::remove(folder / "whole/report.html");
        const ProgramResult again = run_suffuse({"report", "whole"});
        EXPECT_EQ(again.code, 0) << again.error;
        const std::string second = test::read_all(folder / "whole/report.html");
        EXPECT_EQ(second.size(), page.size());
        for (const char* figure : {"intervals", "corner", "fit", "misfits"}) {
            EXPECT_TRUE(std::filesystem::exists(folder / fmt::format("whole/figures/own-calibration-{}.csv", figure)));
        }
        const nlohmann::json listed = run_suffuse({"runs", ".", "--json"}).json().at("runs");
        ASSERT_EQ(listed.size(), 1U);
        EXPECT_EQ(listed[0].at("kind"), "calibration");
        EXPECT_EQ(listed[0].at("state"), "done");
        EXPECT_EQ(listed[0].at("verdict"), answer.at("verdict"));
        EXPECT_EQ(listed[0].at("samples").at("total"), answer.at("samples").size());
    }

    /// Of the calibration in "whole": whole at first, and each change of it is found.
    void expect_verified() {
        const ProgramResult verified = run_suffuse({"verify", "whole", "--json"});
        EXPECT_EQ(verified.code, 0) << verified.out << verified.error;
        EXPECT_GT(verified.json().at("states"), 12) << "of its samples";
        const std::string state = "round-1/studies/t-0002";
        for (const std::string& damaged : {std::string("posterior.csv"), state}) {
            std::filesystem::path file = folder / "whole" / damaged;
            for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "whole" / state)) {
                file = damaged == state && entry.path().filename() == "stage.json" ? entry.path() : file;
            }
            const std::string before = test::read_all(file);
            test::write_to(file, before + " ");
            const ProgramResult changed = run_suffuse({"verify", "whole"});
            EXPECT_EQ(changed.code, 5) << damaged << changed.error;
            EXPECT_NE(changed.out.find("  " + damaged), std::string::npos) << changed.out;
            if (damaged == "posterior.csv") {
                EXPECT_NE(run_suffuse({"report", "whole"}).code, 0) << "no report of what was changed";
            }
            test::write_to(file, before);
        }
        EXPECT_EQ(run_suffuse({"verify", "whole"}).code, 0);
    }

    /// Of the calibration in "whole": with other settings or data it is refused, and stays as it is.
    void expect_others_refused() {
        const auto refused = [&](const std::vector<std::string>& arguments, const std::string& why) {
            const std::string request = test::read_all(folder / "whole/run_options.json");
            const ProgramResult result = run_suffuse(arguments);
            EXPECT_EQ(result.code, 3) << result.out << result.error;
            EXPECT_NE(result.error.find(why), std::string::npos) << result.error;
            EXPECT_EQ(test::read_all(folder / "whole/run_options.json"), request);
            EXPECT_EQ(run_suffuse({"verify", "whole"}).code, 0) << "its answer is whole";
        };
        refused(
            {"calibrate", "case.toml", "-o", "whole", "--no-cache", "--set", "calibrate.particles=130"},
            "with other settings (another calibrate.particles)"
        );
        refused(
            {"calibrate", "case.toml", "-o", "whole", "--no-cache", "--set", "seed=3"}, "other settings (another seed)"
        );
        const std::string before = test::read_all(folder / "t.csv");
        test::write_to(folder / "t.csv", before + "2.1,201,0.21,167,ab\n");
        refused({"resume", "whole", "--no-cache"}, "t.csv has changed since the calibration in whole began");
        test::write_to(folder / "t.csv", before);
        EXPECT_EQ(run_suffuse({"resume", "whole", "--no-cache"}).code, 0);
        EXPECT_EQ(run_suffuse({"verify", "whole"}).code, 0);
        std::filesystem::remove(folder / "whole/calibration_inputs.json");
        const ProgramResult earlier = run_suffuse({"resume", "whole", "--no-cache"});
        EXPECT_EQ(earlier.code, 3) << earlier.out;
        EXPECT_NE(earlier.error.find("an earlier version began this calibration"), std::string::npos) << earlier.error;
    }
};

TEST_F(CalibrateVerb, FindsIntervalsAndContinuesToTheSameBits) {
    const ProgramResult whole = run_suffuse({"calibrate", "case.toml", "-o", "whole", "--no-cache", "--json"});
    ASSERT_EQ(whole.code, 0) << whole.error;
    const nlohmann::json answer = whole.json();
    EXPECT_TRUE(answer.at("complete"));
    EXPECT_NE(whole.error.find("assumed: \"p [kPa]\" is effective"), std::string::npos) << whole.error;
    EXPECT_EQ(answer.at("fit")[0].at("assumed"), nlohmann::json::array({"\"p [kPa]\" is effective"}));
    EXPECT_EQ(answer.at("fit")[0].at("unread"), nlohmann::json::array({"operator"}));
    EXPECT_GE(answer.at("fit")[0].at("band_90"), 1.645);
    EXPECT_EQ(answer.at("rounds").at(0).at("designs"), 12);
    for (const auto& [key, parameter] : answer.at("parameters").items()) {
        EXPECT_LE(parameter.at("low"), parameter.at("high")) << key;
        EXPECT_GE(parameter.at("low"), parameter.at("range").at(0)) << key;
        EXPECT_LE(parameter.at("high"), parameter.at("range").at(1)) << key;
    }
    expect_report(answer);
    expect_verified();
    const ProgramResult none =
        run_suffuse({"calibrate", "case.toml", "-o", "part", "--no-cache", "--time-limit", "1ms"});
    EXPECT_EQ(none.code, 75) << none.error;
    EXPECT_NE(none.error.find("suffuse resume part continues"), std::string::npos) << none.error;
    EXPECT_FALSE(std::filesystem::exists(folder / "part/calibration.json"));
    const ProgramResult unsigned_yet = run_suffuse({"verify", "part"});
    EXPECT_NE(unsigned_yet.code, 0);
    EXPECT_NE(unsigned_yet.error.find("suffuse resume part"), std::string::npos) << unsigned_yet.error;
    const std::string live = test::read_all(folder / "part/report.html");
    EXPECT_NE(live.find("It was stopped early."), std::string::npos);
    EXPECT_NE(live.find("suffuse resume part"), std::string::npos);
    const ProgramResult stopped = run_suffuse({"watch", "part"});
    EXPECT_EQ(stopped.code, 1) << stopped.error;
    EXPECT_NE(stopped.out.find("resume with: suffuse resume part"), std::string::npos) << stopped.out;
    const ProgramResult rest = run_suffuse({"resume", "part", "--no-cache", "--json"});
    ASSERT_EQ(rest.code, 0) << rest.error;
    EXPECT_EQ(rest.json(), answer);
    EXPECT_EQ(test::read_all(folder / "part/posterior.csv"), test::read_all(folder / "whole/posterior.csv"));
    const nlohmann::json watched = run_suffuse({"watch", "part", "--json"}).json();
    EXPECT_EQ(watched.at("ended"), true);
    EXPECT_EQ(watched.at("rounds").size(), answer.at("rounds").size());
    const ProgramResult same = run_suffuse({"compare", "whole", "part", "--json"});
    EXPECT_EQ(same.code, 0) << same.error;
    EXPECT_EQ(same.json().at("differences").size(), 0U);
    EXPECT_EQ(same.json().at("numbers"), 11) << "three of each parameter, and a misfit of each curve";
    expect_others_refused();
}

TEST_F(CalibrateVerb, ShowsItsPriceAndRunsNothing) {
    const ProgramResult plan = run_suffuse({"calibrate", "case.toml", "--plan", "--json"});
    ASSERT_EQ(plan.code, 0) << plan.error;
    EXPECT_EQ(plan.json().at("samples"), 16);
    EXPECT_EQ(plan.json().at("first_round").at("studies"), 12);
    EXPECT_FALSE(std::filesystem::exists(folder / "runs"));
}

TEST_F(CalibrateVerb, IsCheckedAndPricedAsAnyCase) {
    const ProgramResult checked = run_suffuse({"check", "case.toml", "--json"});
    ASSERT_EQ(checked.code, 0) << checked.error;
    EXPECT_EQ(checked.json().at("targets"), 1);
    EXPECT_EQ(checked.json().at("unknowns"), 3);
    const nlohmann::json problems = checked.json().at("problems");
    ASSERT_EQ(problems.size(), 3U);
    EXPECT_EQ(checked.json().at("warnings"), 3);
    EXPECT_EQ(problems[0].at("code"), "W602") << "120 grains make a narrow cell";
    EXPECT_EQ(problems[0].at("line"), 14) << "where the case has its particles";
    for (const std::size_t k : {1U, 2U}) {
        EXPECT_EQ(problems[k].at("code"), "W623") << "of its record";
        EXPECT_EQ(problems[k].at("line"), 16) << "where its target is";
    }
    EXPECT_NE(
        problems[1].at("message").get<std::string>().find("assumed: \"p [kPa]\" is effective"), std::string::npos
    );
    EXPECT_NE(problems[2].at("message").get<std::string>().find("not read: \"operator\""), std::string::npos);
    EXPECT_EQ(run_suffuse({"check", "case.toml", "--set", "calibrate.samples=none"}).code, 3);
    EXPECT_EQ(run_suffuse({"plan", "case.toml", "--json"}).json().at("samples"), 16);
    std::filesystem::remove(folder / "t.csv");
    EXPECT_NE(run_suffuse({"check", "case.toml"}).code, 0) << "its data are part of it";
}

TEST_F(CalibrateVerb, RefusesWhatItCannotUseBeforeAnythingIsMade) {
    test::write_to(folder / "t.csv", "axial strain [%],volumetric strain [%]\n0,0\n1,0.1\n");
    const ProgramResult lacks = run_suffuse({"calibrate", "case.toml", "-o", "r"});
    EXPECT_EQ(lacks.code, 3) << lacks.error;
    EXPECT_NE(lacks.error.find("t.csv:1:1: a triaxial test has a column"), std::string::npos) << lacks.error;
    EXPECT_FALSE(std::filesystem::exists(folder / "r"));
    const ProgramResult run_of_it = run_suffuse({"run", "case.toml"});
    EXPECT_EQ(run_of_it.code, 3);
    EXPECT_NE(run_of_it.error.find("suffuse calibrate CASE"), std::string::npos) << run_of_it.error;
}

} // namespace
} // namespace suffuse
