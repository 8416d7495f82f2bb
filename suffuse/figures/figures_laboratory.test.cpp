// Figures of a laboratory from stages made by hand: elastic bodies, of which each number is known.

#include "suffuse/figures/figures_laboratory.hpp"

#include "suffuse/figures/figures_stiffness.hpp"

#include <gtest/gtest.h>

#include <deque>

namespace suffuse::figures {
namespace {

/// Stages that live as long as the figures drawn of them.
struct Laboratory {
    std::deque<casefile::Stage> stages;
    std::deque<record::FinishedStage> finished;

    record::FinishedStage& add(const casefile::StageSpec& spec) {
        stages.emplace_back().spec = spec;
        finished.emplace_back().stage = &stages.back();
        return finished.back();
    }
};

constexpr double shear_modulus = 40e6, confining = 1e5; // [Pa]

/// Of an elastic body whose lateral stress is held and that starts under a deviator stress of its own.
triaxial::PathRow elastic_row(double axial, double volumetric) {
    triaxial::PathRow row;
    row.axial_strain = axial;
    row.volumetric_strain = volumetric;
    row.deviator_stress = 2e3 + 2 * shear_modulus * (axial - 0.5 * (volumetric - axial));
    row.stress = diagonal({confining, confining, confining + row.deviator_stress});
    return row;
}

TEST(LaboratoryFigures, TheSecantOfAnElasticTestIsItsShearModulusAtEachStrain) {
    Laboratory laboratory;
    record::FinishedStage& stiff = laboratory.add(triaxial::StiffnessSpec{});
    stiff.numbers = {{"shear_modulus", shear_modulus}};
    record::FinishedStage& triaxial = laboratory.add(triaxial::TriaxialSpec{});
    triaxial.findings.curve = {elastic_row(0, 0), elastic_row(1e-3, 4e-4), elastic_row(2e-3, 8e-4)};
    triaxial::TriaxialSpec downward;
    downward.direction = triaxial::Direction::Extension;
    record::FinishedStage& extension = laboratory.add(downward);
    extension.findings.curve = {elastic_row(0, 0), elastic_row(-1e-3, -4e-4)};
    record::FinishedStage& shear = laboratory.add(triaxial::ShearSpec{});
    triaxial::PathRow slid;
    slid.shear_strain = 5e-3;
    slid.stress(0, 2) = slid.stress(2, 0) = -shear_modulus * slid.shear_strain;
    shear.findings.curve = {{}, slid};
    const std::vector<LaboratoryTest> loaded{{"up", &triaxial}, {"down", &extension}, {"shear", &shear}};
    const Figure figure = *stiffness_over_strain({{"small", &stiff}}, loaded);
    const std::vector<double>&strain = figure.table.numbers("shear_strain"),
          &modulus = figure.table.numbers("secant_shear_modulus");
    const std::vector<double> wanted{1e-4, 0.13, 0.26, 0.13, 0.5}; // [%]
    ASSERT_EQ(strain.size(), wanted.size());
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        EXPECT_NEAR(strain[k], wanted[k], 1e-12) << k;
        EXPECT_NEAR(modulus[k], shear_modulus / 1e6, 1e-9) << k;
    }
    EXPECT_TRUE(figure.claim.empty()); // it is nowhere half of that of small strains
    EXPECT_FALSE(stiffness_over_strain({}, loaded).has_value());
    EXPECT_FALSE(stiffness_over_strain({{"small", &stiff}}, {}).has_value());
}

TEST(LaboratoryFigures, TheClaimNamesTheStrainThatHalvesTheStiffness) {
    Laboratory laboratory;
    record::FinishedStage& stiff = laboratory.add(triaxial::StiffnessSpec{});
    stiff.numbers = {{"shear_modulus", 2.5 * shear_modulus}};
    record::FinishedStage& triaxial = laboratory.add(triaxial::TriaxialSpec{});
    triaxial.findings.curve = {elastic_row(0, 0), elastic_row(1e-3, 4e-4)};
    EXPECT_EQ(
        stiffness_over_strain({{"small", &stiff}}, {{"up", &triaxial}})->claim,
        "up: G falls below half of G₀ by 0.13 % of shear strain"
    );
}

TEST(LaboratoryFigures, CyclicResistanceIsDrawnOfTheTestsThatLiquefied) {
    Laboratory laboratory;
    const auto cyclic = [&](std::optional<double> csr, const nlohmann::json& cycles) {
        triaxial::CyclicSpec spec;
        spec.cycles->csr = csr;
        record::FinishedStage& stage = laboratory.add(spec);
        stage.numbers = {{"cycles_to_liquefaction", cycles}};
        return &stage;
    };
    const std::vector<LaboratoryTest> tests{
        {"before", cyclic(0.3, 2.5)},
        {"before", cyclic(0.1, nullptr)},
        {"after", cyclic(std::nullopt, 7.5)},
        {"after", cyclic(0.2, 11.0)}};
    const Figure figure = *cyclic_resistance(tests);
    EXPECT_EQ(figure.table.numbers("csr"), (std::vector<double>{0.3, 0.2}));
    EXPECT_EQ(figure.table.numbers("cycles_to_liquefaction"), (std::vector<double>{2.5, 11.0}));
    EXPECT_EQ(figure.claim, "2 tests liquefy in 2.5 to 11 cycles");
    EXPECT_FALSE(cyclic_resistance({tests.begin(), tests.begin() + 3}).has_value());
}

} // namespace
} // namespace suffuse::figures
