#include "suffuse/stokes/water.hpp"

#include <gtest/gtest.h>

#include "tests/support/packings.hpp"
#include <algorithm>
#include <cmath>

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

TEST(Water, IsOfTheNetworkUnlessAnotherIsRequested) {
    const Water water = water_of(one_fine(), {});
    EXPECT_EQ(water.source.solver, Solver::Network);
    EXPECT_FALSE(water.resolved);
    EXPECT_EQ(water.permeability(), water.network.permeability);
    EXPECT_EQ(water.source.doubt, flow::Doubt::FewFines);
    EXPECT_EQ(water.source.known_error.permeability, 0.20);
}

TEST(Water, IsThatOfTheCoarseGrainsWhereFinesWouldRaiseIt) {
    test::Packing packing = test::lattice(2, 1, 0.5, {{0.1, 0.2, 0.3}});
    const double alone = water_of(packing, {}).permeability();
    packing.position.push_back({0.6, 0.7, 0.8});
    packing.radius.push_back(0.05);
    const Water water = water_of(packing, {});
    const flow::Seepage raised =
        flow::solve_seepage({packing.h, {}}, packing.position, packing.radius, {1, {0, 0, 1}}, {});
    ASSERT_GT(raised.permeability, 1.02 * alone);
    EXPECT_TRUE(water.source.is_limited);
    EXPECT_NEAR(water.source.raised_by_fines.value() / (raised.permeability / alone), 1, 1e-12);
    EXPECT_NEAR(water.permeability() / alone, 1, 1e-12);
    const flow::Seepage& limited = water.network;
    EXPECT_NEAR(1e-3 * norm(limited.mean_velocity) / norm(limited.pressure_gradient) / alone, 1, 1e-12);
    const double share = alone / raised.permeability;
    for (std::size_t t = 0; t < raised.conductance.size(); ++t) {
        EXPECT_NEAR(limited.field.flux[t], share * raised.field.flux[t], 1e-12 * std::abs(raised.field.flux[t]));
        EXPECT_NEAR(limited.conductance[t], share * raised.conductance[t], 1e-12 * raised.conductance[t]);
    }
    EXPECT_EQ(limited.grain_force, raised.grain_force); // as do pressures, forces depend on no common factor
    EXPECT_LE(limited.force_sum_error, 1e-10);
    const Water by_yade = solve_water(
        {packing.h, {}}, packing.position, packing.radius, std::vector<std::uint8_t>(packing.size()), {1, {0, 0, 1}},
        {.conductance = flow::Conductance::Yade}, {}
    );
    EXPECT_FALSE(by_yade.source.is_limited);
}

TEST(Water, OfFewTinyFinesNeverHasAHigherPermeabilityThanTheCoarseGrains) {
    const test::Packing coarse = test::random_packing(5 * identity(), 40, 0.5, 0.6, 3);
    const double alone = water_of(coarse, {}).permeability();
    for (unsigned seed = 1; seed <= 20; ++seed) {
        test::Packing packing = coarse;
        const test::Packing fines = test::random_packing(5 * identity(), 400, 0.009, 0.011, seed);
        for (std::size_t g = 0; g < fines.size() && packing.size() < 50; ++g) {
            const bool is_free = std::ranges::all_of(coarse.position, [&](const Vec3& x) {
                Vec3 apart = fines.position[g] - x;
                for (int a = 0; a < 3; ++a) {
                    apart[a] -= 5 * std::round(apart[a] / 5);
                }
                return norm(apart) > 0.62;
            });
            if (is_free) {
                packing.position.push_back(fines.position[g]), packing.radius.push_back(fines.radius[g]);
            }
        }
        ASSERT_EQ(packing.size(), 50U);
        EXPECT_LE(water_of(packing, {}).permeability(), alone * (1 + 1e-12)) << seed;
    }
}

TEST(Water, WithBoxesAloneHasAResolvedFlowBesidesTheNetworks) {
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

TEST(Water, HasTheSpecifiedTolerance) {
    const Water rough = water_of(one_fine(), {.solver = Solver::Resolved, .resolve = 8, .resolve_tolerance = 1e-2}),
                fine = water_of(one_fine(), {.solver = Solver::Resolved, .resolve = 8, .resolve_tolerance = 1e-7});
    EXPECT_LT(rough.resolved->iterations, fine.resolved->iterations);
}

} // namespace
} // namespace suffuse::stokes
