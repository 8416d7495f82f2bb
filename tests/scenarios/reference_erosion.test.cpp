// The paper's procedure on the reference's packings, through a case, against what the reference found with the same
// protocol.

#include <gtest/gtest.h>

#include "tests/support/run_text.hpp"
#include <fstream>

namespace suffuse::test {
namespace {

using nlohmann::json;

/// Behind the constants, whose last table is [fluid].
const std::string yades_law = "conductance = \"yade\"\n";

TEST(ReferenceErosion, TenThousandGrainsLoseTheirRattlersInTheFirstPass) {
    const TempFolder folder;
    run_text(
        reference_constants + yades_law + reference_soil() + study_of_packing("packing10k") + R"(
[[study.s.stage]]
name      = "erosion"
do        = "erode"
passes    = 1
gradient  = 0.05
direction = "-x"
)",
        folder.path()
    );
    const json settled = stage_of(folder.path(), "settled");
    const json pass = stage_of(folder.path(), "erosion").at("passes").at(0);
    // An imported packing carries no contact memory: settling it anew moves a few grains in or out of the force
    // network, hence two percent and not less.
    const auto within_two_percent = [](double ours, double theirs) { EXPECT_NEAR(ours / theirs, 1, 0.02); };
    within_two_percent(settled.at("porosity"), 0.40219);
    within_two_percent(settled.at("rattlers"), 2790);
    within_two_percent(pass.at("removed"), 2778);
    within_two_percent(pass.at("eroded_mass_percent"), 13.47);
    within_two_percent(pass.at("porosity_before"), 0.40219);
    within_two_percent(pass.at("porosity_after"), 0.48272);
    within_two_percent(pass.at("permeability_before"), 5.36e-11);
    within_two_percent(pass.at("permeability_after"), 1.66e-10);
    // The reference's 0.448 mm is that of circles, whatever they reach into (pores/constrictions.test.cpp compares
    // them).
    within_two_percent(pass.at("constriction_mean"), 0.404e-3);
    const json& merged = pass.at("constrictions_by_merge");
    EXPECT_EQ(merged.at("none").at("mean"), pass.at("constriction_mean"));
    EXPECT_EQ(merged.at("none").at("count"), pass.at("constrictions"));
    EXPECT_LT(merged.at("center").at("mean"), 0.8 * merged.at("none").at("mean").get<double>());
    EXPECT_LT(merged.at("overlap").at("count"), 0.01 * merged.at("none").at("count").get<double>()); // nearly one void
    // Rattlers carry nothing: their loss changes neither stress nor volume.
    const double p_before = pass.at("stress_before").at(0).at(0),
                 p_still = pass.at("stress_constant_volume").at(0).at(0);
    EXPECT_NEAR(p_still / p_before, 1, 1e-4);
    EXPECT_LT(std::abs(pass.at("volumetric_strain").get<double>()), 1e-5);
    EXPECT_LE(pass.at("probe").at("unbalanced_force"), 1e-8);
    EXPECT_NE(
        stage_of(folder.path(), "erosion").at("warnings").dump().find("after pass 1 is 0.517: below 0.55"),
        std::string::npos
    );
}

TEST(OpenPackings, AreWarnedOfWhereTheirPermeabilityIsRequested) {
    const std::string flow = "[[study.s.stage]]\nname = \"flow\"\ndo = \"flow\"\ngradient = 0.05\n";
    const auto warnings = [&](const std::string& study) {
        const TempFolder folder;
        run_text(reference_constants + study + flow, folder.path());
        return stage_of(folder.path(), "flow").at("warnings").dump();
    };
    const std::string cloud = mixed_soil +
                              "[study.s]\nsoil = \"mixture\"\nparticles = 200\n[[study.s.stage]]\nname = \"cloud\"\n"
                              "do = \"pack\"\nporosity = 0.5\n";
    const std::string open = warnings(yades_law + cloud);
    EXPECT_NE(open.find("the solid fraction of the sample is 0.500"), std::string::npos) << open;
    EXPECT_NE(open.find("too high by 40 % and more"), std::string::npos) << open;
    const std::string dense = reference_soil() + study_of_packing("packing500");
    EXPECT_EQ(warnings(yades_law + dense).find("solid fraction"), std::string::npos);
    EXPECT_EQ(warnings(cloud).find("solid fraction"), std::string::npos); // bounded drag is for them too
}

TEST(ClosedVoids, AreWarnedOfWhereWaterFlowsByTheGrainsThatOverlap) {
    const TempFolder folder;
    std::ofstream(folder.path() / "two.csv")
        << "x,y,z,r\n1e-3,1e-3,1e-3,1e-3\n1.1e-3,1e-3,1e-3,1e-3\n3e-3,3e-3,3e-3,1e-3\n";
    run_text(
        reference_constants + reference_soil() + R"(
[study.s]
soil = "sand"
[[study.s.stage]]
name        = "start"
do          = "import"
packing     = ")" +
            (folder.path() / "two.csv").string() +
            R"("
cell        = ["4.4 mm", "4.4 mm", "4.4 mm"]
max_overlap = 2
[[study.s.stage]]
name      = "flow"
do        = "flow"
gradient  = 0.05
direction = [0, 0, 1e200]
)",
        folder.path()
    );
    const json flow = stage_of(folder.path(), "flow");
    EXPECT_NE(flow.at("warnings").dump().find("counts negative voids"), std::string::npos) << flow.at("warnings");
    EXPECT_GT(flow.at("permeability"), 0);
}

TEST(FastWater, IsWarnedOfWhereItsInertiaWouldCount) {
    const auto flow_at = [](const std::string& gradient) {
        const TempFolder folder;
        run_text(
            reference_constants + reference_soil() + study_of_packing("packing500") +
                "[[study.s.stage]]\nname = \"flow\"\ndo = \"flow\"\ngradient = " + gradient + "\n",
            folder.path()
        );
        return stage_of(folder.path(), "flow");
    };
    const json slow = flow_at("0.5"), fast = flow_at("500");
    EXPECT_NEAR(slow.at("reynolds_number"), 0.001 * fast.at("reynolds_number").get<double>(), 1e-12); // rounding
    EXPECT_LT(slow.at("reynolds_number"), 1);
    EXPECT_EQ(slow.at("warnings").dump().find("inertia"), std::string::npos);
    EXPECT_NE(fast.at("warnings").dump().find("its inertia, which slow flow neglects"), std::string::npos);
}

TEST(ReferenceErosion, ForcedRemovalUnderADeviatorLosesStressContractsAndFallsInPorosity) {
    const TempFolder folder;
    run_text(
        reference_constants + reference_soil() + study_of_packing("packing2000") + R"(
[[study.s.stage]]
name            = "deviatoric"
do              = "triaxial"
deviator_stress = "100 kPa"
strain          = "5 %"
[[study.s.stage]]
name      = "erosion"
do        = "erode"
passes    = 1
gradient  = 0.05
direction = "-x"
[[study.s.stage]]
name      = "forced"
do        = "erode"
passes    = 1
gradient  = 0.05
direction = "-x"
forced    = { max_contacts = 3 }
)",
        folder.path()
    );
    const json deviatoric = stage_of(folder.path(), "deviatoric");
    EXPECT_NEAR(deviatoric.at("stress").at(2).at(2), 200e3, 1e3);
    EXPECT_NEAR(deviatoric.at("stress").at(0).at(0), 100e3, 1e3);
    const json pass = stage_of(folder.path(), "forced").at("passes").at(0);
    const auto axial = [&](const char* when) { return pass.at(when).at(2).at(2).get<double>(); };
    // The reference removed 319 of 1,428 grains, 11.3 % of the mass; stress fell at once and went on falling, the
    // sample contracted under the servo and its porosity fell again.
    EXPECT_NEAR(pass.at("removed"), 319, 60);
    EXPECT_NEAR(pass.at("eroded_mass_percent_of_initial"), 11.3, 2.5);
    EXPECT_LT(axial("stress_after_removal"), 0.95 * axial("stress_before"));
    EXPECT_LT(axial("stress_constant_volume"), 0.9 * axial("stress_after_removal"));
    EXPECT_GT(pass.at("volumetric_strain"), 1e-3);
    EXPECT_LT(pass.at("porosity_after"), pass.at("porosity_after_removal"));
    EXPECT_NEAR(axial("stress_after") / 200e3, 1, 0.01);
}

} // namespace
} // namespace suffuse::test
