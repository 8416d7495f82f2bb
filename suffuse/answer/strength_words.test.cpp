#include "suffuse/answer/strength_words.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/record/result_json.hpp"
#include "suffuse/study/strength_change.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <list>

namespace suffuse::answer {
namespace {

using nlohmann::json;

/// A study whose samples are compressed as they are, and after an erosion: initial, erosion, before, after.
struct ErodedStudy {
    casefile::Study study;
    std::list<casefile::Variant> variants; ///< stages are known by their address
    std::vector<record::FinishedStage> stages;

    static json state(double void_ratio, double pressure = 100e3) {
        return {
            {"void_ratio", void_ratio},
            {"mean_stress", pressure},
            {"stress", Mat3(diagonal({pressure, pressure, pressure}))},
            {"flaws", json::array()}};
    }

    static json test(double peak, double peak_strain = 0.02) {
        json numbers = state(0.8);
        numbers["response"] = {
            {"peak_deviator", peak},
            {"peak_strain", peak_strain},
            {"final_deviator", 0.8 * peak},
            {"friction_angle", radians(peak / 10e3)},
            {"lost_at", nullptr}};
        return numbers;
    }

    record::FinishedStage& at(int row) { return stages[stages.size() - 4 + static_cast<std::size_t>(row)]; }

    void add_sample(double before, double after) {
        casefile::Variant& variant = variants.emplace_back();
        variant.folder = study.name;
        variant.seed = variants.size();
        const triaxial::TriaxialSpec compression{.strain = 0.1};
        variant.stages = {
            {.name = "initial", .spec = packing::CompactSpec{}},
            {.name = "erosion", .spec = erosion::ErodeSpec{}, .parent = 0},
            {.name = "before", .spec = compression, .parent = 0},
            {.name = "after", .spec = compression, .parent = 1}};
        json eroded = state(0.9);
        eroded["eroded_share_of_solids"] = 0.12;
        const std::vector<json> numbers = {state(0.7), eroded, test(before), test(after)};
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            stages.push_back({&study, &variant, &variant.stages[k], numbers[k], {}});
        }
    }
};

TEST(StrengthChange, IsThatOfTheSameTestOnTheSameSample) {
    ErodedStudy study;
    study.add_sample(400e3, 300e3);
    const std::vector<study::StrengthChange> changes = study::compare_strength(study.stages);
    ASSERT_EQ(changes.size(), 1U);
    const study::StrengthChange& change = changes.front();
    EXPECT_EQ(change.before->name + ", " + change.after->name, "before, after");
    EXPECT_DOUBLE_EQ(change.peak_deviator.change.mean, -0.25);
    EXPECT_DOUBLE_EQ(change.final_deviator.before.mean, 320e3);
    EXPECT_NEAR(degrees(change.friction_angle.change.mean), -10, 1e-9); // rounding
    EXPECT_DOUBLE_EQ(change.void_ratio.before.mean, 0.7);
    EXPECT_DOUBLE_EQ(change.void_ratio.after.mean, 0.9);
    EXPECT_DOUBLE_EQ(change.removed_mass.mean, 0.12);
    EXPECT_EQ(change.is_weaker(), true);
    EXPECT_EQ(study::strength_json(changes).at(0).at("weaker"), true);
    EXPECT_EQ(
        strength_sentences(changes),
        (std::vector<std::string>{
            "Strength, “after” against “before”: the soil without 12 % of its mass is weaker. Its highest deviator "
            "stress goes from 400 to 300 kPa (−25 %), the friction angle there from 40 to 30°, the deviator stress at "
            "10 % axial strain from 320 to 240 kPa (−25 %), the void ratio from 0.7 to 0.9. Too short to reach the "
            "critical state: at 10 % axial strain volume or stress still change. One "
            "sample: the strengths of others may differ by about 10 %."})
    );
    EXPECT_EQ(strength_headline(changes).value().value, "−25 %");
    EXPECT_EQ(tabulate_strength(changes).value().rows.front().size(), tabulate_strength(changes).value().header.size());
}

TEST(StrengthChange, SaysHowOftenChanceGivesAsClearAChangeWhereThatIsMoreThanOnceInTwenty) {
    for (const double t : {12.5, 12.9}) { // of Student with one degree of freedom: 12.7 by chance in 5 %
        ErodedStudy study;
        for (const double side : {-1.0, 1.0}) {
            study.add_sample(400e3, 400e3 * (1 - 0.25 * (1 + side / t)));
        }
        const std::string reported = strength_sentences(study::compare_strength(study.stages)).front();
        EXPECT_EQ(
            reported.find("with so few samples, scatter alone gives as clear a change") != std::string::npos, t < 12.7
        ) << reported;
    }
}

/// Rises to a peak, and comes down to `residual` [Pa]; the volume changes to `strain` and stays there.
std::vector<triaxial::PathRow> long_test(double peak, double residual, double strain) {
    std::vector<triaxial::PathRow> rows;
    for (int k = 0; k <= 450; ++k) {
        triaxial::PathRow row;
        row.axial_strain = 1e-3 * k;
        row.deviator_stress = row.axial_strain < 0.05   ? peak * row.axial_strain / 0.05
                              : row.axial_strain < 0.25 ? peak + (residual - peak) * (row.axial_strain - 0.05) / 0.2
                                                        : residual;
        row.volumetric_strain = strain * std::min(1.0, row.axial_strain / 0.3);
        row.void_ratio = 0.85;
        rows.push_back(row);
    }
    return rows;
}

TEST(StrengthChange, OfLongTestsReportsPeakAStrainAndTheResidual) {
    ErodedStudy study;
    study.add_sample(400e3, 240e3);
    for (const int row : {2, 3}) {
        std::get<triaxial::TriaxialSpec>(study.variants.back().stages[static_cast<std::size_t>(row)].spec).strain =
            0.45;
    }
    study.at(2).findings.curve = long_test(400e3, 200e3, -0.09);
    study.at(3).findings.curve = long_test(240e3, 210e3, 0.03);
    study.at(2).numbers["response"]["final_volumetric_strain"] = -0.09;
    study.at(3).numbers["response"]["final_volumetric_strain"] = 0.03;
    const std::vector<study::StrengthChange> changes = study::compare_strength(study.stages);
    EXPECT_NEAR(changes.front().deviator_at_strain.before.mean, 350e3, 1);
    EXPECT_EQ(tabulate_strength(changes).value().header.size(), 12U); // the critical state and a change among them
    EXPECT_NEAR(changes.front().residual_deviator.change.mean, 0.05, 1e-9);
    EXPECT_TRUE(changes.front().remarks.empty());
    const std::string reported = strength_sentences(changes).front();
    EXPECT_NE(
        reported.find("the deviator stress at 10 % axial strain from 350 to 232.5 kPa (−34 %), and the critical-state "
                      "strength, near 45 %, from 200 to 210 kPa (+5 %)"),
        std::string::npos
    ) << reported;
    EXPECT_NE(reported.find("the sample dilates by 9 % before and contracts by 3 % after"), std::string::npos)
        << reported;
}

TEST(StrengthChange, OfOneSampleWithinATenthIsNone) {
    ErodedStudy study;
    study.add_sample(400e3, 370e3);
    EXPECT_EQ(study::compare_strength(study.stages).front().is_weaker(), std::nullopt);
    study = {};
    study.add_sample(300e3, 400e3);
    EXPECT_EQ(study::compare_strength(study.stages).front().is_weaker(), false);
    EXPECT_NE(
        strength_sentences(study::compare_strength(study.stages)).front().find("is not weaker but stronger"),
        std::string::npos
    );
}

TEST(StrengthChange, OfSeveralSamplesIsJudgedByTheirScatter) {
    ErodedStudy study;
    study.add_sample(400e3, 380e3); // -5 %
    study.add_sample(400e3, 372e3); // -7 %
    EXPECT_EQ(study::compare_strength(study.stages).front().is_weaker(), true);
    const Headline headline = strength_headline(study::compare_strength(study.stages)).value();
    EXPECT_EQ(headline.value, "−6.0 %");
    EXPECT_EQ(headline.spread, "± 1.4"); // sqrt(2), with the digits of the mean
    const auto reported = [&] { return strength_sentences(study::compare_strength(study.stages)).front(); };
    // Student's t is 6: with one degree of freedom it is exceeded in 1 - 2 atan(6)/pi of all cases.
    EXPECT_TRUE(reported().ends_with("with so few samples, scatter alone gives as clear a change in 11 % of the cases.")
    ) << reported();
    study.add_sample(400e3, 440e3);
    EXPECT_EQ(study::compare_strength(study.stages).front().is_weaker(), std::nullopt);
    EXPECT_TRUE(reported().ends_with("Means of 3 samples, ± one standard deviation.")) << reported();
}

TEST(StrengthChange, LeavesOutTestsThatAreNoneAndSaysSo) {
    ErodedStudy study;
    study.add_sample(400e3, 300e3);
    study.at(3).numbers["response"]["lost_at"] = 0.011;
    const std::vector<study::StrengthChange> lost = study::compare_strength(study.stages);
    EXPECT_EQ(lost.front().peak_deviator.change.seeds, 0);
    EXPECT_EQ(
        lost.front().remarks, std::vector<std::string>{"not compared, for after collapsed at 1.1 % axial strain"}
    );
    EXPECT_TRUE(study::strength_json(lost).at(0).at("peak_deviator").is_null());
    EXPECT_FALSE(strength_headline(lost).has_value());
    EXPECT_EQ(
        strength_sentences(lost).front(),
        "Strength, “after” against “before”: the soil without 12 % of its mass cannot be compared; the void ratio goes "
        "from 0.7 to 0.9. Not compared, for after collapsed at 1.1 % axial strain."
    );
    study.at(3).numbers["response"]["lost_at"] = nullptr;
    study.at(1).numbers.update(ErodedStudy::state(0.9, 80e3)); // its stresses did not come back
    EXPECT_EQ(
        study::compare_strength(study.stages).front().remarks,
        std::vector<std::string>{"not compared, for after starts from 80 kPa, not from 100 kPa"}
    );
}

/// A study whose sample is compressed as it is, and after it has gone through `between` and an erosion.
ErodedStudy eroded_after(casefile::StageSpec between, const json& state) {
    ErodedStudy study;
    study.add_sample(400e3, 300e3);
    casefile::Variant& variant = study.variants.back();
    variant.stages[1].parent = 4;
    variant.stages.push_back({.name = "between", .spec = std::move(between), .parent = 0});
    for (std::size_t k = 0; k < variant.stages.size() - 1; ++k) { // they have moved
        study.stages[k].stage = &variant.stages[k];
    }
    study.stages.push_back({&study.study, &variant, &variant.stages.back(), state, {}});
    return study;
}

TEST(StrengthChange, IsNotThatOfAnotherStressThatWasReachedBeforeTheErosion) {
    ErodedStudy study = eroded_after(dem::SettleSpec{}, ErodedStudy::state(0.72, 50e3));
    study.stages[1].numbers.update(ErodedStudy::state(0.9, 50e3));
    EXPECT_EQ(
        study::compare_strength(study.stages).at(0).remarks,
        std::vector<std::string>{"not compared, for after starts from 50 kPa, not from 100 kPa"}
    );
}

TEST(StrengthChange, IsOfNoPairWhereTheSampleWasExtendedBefore) {
    for (const auto direction : {triaxial::Direction::Compression, triaxial::Direction::Extension}) {
        triaxial::TriaxialSpec part{.deviator_stress = 30e3};
        part.direction = direction;
        const ErodedStudy study = eroded_after(part, ErodedStudy::state(0.72));
        EXPECT_EQ(study::compare_strength(study.stages).empty(), direction == triaxial::Direction::Extension);
    }
}

TEST(StrengthChange, RemarksOnWhatItsTestsDoNotShow) {
    ErodedStudy study;
    study.add_sample(400e3, 300e3);
    study.at(2).numbers = ErodedStudy::test(400e3, 0.0999); // still rising
    study.at(3).numbers["flaws"] = {"an overlap"};
    study.at(3).numbers["response"]["liquefied"] = true;
    EXPECT_EQ(
        study::compare_strength(study.stages).front().remarks,
        (std::vector<std::string>{
            "too short to reach the critical state: at 10 % axial strain volume or "
            "stress still change",
            "before is highest at its end, and may rise further", "after liquefied", "after has a flaw (warnings)"})
    );
}

/// Tests that hold the deviator stress, and what they bear.
ErodedStudy pore_pressure_study(const std::vector<std::pair<double, double>>& borne) {
    ErodedStudy study;
    for (const auto& [before, after] : borne) {
        study.add_sample(75e3, 75e3);
        for (const int row : {2, 3}) {
            std::get<triaxial::TriaxialSpec>(study.variants.back().stages[static_cast<std::size_t>(row)].spec).path =
                triaxial::Path::ConstantDeviator;
            study.at(row).numbers["response"]["excess_pore_pressure"] = row == 2 ? before : after;
        }
    }
    return study;
}

TEST(StrengthChange, WhereTheDeviatorStressIsHeldIsThatOfThePorePressureBorne) {
    const ErodedStudy study = pore_pressure_study({{40e3, 20e3}, {50e3, 15e3}});
    const std::vector<study::StrengthChange> changes = study::compare_strength(study.stages);
    ASSERT_EQ(changes.size(), 1U);
    EXPECT_DOUBLE_EQ(changes.front().pore_pressure.change.mean, -0.6); // of -50 % and -70 %
    EXPECT_EQ(changes.front().peak_deviator.change.seeds, 0);
    EXPECT_EQ(changes.front().is_weaker(), true);
    EXPECT_EQ(
        strength_sentences(changes).front(),
        "Strength, “after” against “before”: the soil without 12 % of its mass is weaker. With the deviator stress "
        "held, "
        "the excess pore pressure that it bears goes from 45 to 17.5 kPa (−60 ± 14 %), the void ratio from 0.7 to 0.9. "
        "Means of 2 samples, ± one standard deviation; with so few samples, scatter alone gives as clear a change in "
        "11 % of the "
        "cases."
    );
    EXPECT_EQ(strength_headline(changes).value().label, "Pore pressure borne");
    const figures::PageTable table = tabulate_strength(changes).value();
    EXPECT_EQ(table.header[4], "excess pore pressure borne [kPa]");
    EXPECT_EQ(table.rows.front()[4], "45 → 17.5");
    EXPECT_EQ(table.header.back(), "change [%]"); // remarks on so few stand in their sentences
    EXPECT_EQ(table.rows.front().size(), table.header.size());
    EXPECT_EQ(study::strength_json(changes).at(0).at("excess_pore_pressure").at("change").at("mean"), -0.6);
    EXPECT_TRUE(study::strength_json(changes).at(0).at("peak_deviator").is_null());
}

TEST(StrengthChange, OfThePorePressureThatOneSampleBearsIsOneBeyondHalf) {
    EXPECT_EQ(study::compare_strength(pore_pressure_study({{40e3, 24e3}}).stages).front().is_weaker(), std::nullopt);
    EXPECT_EQ(study::compare_strength(pore_pressure_study({{40e3, 16e3}}).stages).front().is_weaker(), true);
}

TEST(StrengthChange, WhereTheDeviatorStressIsHeldNeedsTheSameOne) {
    ErodedStudy study = pore_pressure_study({{40e3, 20e3}});
    study.at(0).numbers["stress"] = Mat3(diagonal({75e3, 75e3, 150e3}));
    EXPECT_EQ(
        study::compare_strength(study.stages).front().remarks,
        std::vector<std::string>{"not compared, for after holds a deviator stress of 0 kPa, not of 75 kPa"}
    );
}

TEST(StrengthChange, OfManyTestsOfBothKindsHasATableAndRangesOfBoth) {
    ErodedStudy study = pore_pressure_study({{40e3, 20e3}});
    std::list<ErodedStudy> others(3);
    std::vector<record::FinishedStage> stages = study.stages;
    for (ErodedStudy& other : others) {
        other.study.name = fmt::format("s{}", stages.size());
        other.add_sample(400e3, 300e3);
        stages.insert(stages.end(), other.stages.begin(), other.stages.end());
    }
    const std::vector<study::StrengthChange> changes = study::compare_strength(stages);
    ASSERT_EQ(changes.size(), 4U);
    EXPECT_NE(
        strength_sentences(changes).front().find(
            "; the highest deviator stress changes by −25 to −25 %; the excess pore "
            "pressure borne changes by −50 to −50 %."
        ),
        std::string::npos
    );
    const figures::PageTable table = tabulate_strength(changes).value();
    EXPECT_EQ(table.header.size(), 13U); // nothing of the critical state, which none reaches
    EXPECT_EQ(table.header.back(), "remarks");
    for (const std::vector<std::string>& row : table.rows) {
        EXPECT_EQ(row.size(), table.header.size());
    }
}

TEST(StrengthChange, NeedsTheSameTestAndAnErosionBetween) {
    ErodedStudy study;
    study.add_sample(400e3, 300e3);
    auto& after = std::get<triaxial::TriaxialSpec>(study.variants.front().stages[3].spec);
    after.path = triaxial::Path::Undrained;
    EXPECT_TRUE(study::compare_strength(study.stages).empty());
    after.path = triaxial::Path::Drained;
    after.inertia = triaxial::GrainInertia::Own;
    EXPECT_TRUE(study::compare_strength(study.stages).empty());
    after.inertia = triaxial::GrainInertia::Lent;
    after.time_step = 1e-8;
    EXPECT_TRUE(study::compare_strength(study.stages).empty());
    after.time_step = 0;
    after.stress_ratio = 0.75; // leads to a state, and is no test of strength
    EXPECT_TRUE(study::compare_strength(study.stages).empty());
    after.stress_ratio.reset();
    after.inertia = triaxial::GrainInertia::Own;
    EXPECT_TRUE(study::compare_strength(study.stages).empty());
    after.inertia = triaxial::GrainInertia::Lent;
    EXPECT_EQ(study::compare_strength(study.stages).size(), 1U);
    study.variants.front().stages[1].spec = dem::SettleSpec{};
    EXPECT_TRUE(study::compare_strength(study.stages).empty());
}

TEST(StrengthChange, OfADeviatoricStateIsThatOfATestThatPassesThroughIt) {
    ErodedStudy study;
    study.add_sample(400e3, 300e3);
    auto& stages = study.variants.front().stages;
    stages[1].spec = triaxial::TriaxialSpec{.stress_ratio = 0.75};
    stages.push_back({.name = "removed", .spec = erosion::RemoveSpec{}, .parent = 1});
    stages[3].parent = 4;
    // The vector has moved its stages.
    for (std::size_t k = 0; k < 4; ++k) {
        study.stages[k].stage = &stages[k];
    }
    json removed = ErodedStudy::state(0.95);
    removed["removed_mass_share"] = 0.2;
    study.stages.push_back({&study.study, &study.variants.front(), &stages[4], removed, {}});
    const std::vector<study::StrengthChange> changes = study::compare_strength(study.stages);
    ASSERT_EQ(changes.size(), 1U);
    EXPECT_DOUBLE_EQ(changes.front().void_ratio.before.mean, 0.9); // that of the deviatoric state
    EXPECT_DOUBLE_EQ(changes.front().removed_mass.mean, 0.2);
    stages[1].spec = triaxial::TriaxialSpec{.strain = 0.1}; // past its peak, perhaps: its softening is no erosion's
    EXPECT_TRUE(study::compare_strength(study.stages).empty());
}

} // namespace
} // namespace suffuse::answer
