#include "suffuse/erosion/transport.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/neighbors/pairs.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"
#include <algorithm>
#include <cmath>
#include <utility>

namespace suffuse::erosion {
namespace {

Transport three_grains() {
    Transport transport;
    transport.distance = 10;
    transport.id = {1, 2, 3};
    transport.mass = {1, 2, 4};
    transport.travel = {12, -0.5, 3};
    transport.fate = {Fate::Left, Fate::Stayed, Fate::Lodged};
    return transport;
}

TEST(FilterCoefficient, IsTheMassHeldOverMassTimesTravel) {
    EXPECT_NEAR(filter_coefficient(three_grains()).value(), (2 + 4) / (1 * 12 + 2 * 0 + 4 * 3.0), 1e-15);
    Transport free = three_grains();
    free.fate = {Fate::Left, Fate::Left, Fate::Left};
    EXPECT_EQ(filter_coefficient(free), 0);
    EXPECT_FALSE(filter_coefficient(Transport{}));
}

TEST(FilterCoefficient, IsThatOfAnExponentialLawWhereverItIsCut) {
    constexpr int grains = 10'000;
    constexpr double coefficient = 3;
    for (const double distance : {0.1, 0.5, 10.0}) {
        Transport transport;
        for (int k = 0; k < grains; ++k) { // the law's quantiles
            const double travel = -std::log(1 - (k + 0.5) / grains) / coefficient;
            transport.id.push_back(static_cast<std::uint32_t>(k));
            transport.mass.push_back(2);
            transport.travel.push_back(std::min(travel, distance));
            transport.fate.push_back(travel < distance ? Fate::Lodged : Fate::Left);
        }
        EXPECT_NEAR(filter_coefficient(transport).value(), coefficient, 1e-3 * coefficient) << distance;
    }
}

TEST(Fate, OfAGrainThatFindsRoomWithinAThousandthOfItsRadiusIsToStay) {
    const Vec3 position{1, 2, 3};
    const auto held = [&](double shift) { return fate_of(false, position + Vec3{0, shift, 0}, position, 0.5); };
    EXPECT_EQ(held(0.9e-3 * 0.5), Fate::Stayed);
    EXPECT_EQ(held(1.1e-3 * 0.5), Fate::Lodged);
    EXPECT_EQ(fate_of(false, std::nullopt, position, 0.5), Fate::Stayed) << "no room";
    EXPECT_EQ(fate_of(true, std::nullopt, position, 0.5), Fate::Left);
}

/// The smaller half of the reference's packing are fines, shrunk to half, so that some pass and some do not.
dem::World packing_with_small_fines() {
    dem::World world = test::reference_packing("packing2000");
    std::vector<double> sorted = world.grains.radius;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
    test::split_at(world, 2 * sorted[sorted.size() / 2]);
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        world.grains.radius[g] *= world.grains.fine[g] != 0 ? 0.5 : 1;
        world.grains.velocity[g] = {1, 2, 3};
    }
    return world;
}

std::vector<std::uint32_t> rows_of_fines(const dem::World& world) {
    std::vector<std::uint32_t> rows;
    for (std::uint32_t g = 0; g < world.grains.size(); ++g) {
        if (world.grains.fine[g] != 0) {
            rows.push_back(g);
        }
    }
    return rows;
}

bool is_lodged(const Transport& transport, std::uint32_t id) {
    const auto found = std::find(transport.id.begin(), transport.id.end(), id);
    return found != transport.id.end() &&
           transport.fate[static_cast<std::size_t>(found - transport.id.begin())] == Fate::Lodged;
}

TEST(TransportFines, GrainsLeaveLodgeOrStayAndNoTwoLieInOnePlace) {
    const dem::World before = packing_with_small_fines();
    dem::World world = before;
    const std::vector<std::uint32_t> fines = rows_of_fines(world);
    PassResult pass;
    const std::vector<std::uint32_t> left = transport_fines(world, fines, {}, {}, {}, pass);
    const Transport& transport = pass.transport;
    ASSERT_EQ(transport.size(), fines.size());
    EXPECT_NEAR(transport.distance, before.cell.h(2, 2), 1e-15) << "unless said";
    const auto count = [&](Fate fate) { return std::count(transport.fate.begin(), transport.fate.end(), fate); };
    EXPECT_EQ(count(Fate::Left), std::ssize(left));
    EXPECT_GT(count(Fate::Left), 10);
    EXPECT_GT(count(Fate::Lodged), 10);
    EXPECT_GT(count(Fate::Stayed), 10);
    for (std::size_t k = 0; k < fines.size(); ++k) {
        const bool has_moved = world.grains.position[fines[k]] != before.grains.position[fines[k]];
        EXPECT_EQ(has_moved, transport.fate[k] == Fate::Lodged);
        if (has_moved) {
            EXPECT_EQ(world.grains.velocity[fines[k]], Vec3{});
            EXPECT_GT(transport.throats[k], 0);
            EXPECT_LE(transport.constriction[k], transport.diameter[k]);
        }
    }
    dem::remove_grains(world, left);
    for (const neighbors::Pair& pair :
         neighbors::find_pairs(world.cell.h, world.grains.position, world.grains.radius, 0)) {
        const auto [a, b] = std::pair(pair.first, pair.second);
        const Vec3 branch = world.grains.position[b] + shift(world.cell.h, pair.image) - world.grains.position[a];
        const double sizes = world.grains.radius[a] + world.grains.radius[b];
        const double least = std::min(world.grains.radius[a], world.grains.radius[b]);
        const bool one_lodged = is_lodged(transport, world.grains.id[a]) || is_lodged(transport, world.grains.id[b]);
        EXPECT_FALSE(one_lodged && sizes - norm(branch) > 1e-8 * least);
    }
}

TEST(TransportFines, GoesAsFarAsSpecified) {
    dem::World world = packing_with_small_fines();
    const std::vector<std::uint32_t> fines = rows_of_fines(world);
    ErodeSpec spec;
    PassResult near_pass, far_pass;
    spec.transport_distance = 0.2 * world.cell.h(2, 2);
    const std::size_t near_left = transport_fines(world, fines, spec, {}, {}, near_pass).size();
    world = packing_with_small_fines();
    spec.transport_distance = 2 * world.cell.h(2, 2);
    EXPECT_LT(transport_fines(world, fines, spec, {}, {}, far_pass).size(), near_left);
    EXPECT_EQ(far_pass.transport.distance, *spec.transport_distance);
}

TEST(TransportFines, EntersHowFarTheFirstPassTookEachGrain) {
    const dem::World before = packing_with_small_fines();
    dem::World world = before;
    const std::vector<std::uint32_t> fines = rows_of_fines(world);
    PassResult first;
    transport_fines(world, fines, {}, {}, {}, first);
    for (std::size_t k = 0; k < fines.size(); ++k) {
        const double moved = (world.grains.position[fines[k]] - before.grains.position[fines[k]]).z;
        const double reported = first.transport.progress[k];
        if (first.transport.fate[k] == Fate::Left) {
            EXPECT_EQ(reported, first.transport.travel[k]) << k;
        } else { // a place beyond the cell's edge is one in the cell
            EXPECT_NEAR(std::remainder(reported - moved, before.cell.h(2, 2)), 0, 1e-12) << k;
        }
    }
}

TEST(TransportFines, WhatAGrainHasComeInEarlierPassesCounts) {
    dem::World world = packing_with_small_fines();
    const std::vector<std::uint32_t> fines = rows_of_fines(world);
    ErosionResult so_far;
    ErodeSpec spec;
    spec.transport_distance = 2 * world.cell.h(2, 2);
    PassResult& first = so_far.passes.emplace_back();
    const std::size_t in_one_pass = transport_fines(world, fines, spec, {}, {}, first).size();
    for (double& progress : first.transport.progress) {
        progress = 1.9 * world.cell.h(2, 2); // nearly there, wherever they lie
    }
    so_far.passes.emplace_back(); // from which none of them moved
    PassResult second;
    EXPECT_GT(transport_fines(world, fines, spec, {}, so_far, second).size(), in_one_pass);
    for (std::size_t k = 0; k < second.transport.size(); ++k) {
        const double before = 1.9 * world.cell.h(2, 2), after = second.transport.progress[k];
        const bool stayed = second.transport.fate[k] == Fate::Stayed;
        EXPECT_EQ(after == before, stayed) << k;
        EXPECT_EQ(after >= *spec.transport_distance, second.transport.fate[k] == Fate::Left) << k;
    }
}

TEST(TransportFines, ADistanceBeyondAThousandCellsIsRefused) {
    dem::World world = packing_with_small_fines();
    ErodeSpec spec;
    spec.transport_distance = 1001 * world.cell.h(2, 2);
    PassResult pass;
    EXPECT_THROW(transport_fines(world, rows_of_fines(world), spec, {}, {}, pass), StateError);
}

} // namespace
} // namespace suffuse::erosion
