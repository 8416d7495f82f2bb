#include "suffuse/figures/figures.hpp"

#include <gtest/gtest.h>

#include "tests/support/sample_results.hpp"

namespace suffuse::figures {
namespace {

using erosion::ErosionResult;

TEST(ErosionFigures, NameTheGradientsOfAllPasses) {
    ErosionResult erosion = test::sample_erosion();
    erosion.passes.front().probe.gradient = 0.1, erosion.passes.back().probe.gradient = 1;
    EXPECT_EQ(speed_by_pass(erosion)->title, "Speed of the fines in each erosion pass, i = 0.1 to 1");
    EXPECT_NE(erosion_loop(erosion)->drawing.find("hydraulic gradient i = 0.1 to 1"), std::string::npos);
}

TEST(ErosionFigures, OfFinesTakenOutByForceDoNotSayThatWaterCarriedThem) {
    ErosionResult erosion = test::sample_erosion();
    for (erosion::LedgerRow& row : erosion.ledger) {
        row.reason = erosion::Reason::Forced;
    }
    EXPECT_EQ(eroded_mass(erosion)->claim, "2 passes took out 15 % of the mass");
    EXPECT_EQ(erosion_loop(erosion)->drawing.find("hydraulic gradient"), std::string::npos);
}

TEST(ErosionFigures, APermeabilityNamesItsSolverAndNoLossOfNothing) {
    ErosionResult erosion = test::sample_erosion();
    erosion.passes.resize(1);
    erosion::PassResult& pass = erosion.passes.front();
    pass.eroded_mass_percent_of_initial = 0;
    pass.permeability_before = 1e-10, pass.permeability_after = 1.006e-10;
    EXPECT_EQ(permeability_by_pass(erosion)->claim, "The permeability rises by 0.6 %");
    EXPECT_EQ(
        permeability_by_pass(erosion)->caption,
        "No grain left: the permeability along the flow goes from 1·10⁻¹⁰ to 1.01·10⁻¹⁰ m². By the pore network."
    );
    pass.permeability_after = 0.5e-10;
    EXPECT_EQ(permeability_by_pass(erosion)->claim, "The permeability falls to 50 % of its initial value");
    pass.flow_after.solver = flow::Solver::Resolved;
    EXPECT_NE(permeability_by_pass(erosion)->caption.find("1 of 2 states are by the flow between"), std::string::npos);
    pass.probe.flow.solver = flow::Solver::Resolved;
    EXPECT_EQ(permeability_by_pass(erosion)->caption.find("network"), std::string::npos);
}

TEST(ErosionFigures, AMeanStressThatRisesIsNoCost) {
    ErosionResult erosion = test::sample_erosion();
    for (erosion::PassResult& pass : erosion.passes) {
        pass.stress_constant_volume = 1.03 * pass.stress_before;
    }
    EXPECT_EQ(stress_path(erosion)->claim, "No pass costs mean stress at constant volume");
}

} // namespace
} // namespace suffuse::figures
