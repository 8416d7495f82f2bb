#include "suffuse/stokes/water.hpp"

#include <gtest/gtest.h>

#include "tests/support/packings.hpp"

namespace suffuse::stokes {
namespace {

using flow::Solver;

/// A simple cubic lattice, and a fine grain in the middle of one of its voids.
test::Packing one_fine() {
    test::Packing packing = test::lattice(2, 1, 0.42, {{0.1, 0.2, 0.3}});
    packing.position.push_back({0.6, 0.7, 0.8});
    packing.radius.push_back(0.1);
    return packing;
}

Water water_of(const test::Packing& packing, const flow::SolverChoice& how) {
    const std::vector<std::uint8_t> unmarked(packing.radius.size());
    return solve_water({packing.h, {}}, packing.position, packing.radius, unmarked, {1, {0, 0, 1}}, {}, how);
}

TEST(Water, IsOfTheNetworkUnlessAnotherIsAsked) {
    const Water water = water_of(one_fine(), {});
    EXPECT_EQ(water.source.solver, Solver::Network);
    EXPECT_FALSE(water.resolved);
    EXPECT_EQ(water.permeability(), water.network.permeability);
    EXPECT_EQ(water.source.doubt, flow::Doubt::FewFines);
    EXPECT_EQ(water.source.known_error.permeability, 0.20);
}

TEST(Water, WithBoxesAloneHasAResolvedFlowBesideTheNetworks) {
    const Water water = water_of(one_fine(), {.resolve = 8});
    EXPECT_TRUE(water.resolved);
    EXPECT_EQ(water.source.solver, Solver::Network);
    EXPECT_EQ(water.permeability(), water.network.permeability);
}

TEST(Water, ThatIsResolvedHasItsPermeabilityAndForces) {
    const Water water = water_of(one_fine(), {.solver = Solver::Resolved, .resolve = 8});
    ASSERT_TRUE(water.resolved);
    EXPECT_EQ(water.source.solver, Solver::Resolved);
    EXPECT_EQ(water.permeability(), water.resolved->permeability);
    EXPECT_EQ(&water.grain_force(), &water.resolved->grain_force);
    EXPECT_GT(water.source.known_error.permeability, 0);
    EXPECT_LT(water.source.known_error.permeability, 0.2);
}

TEST(Water, IsResolvedByAutoWhereTheNetworkIsInDoubtAndTheCellRightAngled) {
    const flow::SolverChoice how{.solver = Solver::Auto, .resolve = 8};
    EXPECT_EQ(water_of(one_fine(), how).source.solver, Solver::Resolved);
    test::Packing coarse = one_fine();
    coarse.position.pop_back();
    coarse.radius.pop_back();
    EXPECT_EQ(water_of(coarse, how).source.solver, Solver::Network);
    test::Packing sheared = one_fine();
    sheared.h(0, 1) = 0.1;
    const Water water = water_of(sheared, how);
    EXPECT_EQ(water.source.solver, Solver::Network);
    EXPECT_NE(water.source.doubt, flow::Doubt::None);
}

TEST(Water, IsOfTheToleranceThatIsAsked) {
    const Water rough = water_of(one_fine(), {.solver = Solver::Resolved, .resolve = 8, .resolve_tolerance = 1e-2}),
                fine = water_of(one_fine(), {.solver = Solver::Resolved, .resolve = 8, .resolve_tolerance = 1e-7});
    EXPECT_LT(rough.resolved->iterations, fine.resolved->iterations);
}

} // namespace
} // namespace suffuse::stokes
