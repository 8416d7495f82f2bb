// An erosion of many passes, and of fines that travel: what figures and captions show.
#include "suffuse/figures/figures.hpp"
#include "suffuse/study/passes.hpp"

#include <gtest/gtest.h>

#include "tests/support/sample_results.hpp"
#include <string>

namespace suffuse::figures {
namespace {

using erosion::ErosionResult;
using nlohmann::json;

ErosionResult erosion_of(int passes) {
    ErosionResult erosion = test::sample_erosion();
    erosion.path.clear();
    erosion.passes.clear();
    for (int pass = 1; pass <= passes; ++pass) {
        erosion.passes.push_back(test::sample_pass(1, 0.998e5, 2e-6, 0.001, 2e-5));
        erosion.passes.back().pass = pass;
        test::add_path(erosion, pass, 0.998e5, 2e-6, 0.001, 2e-5);
    }
    return erosion;
}

TEST(FewPasses, AreTheFirstTheLastAndOthersEvenlyBetween) {
    const ErosionResult erosion = erosion_of(22);
    EXPECT_EQ(
        study::pass_names(study::few_passes(erosion, 4)),
        (std::vector<std::string>{"pass 1", "pass 8", "pass 15", "pass 22"})
    );
    EXPECT_EQ(study::few_passes(erosion, 30).size(), 22U);
    EXPECT_EQ(study::pass_names(study::few_passes(erosion, 1)), std::vector<std::string>{"pass 1"});
    EXPECT_TRUE(study::few_passes({}, 4).empty());
}

TEST(ManyPasses, AreDrawnAndDescribedByAFew) {
    const ErosionResult erosion = erosion_of(22);
    const Figure speeds = *speed_by_pass(erosion);
    EXPECT_EQ(speeds.chart["facet"]["sort"], json({"pass 1", "pass 8", "pass 15", "pass 22"}));
    EXPECT_NE(speeds.caption.find("(4 of 22 passes)"), std::string::npos) << speeds.caption;
    EXPECT_EQ(rules_compared({}, {{"", &erosion}})->chart["facet"]["sort"].size(), 4U);

    const Figure mass = *eroded_mass(erosion);
    EXPECT_EQ(mass.table.rows(), 22U) << "each has its bar";
    EXPECT_EQ(mass.chart["layer"].size(), 1U) << "without a number above it";
    EXPECT_EQ(eroded_mass(erosion_of(3))->chart["layer"].size(), 2U);

    const Figure contacts = *eroded_coordination(erosion);
    EXPECT_EQ(contacts.chart["transform"][0]["filter"]["oneOf"].size(), 6U);
    EXPECT_EQ(contacts.chart["encoding"]["color"]["scale"]["domain"].size(), 6U);
    for (const Figure& path : {*stress_path(erosion), *porosity_path(erosion)}) {
        EXPECT_NE(path.caption.find("(4 of 22 passes)"), std::string::npos) << path.caption;
        EXPECT_EQ(path.caption.find("pass 2:"), std::string::npos) << path.caption;
    }
    EXPECT_EQ(porosity_path(erosion)->chart["vconcat"][1]["encoding"]["color"]["scale"]["domain"].size(), 4U);
    const Table states = permeability_by_pass(erosion)->table; // the first column is what is written next to a state
    EXPECT_EQ(states.cell(0, 0), "before erosion");
    EXPECT_EQ(states.cell(10, 0), "");
    EXPECT_EQ(states.cell(22, 0), "after pass 22");
}

/// Of three grains of 1, 2 and 5 kg one leaves; the others are held 1 and 4 mm along the flow.
erosion::Transport three_grains() {
    erosion::Transport transport;
    transport.distance = 10e-3;
    transport.id = {1, 2, 3};
    transport.mass = {1, 2, 5};
    transport.travel = {11e-3, 1e-3, 4e-3};
    transport.fate = {erosion::Fate::Left, erosion::Fate::Stayed, erosion::Fate::Lodged};
    return transport;
}

TEST(TransportFigure, DrawsTheShareOfTheMassThatGetsFarther) {
    ErosionResult erosion = erosion_of(2);
    EXPECT_FALSE(transport_by_pass(erosion)) << "nothing travels";
    erosion.passes[1].transport = three_grains();
    erosion.passes[0].transport.distance = 10e-3; // requested, but nothing was detached
    EXPECT_NE(erosion_loop(erosion)->drawing.find("that grains meet on their way"), std::string::npos);
    const Figure figure = *transport_by_pass(erosion);
    const std::vector<double>& x = figure.table.numbers("travel");
    const std::vector<double>& share = figure.table.numbers("share_farther");
    ASSERT_EQ(x.size(), 101U);
    EXPECT_EQ(x.back(), 10);
    for (std::size_t k = 0; k < x.size(); ++k) {
        EXPECT_NEAR(share[k], x[k] < 0.999 ? 100 : x[k] < 3.999 ? 75 : 12.5, 1e-9) << x[k];
    }
    EXPECT_TRUE(figure.caption.starts_with("12 % of the mass detached in pass 2 left")) << figure.caption;
    EXPECT_NE(figure.caption.find("coefficient 0.21 per mm."), std::string::npos) << figure.caption; // 7/(11 + 2 + 20)
}

} // namespace
} // namespace suffuse::figures
