// Calibrations whose samples obey a law in closed form, in place of simulations: the answer is known.

#include "suffuse/job/calibrate.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/random.hpp"
#include "suffuse/casefile/bind.hpp"
#include "suffuse/job/calibration_files.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/stored_findings.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"
#include <cmath>
#include <fstream>
#include <set>

namespace suffuse::job {
namespace {

/// A sand whose stress ratio rises to a friction's, at a rate that stiffness over pressure gives; it dilates by how
/// much denser it is than 0.7.
struct Law {
    double friction, modulus, void_ratio, pressure;
    double rolling = 0; ///< adds to the friction, and to the dilation

    [[nodiscard]] double stress_ratio(double strain) const {
        const double sine = std::sin(friction + rolling), peak = 6 * sine / (3 - sine);
        return 3 * peak / (3 - peak) * -std::expm1(-strain * std::sqrt(modulus / pressure));
    }

    [[nodiscard]] double volumetric_strain(double strain) const { return -4 * (0.7 - void_ratio + rolling) * strain; }
};

constexpr double true_friction = 0.5, true_modulus = 3e8, true_void_ratio = 0.62;

std::string record_of(const std::vector<double>& pressures, bool has_volume) {
    std::string text =
        has_volume ? "test,axial strain [%],q [kPa],volumetric strain [%]\n" : "test,axial strain [%],q [kPa]\n";
    for (const double pressure : pressures) {
        const Law law{true_friction, true_modulus, true_void_ratio, pressure};
        for (int k = 0; k <= 100; ++k) {
            const double strain = 0.001 * k;
            text +=
                fmt::format("p{:.0f},{},{}", pressure / 1e3, 100 * strain, law.stress_ratio(strain) * pressure / 1e3);
            text += has_volume ? fmt::format(",{}\n", 100 * law.volumetric_strain(strain)) : "\n";
        }
    }
    return text;
}

const std::string head = R"(schema = 1
title = "law"
[contact]
modulus = "300 MPa"
[soil.sand]
psd = { d = ["0.1 mm", "0.2 mm"], passing = ["0 %", "100 %"] }
[calibrate]
soil = "sand"
samples = 40
)";
const std::string contact_unknowns =
    "\"contact.friction\" = [\"15 deg\", \"45 deg\"], \"contact.modulus\" = [\"100 MPa\", \"3 GPa\", \"log\"]";

class Calibrate : public testing::Test {
protected:
    casefile::CalibrationCase load(const std::string& text, const std::string& record) {
        std::ofstream(folder / "t.csv") << record;
        std::ofstream(folder / "case.toml") << text;
        return casefile::load_calibration((folder / "case.toml").string());
    }

    /// Writes what simulations would leave; samples of `fails` fail.
    bool pretend(const CalibrationRound& round) {
        record::open_folder(round.folder, round.samples, "");
        for (const casefile::Study& study : round.samples.studies) {
            const casefile::Variant& variant = study.variants.at(0);
            const auto& compact = std::get<packing::CompactSpec>(variant.stages.at(1).spec);
            const Law law{
                variant.material.friction, variant.material.modulus, compact.void_ratio.value_or(0), compact.pressure,
                rolling_counts * variant.material.rolling_friction};
            ++simulated;
            const casefile::Stage& last = variant.stages.back();
            const std::filesystem::path stage = record::stage_folder(round.folder, variant, last);
            std::filesystem::create_directories(stage);
            if (fails && fails(law)) {
                record::keep_failure(round.folder, {variant.folder, last.name, "run", "the void ratio was not met"});
                continue;
            }
            record::StageFindings findings;
            const double noise = scatter * RandomStream(static_cast<std::uint64_t>(simulated), "scatter").normal();
            for (int k = 0; k <= 250; ++k) {
                const double strain = 0.00045 * k;
                triaxial::PathRow& row = findings.curve.emplace_back();
                row.axial_strain = -std::log1p(-strain);
                row.volumetric_strain = -std::log1p(-law.volumetric_strain(strain) * (1 + noise));
                row.deviator_stress = law.stress_ratio(strain) * law.pressure * (1 + noise);
            }
            record::save_findings(stage, findings);
        }
        return round.number < stops_in;
    }

    CalibrationResult calibrated(const casefile::CalibrationCase& what) {
        return calibrate(what, {folder / fmt::format("run-{}", ++runs), [&](const CalibrationRound& round) {
                                    return pretend(round);
                                }});
    }

    test::TempFolder folder;
    std::function<bool(const Law&)> fails;
    double rolling_counts = 0, scatter = 0;
    int simulated = 0, runs = 0, stops_in = 100;
};

const std::string two_pressures = head + R"(targets = [
  { name = "low", file = "t.csv", sample = "p100", pressure = "100 kPa", contraction = "positive" },
  { name = "high", file = "t.csv", sample = "p400", pressure = "400 kPa", contraction = "positive", void_ratio_of = "low" },
  { name = "later", file = "t.csv", sample = "p200", pressure = "200 kPa", contraction = "positive", void_ratio_of = "low", held_out = true },
]
unknowns = { )" + contact_unknowns +
                                  " }\n";

void expect_truth(const CalibrationResult& result) {
    const std::vector<double> truth = {true_friction, true_modulus, true_void_ratio};
    ASSERT_EQ(result.parameters.size(), truth.size());
    for (std::size_t k = 0; k < truth.size(); ++k) {
        const ParameterResult& p = result.parameters[k];
        EXPECT_LT(p.low, truth[k]) << p.unknown.key;
        EXPECT_GT(p.high, truth[k]) << p.unknown.key;
        EXPECT_TRUE(p.interval.is_identified()) << p.unknown.key << " has " << p.interval.width << " of its range";
        EXPECT_EQ(p.interval.bound, calibration::Bound::None);
        EXPECT_EQ(p.remedy, Remedy::None);
    }
}

TEST_F(Calibrate, FindsTheParametersOfTheLawAndPredictsAHeldOutTest) {
    const auto what = load(two_pressures, record_of({100e3, 400e3, 200e3}, true));
    const CalibrationResult result = calibrated(what);
    EXPECT_TRUE(result.is_complete);
    expect_truth(result);
    EXPECT_GT(result.effective_samples, 1000);
    ASSERT_EQ(result.fits.size(), 3U);
    for (const TargetFit& fit : result.fits) { // the scatter that was expected is 3 %
        EXPECT_LT(relative_misfit(fit, 0), 0.05) << fit.target.name;
        EXPECT_LT(relative_misfit(fit, 1), 0.05) << fit.target.name;
    }
    EXPECT_EQ(result.fits[2].target.name, "later");
    EXPECT_EQ(result.fits[2].samples, 8);
    EXPECT_NEAR(result.fits[2].band, 1.895 * std::sqrt(1 + 1.0 / 8), 1e-3) << "Student's t of the ninth sample";
    EXPECT_GT(result.fits[0].band, 1.645) << "of an emulator from few runs";
    int designs = 0;
    for (const RoundResult& round : result.rounds) {
        designs += round.designs;
    }
    EXPECT_LE(designs, 40);
    EXPECT_EQ(simulated, 2 * designs + 8);
    ASSERT_EQ(std::ssize(result.samples), simulated);
    EXPECT_EQ(result.samples.front().round, "round-1");
    EXPECT_EQ(result.samples.back().round, "held-out");
    const auto nearest = std::ranges::min_element(result.samples, {}, &SampleFit::misfit);
    EXPECT_LT(nearest->misfit, 0.1) << "of a sample";
    EXPECT_LT(std::abs(nearest->values[0] - true_friction), 0.1);
    EXPECT_EQ(result.rounds.back().parameters.size(), 3U);
    EXPECT_LT(result.rounds.back().width, 0.1) << "a scatter of 3 % over ranges in which the curves change by a factor";
}

TEST_F(Calibrate, TakesFailedSamplesAsData) {
    const auto what = load(two_pressures, record_of({100e3, 400e3, 200e3}, true));
    fails = [](const Law& law) { return law.void_ratio > 0.72 || (law.pressure > 3e5 && law.void_ratio > 0.68); };
    const CalibrationResult result = calibrated(what);
    expect_truth(result);
    EXPECT_GT(result.fits[1].failed, result.fits[0].failed);
    EXPECT_GT(result.fits[0].failed, 0);
    EXPECT_EQ(result.failures.size(), static_cast<std::size_t>(result.fits[0].failed + result.fits[1].failed));
    EXPECT_EQ(
        std::ranges::count(result.samples, "the void ratio was not met", &SampleFit::failure),
        std::ssize(result.failures)
    );
    int later = 0; // almost none where samples were known to fail
    for (std::size_t k = 1; k < result.rounds.size(); ++k) {
        later += result.rounds[k].failed;
    }
    EXPECT_LE(later, result.rounds[0].failed / 4);
}

TEST_F(Calibrate, SaysWhatIsWrongWhereTooFewSamplesSucceed) {
    const auto what = load(two_pressures, record_of({100e3, 400e3, 200e3}, true));
    fails = [](const Law& law) { return law.pressure > 3e5; };
    try {
        calibrated(what);
        FAIL();
    } catch (const StateError& error) {
        EXPECT_EQ(std::string(error.what()).rfind("target \"high\": 0 of 20 samples succeeded", 0), 0U) << error.what();
        EXPECT_NE(std::string(error.what()).find("the void ratio was not met"), std::string::npos);
    }
}

TEST_F(Calibrate, AnswersThoughAFewOfAFirstRoundFail) {
    std::string text = two_pressures;
    text.replace(text.find("40"), 2, "14");                // samples
    fails = [this](const Law&) { return simulated <= 8; }; // four designs of both targets
    const CalibrationResult result = calibrated(load(text, record_of({100e3, 400e3, 200e3}, true)));
    EXPECT_TRUE(result.is_complete);
    EXPECT_EQ(result.rounds.front().designs, 12);
    EXPECT_EQ(result.rounds.front().failed, 8);
}

TEST_F(Calibrate, NamesWhatItsDataDoNotIdentifyAndWhatWould) {
    const std::string text = head + R"(targets = [{ file = "t.csv", pressure = "100 kPa" }]
unknowns = { )" + contact_unknowns +
                             " }\n";
    const CalibrationResult result = calibrated(load(text, record_of({100e3}, false)));
    ASSERT_EQ(result.parameters.size(), 3U);
    EXPECT_TRUE(result.parameters[0].interval.is_identified());
    EXPECT_TRUE(result.parameters[1].interval.is_identified());
    EXPECT_EQ(result.parameters[2].unknown.key, "void_ratio");
    EXPECT_FALSE(result.parameters[2].interval.is_identified()) << "stresses do not depend on it";
    EXPECT_EQ(result.parameters[2].remedy, Remedy::VolumetricStrain) << "which does";
    const nlohmann::json json = calibration_json(load(text, record_of({100e3}, false)), result);
    EXPECT_EQ(json.at("parameters").at("void_ratio").at("identified"), false);
    EXPECT_EQ(json.at("parameters").at("void_ratio").at("identified_by"), "volumetric_strain");
}

TEST_F(Calibrate, LeavesRollingResistanceOpenWhereItReplacesFriction) {
    const std::string unknowns =
        R"(unknowns = { "contact.friction" = ["15 deg", "30 deg"], "contact.rolling_friction" = [0.0, 0.6] }
fix_void_ratio = true
)";
    const std::string target =
        R"(targets = [{ file = "t.csv", pressure = "100 kPa", contraction = "positive", void_ratio = 0.62 }]
)";
    rolling_counts = 15 * pi / 180 / 0.6; // both ranges change the angle alike
    const CalibrationResult by_stress = calibrated(load(head + target + unknowns, record_of({100e3}, false)));
    for (const ParameterResult& parameter : by_stress.parameters) {
        EXPECT_FALSE(parameter.interval.is_identified())
            << parameter.unknown.key << ": " << parameter.interval.information << " bits of one sum";
        EXPECT_EQ(parameter.remedy, Remedy::VolumetricStrain);
    }
    const CalibrationResult by_both = calibrated(load(head + target + unknowns, record_of({100e3}, true)));
    for (const ParameterResult& parameter : by_both.parameters) {
        EXPECT_TRUE(parameter.interval.is_identified())
            << parameter.unknown.key << ": " << parameter.interval.information << " bits";
    }
}

TEST_F(Calibrate, NamesLargerSamplesAsRemedy) {
    scatter = 0.5;
    const CalibrationResult result = calibrated(load(two_pressures, record_of({100e3, 400e3, 200e3}, true)));
    const ParameterResult& friction = result.parameters[0];
    EXPECT_FALSE(friction.interval.is_identified()) << friction.interval.information;
    EXPECT_EQ(friction.remedy, Remedy::LargerSamples);
    EXPECT_GT(result.fits[0].seed_scatter[5], 0.1 * result.fits[0].laboratory.values[5]);
}

TEST_F(Calibrate, NamesABoundThatItsRangesEndAt) {
    std::string text = two_pressures;
    text.replace(text.find("\"45 deg\""), 8, "\"26 deg\""); // the truth is 28.6 deg
    const CalibrationResult result = calibrated(load(text, record_of({100e3, 400e3, 200e3}, true)));
    EXPECT_EQ(result.parameters[0].interval.bound, calibration::Bound::High);
}

TEST_F(Calibrate, KeepsToItsConstraints) {
    const std::string text =
        two_pressures + "constraints = [\"void_ratio <= 1.1 * contact.friction\"]\n"; // 0.55 at the truth
    const auto what = load(text, record_of({100e3, 400e3, 200e3}, true));
    const CalibrationResult result = calibrated(what);
    for (const std::vector<double>& row : result.posterior) {
        EXPECT_LE(row[2], 1.1 * row[0]);
    }
}

TEST_F(Calibrate, GivesWhatItKnowsWhereItIsStopped) {
    const auto what = load(two_pressures, record_of({100e3, 400e3, 200e3}, true));
    stops_in = 1;
    EXPECT_TRUE(calibrated(what).parameters.empty());
    stops_in = 2;
    const CalibrationResult early = calibrated(what);
    EXPECT_FALSE(early.is_complete);
    EXPECT_EQ(early.rounds.size(), 1U);
    EXPECT_EQ(early.parameters.size(), 3U);
}

TEST_F(Calibrate, ShowsWhatItKnowsAfterEachRound) {
    const auto what = load(two_pressures, record_of({100e3, 400e3, 200e3}, true));
    std::vector<std::size_t> seen;
    CalibrationOptions options{folder / "seen", [&](const CalibrationRound& round) { return pretend(round); }};
    options.on_round = [&](const CalibrationResult& so_far) {
        EXPECT_FALSE(so_far.is_complete);
        EXPECT_EQ(so_far.parameters.size(), 3U);
        seen.push_back(so_far.samples.size());
    };
    const CalibrationResult result = calibrate(what, options);
    EXPECT_EQ(seen.size(), result.rounds.size());
    EXPECT_TRUE(std::ranges::is_sorted(seen));
    EXPECT_EQ(seen.front(), 2U * static_cast<std::size_t>(result.rounds.front().designs));
}

TEST_F(Calibrate, GivesTheSameBitsAgain) {
    const auto what = load(two_pressures, record_of({100e3, 400e3, 200e3}, true));
    const CalibrationResult first = calibrated(what), second = calibrated(what);
    EXPECT_EQ(calibration_json(what, first), calibration_json(what, second));
    EXPECT_EQ(first.posterior, second.posterior);
}

TEST_F(Calibrate, LeavesFilesForTheNextCase) {
    const auto what = load(two_pressures, record_of({100e3, 400e3, 200e3}, true));
    const CalibrationResult result = calibrated(what);
    write_calibration(folder.path(), what, result);
    const nlohmann::json json = record::read_json(folder / "calibration.json");
    EXPECT_NEAR(json.at("parameters").at("contact.friction").at("mean").get<double>(), true_friction, 0.03)
        << "in radians";
    EXPECT_EQ(json.at("parameters").at("contact.friction").at("si_unit"), "rad");
    EXPECT_EQ(json.at("parameters").at("contact.modulus").at("si_unit"), "Pa");
    EXPECT_EQ(json.at("parameters").at("void_ratio").at("si_unit"), "-");
    EXPECT_EQ(json.at("correlation").at("contact.friction").at("contact.friction"), 1.0);
    EXPECT_EQ(json.at("fit").size(), 2U);
    EXPECT_EQ(json.at("held_out").at(0).at("target"), "later");
    std::ifstream table(folder / "posterior.csv");
    std::string line;
    std::getline(table, line);
    EXPECT_EQ(line, "contact.friction,contact.modulus,void_ratio");
    const std::string block = contact_block(what, result);
    const std::string text = "schema = 1\n" + block + R"([soil.sand]
psd = { d = ["0.1 mm", "0.2 mm"], passing = ["0 %", "100 %"] }
[study.s]
soil = "sand"
particles = 300
[[study.s.stage]]
name = "cloud"
do = "pack"
)";
    const casefile::Case next = casefile::load_case_text(text, "next.toml", ".").value;
    EXPECT_NEAR(next.material.friction, result.parameters[0].best, 1e-3);
    EXPECT_NEAR(next.material.modulus, result.parameters[1].best, 1e-3 * result.parameters[1].best);
}

} // namespace
} // namespace suffuse::job
