// The same input gives the same bits: for any number of threads, and across saving, loading and sorting.

#include "suffuse/base/parallel.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/dem/settle.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/io/checkpoint.hpp"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"
#include "tests/support/worlds.hpp"
#include <functional>
#include <vector>

namespace suffuse::dem {
namespace {

constexpr double dt = 4e-8; // [s]

StepPlan under_servo() {
    StepPlan plan = test::plan_of(dt, 0.2);
    plan.loading = isotropic_stress(1.2e5);
    plan.loading.axis[2] = {cell::Control::StrainRate, 30};
    return plan;
}

/// A bonded, twisting, partly held sample: every column that a state can have is in use.
World full_sample() {
    World world = test::reference_packing("packing500");
    world.material.twisting_stiffness = 1;
    world.material.twisting_friction = 0.1;
    world.material.adhesion_normal = world.material.adhesion_shear = 1e5;
    for (const std::size_t g : {3, 77, 400}) {
        world.grains.motion[g] = grains::Motion::Held;
    }
    return world;
}

class SampleOnAnyNumberOfThreads : public testing::TestWithParam<bool> {};

TEST_P(SampleOnAnyNumberOfThreads, GivesTheSameHashAfter2000StepsUnderServo) {
    std::vector<std::uint64_t> hashes;
    for (const int threads : {1, 2, 4}) {
        set_thread_count(threads);
        World world = GetParam() ? full_sample() : test::reference_packing("packing500");
        StepCaches caches;
        test::advance(world, caches, under_servo(), 2000);
        hashes.push_back(state_hash(world));
    }
    set_thread_count(1);
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

INSTANTIATE_TEST_SUITE_P(Samples, SampleOnAnyNumberOfThreads, testing::Values(false, true), [](const auto& test) {
    return std::string(test.param ? "Bonded" : "Plain");
});

TEST(AnyNumberOfThreads, GivesTheSameHashTimeStepAndBalanceOfASampleOfTenDomains) {
    std::vector<std::uint64_t> hashes;
    std::vector<double> numbers;
    for (const int threads : {1, 2, 3}) {
        set_thread_count(threads);
        World world = test::reference_packing("packing10k");
        StepCaches caches;
        test::advance(world, caches, under_servo(), 100);
        hashes.push_back(state_hash(world));
        const Equilibrium balance = measure_equilibrium(world);
        for (const double number :
             {stable_time_step(world), balance.unbalanced_force, balance.kinetic_energy, balance.max_overlap_ratio,
              mean_stress(mean_stress_tensor(world))}) {
            numbers.push_back(number);
        }
    }
    set_thread_count(1);
    EXPECT_EQ(hashes, std::vector(3, hashes[0]));
    for (std::size_t k = 5; k < numbers.size(); ++k) {
        EXPECT_EQ(numbers[k], numbers[k - 5]) << k;
    }
}

/// Hash after twice `steps`, with `at_half` done to the world in the middle.
std::uint64_t hash_after(World world, std::int64_t steps, const std::function<void(World&, StepCaches&)>& at_half) {
    StepCaches caches;
    test::advance(world, caches, under_servo(), steps);
    at_half(world, caches);
    test::advance(world, caches, under_servo(), steps);
    return state_hash(world);
}

void save_and_load(World& world, StepCaches& caches) {
    const test::TempFolder folder;
    io::save_world(folder.path() / "half.h5", world);
    world = io::load_world(folder.path() / "half.h5").world;
    caches = {};
}

TEST(WorldSavedAndLoaded, GoesOnToTheSameBits) {
    for (const World& world : {test::reference_packing("packing500"), full_sample()}) {
        // Not a multiple of the interval at which the servo looks at the stiffness.
        const std::uint64_t straight = hash_after(world, 777, [](World&, StepCaches&) {});
        EXPECT_EQ(hash_after(world, 777, save_and_load), straight);
    }
}

TEST(WorldSavedAndLoaded, GoesOnToTheSameBitsAfterItsGrainsWereSortedAlongTheCurve) {
    const auto sort = [](World& world, StepCaches& caches) {
        sort_along_curve(world);
        caches = {};
    };
    const World world = full_sample();
    const std::uint64_t straight = hash_after(world, 500, sort);
    EXPECT_EQ(
        hash_after(
            world, 500,
            [&](World& half, StepCaches& caches) {
                sort(half, caches);
                save_and_load(half, caches);
            }
        ),
        straight
    );
}

TEST(WorldSavedAndLoaded, GoesOnToTheSameBitsAfterGrainsLeft) {
    const auto remove = [](World& world, StepCaches& caches) {
        std::vector<std::uint32_t> rows;
        for (std::uint32_t g = 0; g < world.grains.size(); g += 3) {
            rows.push_back(g);
        }
        remove_grains(world, rows);
        caches.neighborhood.invalidate();
    };
    const World world = test::reference_packing("packing500");
    const std::uint64_t straight = hash_after(world, 300, remove);
    EXPECT_EQ(
        hash_after(
            world, 300,
            [&](World& half, StepCaches& caches) {
                remove(half, caches);
                save_and_load(half, caches);
            }
        ),
        straight
    );
}

} // namespace
} // namespace suffuse::dem
