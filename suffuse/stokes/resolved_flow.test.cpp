#include "suffuse/stokes/resolved_flow.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace suffuse::stokes {
namespace {

struct Packing {
    cell::Cell cell;
    std::vector<Vec3> position;
    std::vector<double> radius;
};

/// One lattice cell of edge 1 moved off the grid, equal grains.
Packing lattice(std::vector<Vec3> position, double radius) {
    for (Vec3& p : position) {
        p += Vec3{0.123, 0.277, 0.391};
    }
    std::vector<double> radii(position.size(), radius);
    return {{}, std::move(position), std::move(radii)};
}

Packing simple_cubic(double radius) {
    return lattice({{0, 0, 0}}, radius);
}

Packing body_centered(double radius) {
    return lattice({{0, 0, 0}, {0.5, 0.5, 0.5}}, radius);
}

Packing face_centered(double radius) {
    return lattice({{0, 0, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}}, radius);
}

/// Grains of two sizes in a cell of unequal edges.
Packing mixed() {
    return {
        {{{{{1.1, 0, 0}, {0, 0.9, 0}, {0, 0, 1.3}}}}, {}},
        {{0.1, 0.2, 0.3}, {0.7, 0.6, 0.9}, {0.4, 0.75, 0.35}, {0.95, 0.15, 0.8}},
        {0.3, 0.3, 0.15, 0.2}};
}

ResolvedFlow flow_through(const Packing& packing, const flow::FlowSpec& spec = {1}, const ResolvedSpec& resolved = {}) {
    return resolve_flow(packing.cell, packing.position, packing.radius, spec, {}, resolved);
}

/// Force on a grain of a lattice over that on a lone sphere in water of the same superficial velocity.
double drag_ratio(const Packing& packing, double boxes_across) {
    ResolvedSpec resolved;
    resolved.boxes_across = boxes_across;
    const ResolvedFlow flow = flow_through(packing, {1}, resolved);
    return 1 /
           (static_cast<double>(packing.radius.size()) * 6 * std::numbers::pi * packing.radius[0] * flow.permeability);
}

TEST(ResolvedFlow, DragOnTouchingLatticesIsTheExactOne) { // [ZickHomsy1982]
    EXPECT_NEAR(drag_ratio(simple_cubic(0.5), 24), 42.1, 0.01 * 42.1);
    EXPECT_NEAR(drag_ratio(body_centered(std::sqrt(3.0) / 4), 24), 162.9, 0.015 * 162.9);
    EXPECT_NEAR(drag_ratio(face_centered(std::sqrt(2.0) / 4), 32), 435, 0.015 * 435);
}

TEST(ResolvedFlow, DragOnLatticesApartFromTouchingIsTheExactOne) { // [ZickHomsy1982]
    const auto radius = [](double solid_fraction) { return std::cbrt(solid_fraction * 3 / (4 * std::numbers::pi)); };
    EXPECT_NEAR(drag_ratio(simple_cubic(radius(0.125)), 16), 4.292, 0.005 * 4.292);
    EXPECT_NEAR(drag_ratio(simple_cubic(radius(0.45)), 20), 28.1, 0.01 * 28.1);
}

TEST(ResolvedFlow, ErrorOfOneGridFallsWithTheSquareOfItsSpacing) {
    const double exact = 42.1;
    const auto error = [&](double boxes_across) {
        ResolvedSpec resolved;
        resolved.boxes_across = boxes_across;
        const ResolvedFlow flow = flow_through(simple_cubic(0.5), {1}, resolved);
        return 1 - 1 / (6 * std::numbers::pi * 0.5 * flow.finer_permeability) / exact;
    };
    const double order = std::log2(error(16) / error(32));
    EXPECT_GT(order, 1.6);
    EXPECT_LT(order, 2.4);
}

TEST(ResolvedFlow, ForcesOnTheGrainsCarryTheWholePressureGradient) {
    flow::FlowSpec spec{0.3, {1, 2, -2}};
    const ResolvedFlow flow = flow_through(mixed(), spec);
    const Vec3 expected = -cell::volume(mixed().cell) * flow.pressure_gradient;
    EXPECT_NEAR(norm(flow.pressure_gradient), 0.3 * 1000 * gravity, 1e-9);
    EXPECT_LT(norm(flow.force_sum - expected), 1e-12 * norm(expected));
    EXPECT_GT(dot(flow.mean_velocity, spec.direction), 0);
}

TEST(ResolvedFlow, AnyDirectionFollowsFromTheTensorWhichIsSymmetric) {
    flow::FlowSpec spec{1, {0.6, 0, 0.8}, true};
    ResolvedSpec resolved;
    resolved.tolerance = 1e-7; // of forces the root of it
    const ResolvedFlow flow = flow_through(mixed(), spec, resolved);
    spec.tensor = false;
    const ResolvedFlow alone = flow_through(mixed(), spec, resolved);
    ASSERT_TRUE(flow.tensor);
    EXPECT_NEAR(flow.permeability / alone.permeability, 1, 3e-4);
    EXPECT_NEAR(dot(spec.direction, *flow.tensor * spec.direction) / flow.permeability, 1, 1e-12);
    for (int a = 0; a < 3; ++a) {
        EXPECT_NEAR((*flow.tensor)(a, (a + 1) % 3), (*flow.tensor)((a + 1) % 3, a), 3e-4 * flow.permeability);
    }
    for (std::size_t g = 0; g < flow.grain_force.size(); ++g) {
        EXPECT_LT(norm(flow.grain_force[g] - alone.grain_force[g]), 1e-3 * norm(alone.grain_force[g]));
    }
}

TEST(ResolvedFlow, PermeabilityScalesWithTheSquareOfLengthsOverSixDecades) {
    Packing small = mixed();
    const double factor = std::ldexp(1.0, -20); // exact, so that no face changes sides by rounding
    for (std::size_t g = 0; g < small.radius.size(); ++g) {
        small.position[g] *= factor;
        small.radius[g] *= factor;
    }
    small.cell.h = factor * small.cell.h;
    const double ratio = flow_through(small).permeability / flow_through(mixed()).permeability;
    EXPECT_NEAR(ratio, factor * factor, 1e-9 * factor * factor);
}

TEST(ResolvedFlow, GrainsMayBeAnywhereAlongTheirPeriods) {
    Packing moved = mixed();
    moved.position[0].x -= 3 * 1.1;
    moved.position[2].z += 2 * 1.3;
    EXPECT_NEAR(flow_through(moved).permeability / flow_through(mixed()).permeability, 1, 1e-4);
}

TEST(ResolvedFlow, HasTheSameBitsForAnyNumberOfThreads) {
    const int before = thread_count();
    set_thread_count(1);
    const ResolvedFlow one = flow_through(mixed());
    set_thread_count(3);
    const ResolvedFlow three = flow_through(mixed());
    set_thread_count(before);
    EXPECT_EQ(one.permeability, three.permeability);
    EXPECT_EQ(one.grain_force, three.grain_force);
}

TEST(ResolvedFlow, RefusesWhatItCannotResolve) {
    Packing sheared = mixed();
    sheared.cell.h(0, 1) = 0.1;
    EXPECT_THROW(flow_through(sheared), GeometryError);
    EXPECT_THROW(flow_through(mixed(), {1}, {2}), CaseError);
    EXPECT_THROW(flow_through(mixed(), {1}, {1e6}), GeometryError);
    EXPECT_THROW(flow_through(simple_cubic(0.5), {1}, {4}), GeometryError); // 4 boxes wide, on the coarser grid too
    EXPECT_THROW(resolve_flow({}, {}, {}, {1}, {}), CaseError);
    EXPECT_THROW(flow_through(mixed(), {1, {0, 0, 0}}), CaseError);
    for (const double radius : {0.0, -0.1, std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_THROW(flow_through(simple_cubic(radius)), GeometryError);
    }
    Packing far = mixed();
    far.position[1].y = 1e30;
    EXPECT_THROW(flow_through(far), GeometryError);
}

} // namespace
} // namespace suffuse::stokes
