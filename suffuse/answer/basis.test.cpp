#include "suffuse/answer/basis.hpp"

#include "suffuse/atlas/rows_for_tests.hpp"
#include "suffuse/grains/surrogate.hpp"

#include <gtest/gtest.h>

namespace suffuse::answer {
namespace {

using study::MobilityStory;

std::string first_doubt(const MobilityStory& story) {
    const std::vector<std::string> doubts = doubts_about(story);
    return doubts.empty() ? "none" : doubts.front();
}

/// One sample of 1,000 grains, 700 of them fine, under upward flow.
class Basis : public testing::Test {
protected:
    Basis() {
        study_.name = "dam", study_.particles = 1000;
        mobility_.down = {0, 0, -1}, mobility_.direction = {0, 0, 1};
        mobility_.ramp = {{.gradient = 0.2, .mobile_mass_share = 0.002}, {.gradient = 1.2, .mobile_mass_share = 0.2}};
        mobility_.moves_1 = 0.3, mobility_.heave_gradient = 1.3, mobility_.skempton_brogan_gradient = 0.15;
        mobility_.single_grain_gradient = 0.25;
        mobility_.id.resize(700), mobility_.mass.resize(700), mobility_.diameter.resize(700);
        variant_.soil.emplace();
        variant_.soil->whole = grains::Grading{{1e-4, 1e-3}, {0, 1}, ""};
    }

    /// @param width of the cell in largest grains @param q deviator stress at 100 kPa [Pa]
    MobilityStory story(double width, double q) {
        const double edge = 1e-3 * width;
        const nlohmann::json numbers = {
            {"grains", 1000},
            {"cell", {{edge, 0, 0}, {0, edge, 0}, {0, 0, edge}}},
            {"mean_stress", 100e3},
            {"deviator_stress", q}};
        stages_ = {{&study_, &variant_, &stage_, numbers, {}}};
        stages_.front().findings.mobility = mobility_;
        return study::gather_mobility(stages_).front();
    }

    casefile::Study study_;
    casefile::Variant variant_;
    casefile::Stage stage_{.name = "up", .spec = erosion::DetachStageSpec{}};
    erosion::MobilityResult mobility_;
    std::vector<record::FinishedStage> stages_;
};

TEST_F(Basis, NamesEveryEstimateOfTheGradientAndTheirRangeOverTheSpecifiedOne) {
    EXPECT_EQ(
        estimates_of(story(20, 0)),
        "Upward flow moves 1 % of the fines at estimated gradients of 0.15 (α i_c, Skempton and Brogan), 0.27 (lift of "
        "single grains), 0.30 (simulated)."
    );
    mobility_.specified_gradient = 0.1;
    EXPECT_NE(
        estimates_of(story(20, 0)).find("Over the specified 0.1: 1.5 (α i_c, Skempton and Brogan) to 3.0 (simulated)."),
        std::string::npos
    ) << estimates_of(story(20, 0));
}

TEST_F(Basis, DoubtsThatFewMoveWhereTheLastLevelWasStillMoving) {
    study_.particles = 20'000;
    mobility_.ramp = {{.gradient = 0.2, .mobile_mass_share = 0.002}, {.gradient = 1.4, .mobile_mass_share = 0.2}};
    mobility_.moves_1.reset();
    const std::string ended = first_doubt(story(20, 0));
    mobility_.ramp.front().still_moving = 0.01;
    EXPECT_EQ(
        first_doubt(story(20, 0)),
        "Fines were still moving when the gradient rose, so that 1 % of them may move below the last gradient. To hold "
        "longer: `--set study.dam.stage.up.hold_at_most=400`."
    );
    EXPECT_EQ(ended.find("still moving"), std::string::npos) << ended;
}

TEST_F(Basis, ASurrogatesEstimatesNameItsSizeRatio) {
    const grains::Grading gravel{{0.005e-3, 0.08e-3, 1e-3, 4e-3}, {0, 0.2, 0.2, 1}, ""};
    variant_.soil = grains::surrogate_of(gravel, {.finer_than = 0.3e-3, .size_ratio = 10});
    const std::string text = estimates_of(story(20, 0), {});
    EXPECT_EQ(text.find("Upward flow at a size ratio of 10 moves 1 % of the fines at estimated gradients of "), 0U)
        << text;
}

TEST_F(Basis, UnderLevelFlowNothingIsLiftedAndTheVerdictHasTheOnlyEstimate) {
    mobility_.direction = {1, 0, 0};
    mobility_.heave_gradient.reset(), mobility_.skempton_brogan_gradient.reset();
    EXPECT_EQ(estimates_of(story(20, 0)), "");
}

TEST_F(Basis, ASoilWithinTheAtlasHasAnEstimateOfEachOfItsDensities) {
    variant_.soil->whole =
        grains::Grading{{1e-4, 2e-4, 5e-4, 1e-3}, {0, 0.2, 0.2, 1}, ""}; // medians a factor of 5 apart
    variant_.soil->finer_than = 2e-4;
    atlas::Row loose = atlas::test::row_at(5, 0.2, 0.2), dense = atlas::test::row_at(5, 0.2, 0.25);
    dense.density = atlas::Density::Dense, dense.moves_1.is_at_most = true;
    variant_.material.density = 2650;
    const std::string text = estimates_of(story(20, 0), {loose, dense});
    EXPECT_NE(text.find("0.20 (atlas, loose), 0.25 "), std::string::npos) << text;
    EXPECT_NE(text.find("(atlas, dense, at most), 0.30 (simulated)."), std::string::npos) << text;
    EXPECT_EQ(estimates_of(story(20, 0), {}).find("atlas"), std::string::npos);
    mobility_.direction = {1, 0, 0};
    EXPECT_EQ(estimates_of(story(20, 0), {loose, dense}).find("atlas"), std::string::npos) << "it has no level flow";
}

TEST_F(Basis, AWideRestedWholeSampleWhoseMotionEndedLeavesNoDoubt) {
    EXPECT_TRUE(doubts_about(story(20, 0)).empty());
}

TEST_F(Basis, EachDoubtSaysWhatWouldRemoveIt) {
    const std::vector<std::string> narrow = doubts_about(story(5, 0));
    ASSERT_EQ(narrow.size(), 1U);
    EXPECT_EQ(
        narrow.front(), "The cell is 5 largest grains wide and has 300 coarse grains. To have 10: `--set "
                        "study.dam.particles=8000`."
    );
    EXPECT_NE(first_doubt(story(20, 34e3)).find("q = 34 kPa at p = 100 kPa"), std::string::npos);
    mobility_.ramp.back().still_moving = 0.1;
    EXPECT_NE(first_doubt(story(20, 0)).find("study.dam.stage.up.hold_at_most=400"), std::string::npos);
    mobility_.ramp.back().still_moving = 0;
    variant_.soil->measured = grains::Grading{{1e-5, 1e-4, 1e-3, 2e-3}, {0, 0.2, 0.8, 1}, ""};
    EXPECT_NE(first_doubt(story(20, 0)).find("Only 60 % of the mass is modeled"), std::string::npos);
}

TEST_F(Basis, ALargerSampleIsLargerThanTheOneThatIsThere) {
    mobility_.id.resize(950), mobility_.mass.resize(950), mobility_.diameter.resize(950);
    EXPECT_EQ(
        first_doubt(story(20, 0)), "The cell is 20 largest grains wide and has 50 coarse grains. To have 200: `--set "
                                   "study.dam.particles=4000`."
    );
    EXPECT_NE(
        first_doubt(story(5, 0)).find("To have 10 and 200: `--set study.dam.particles=8000`."), std::string::npos
    );
    study_.particles = 0, study_.sample_size.emplace().at_least = 2000;
    EXPECT_NE(first_doubt(story(20, 0)).find("study.dam.sample_size.at_least=8000"), std::string::npos);
}

TEST_F(Basis, CountsTheCoarseGrainsOfTheSampleBeforeItsErosion) {
    const std::string before = first_doubt(story(5, 0));
    study::MobilityStory eroded = story(5, 0);
    stages_.front().numbers["grains"] = 400;
    stages_.front().numbers["passes"] = {{{"removed", 350}}, {{"removed", 250}}};
    EXPECT_EQ(first_doubt(eroded), before);
}

TEST_F(Basis, ShearStressThatACompactionLeftIsReleasedByAKey) {
    variant_.stages = {{.name = "initial", .spec = packing::CompactSpec{.pressure = 100e3}}, stage_};
    stage_.parent = 0;
    EXPECT_NE(
        first_doubt(story(20, 34e3)).find("--set study.dam.stage.initial.shear_stresses=released"), std::string::npos
    );
    std::get<packing::CompactSpec>(variant_.stages.front().spec).shear_released = true;
    EXPECT_NE(first_doubt(story(20, 34e3)).find("a larger sample has less"), std::string::npos) << "it is already";
}

TEST_F(Basis, TheLargestDoubtComesFirst) {
    variant_.soil->measured = grains::Grading{{1e-5, 1e-4, 1e-3}, {0, 0.06, 1}, ""};
    const std::vector<std::string> doubts = doubts_about(story(2, 15e3));
    ASSERT_EQ(doubts.size(), 3U);
    EXPECT_NE(doubts[0].find("The cell is 2 largest grains wide"), std::string::npos);
    EXPECT_NE(doubts[1].find("shear stress"), std::string::npos);
    EXPECT_NE(doubts[2].find("of the mass is modeled"), std::string::npos);
}

TEST_F(Basis, ASurrogateIsADoubtOfItsOwn) {
    const grains::Grading curve{{0.1e-3, 0.4e-3, 1e-3, 4e-3}, {0, 0.2, 0.2, 1}, ""};
    variant_.soil = grains::surrogate_of(curve, {.finer_than = 0.5e-3, .size_ratio = 4});
    EXPECT_NE(first_doubt(story(30, 0)).find("Two fractions"), std::string::npos);
}

} // namespace
} // namespace suffuse::answer
