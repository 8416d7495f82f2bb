#include "suffuse/packing/skeleton_first.hpp"

#include "suffuse/dem/inspect.hpp"
#include "suffuse/neighbors/pairs.hpp"
#include "suffuse/packing/overlaps.hpp"
#include "suffuse/packing/seed.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace suffuse::packing {
namespace {

/// A cloud of 40 coarse grains of 1 mm with so many fines of 0.2 mm.
dem::World cloud_with(std::size_t fines) {
    grains::SampledGrains sample;
    sample.radius.assign(40, 0.5e-3);
    sample.fine.assign(40, 0);
    sample.radius.insert(sample.radius.end(), fines, 0.1e-3);
    sample.fine.insert(sample.fine.end(), fines, 1);
    const Cloud made = make_cloud(sample, {}, 2600, 3);
    dem::World world;
    world.cell = made.cell;
    world.grains = made.grains;
    world.seed = 7;
    return world;
}

/// The coarse grains at a porosity of 0.45, as openly as a loose skeleton stands, and the fines next to them.
struct Parts {
    dem::World skeleton;
    grains::Grains fines;
};

Parts parts_with(std::size_t fines) {
    Parts parts;
    parts.skeleton = cloud_with(fines);
    parts.fines = take_out_fines(parts.skeleton);
    EXPECT_TRUE(bring_to_porosity(parts.skeleton, 0.45));
    return parts;
}

double least_gap(const dem::World& world) {
    double least = 1;
    for (const auto& pair : neighbors::find_pairs(world.cell.h, world.grains.position, world.grains.radius, 1e-4)) {
        if (pair.second >= 40) { // what two coarse grains do is theirs
            const Vec3 branch = world.grains.position[pair.second] + cell::shift(world.cell.h, pair.image) -
                                world.grains.position[pair.first];
            least = std::min(least, norm(branch) - world.grains.radius[pair.first] - world.grains.radius[pair.second]);
        }
    }
    return least;
}

TEST(SkeletonFirst, FinesThatFitLeaveTheSkeletonAsItIs) {
    Parts parts = parts_with(300);
    const Mat3 cell = parts.skeleton.cell.h;
    const std::vector<Vec3> stands = parts.skeleton.grains.position;
    const Placing placing = put_into_voids(parts.skeleton, parts.fines);
    EXPECT_TRUE(placing.touch_none);
    EXPECT_EQ(placing.widening, 1);
    EXPECT_EQ(parts.skeleton.cell.h, cell);
    const std::vector<Vec3>& now = parts.skeleton.grains.position;
    EXPECT_TRUE(std::equal(stands.begin(), stands.end(), now.begin()));
}

TEST(SkeletonFirst, EachFineGrainKeepsItsDistanceToAllOthers) {
    Parts parts = parts_with(300);
    put_into_voids(parts.skeleton, parts.fines);
    // Fines swollen by 7.4 % touch nothing: two keep 15 % of a radius between them, a fine and a coarse grain half of
    // it.
    EXPECT_GT(least_gap(parts.skeleton), 0.07 * 0.1e-3);
}

TEST(SkeletonFirst, WhereTheFinesDoNotFitTheSkeletonIsWidenedEvenly) {
    Parts parts = parts_with(4000);
    const Mat3 cell = parts.skeleton.cell.h;
    const Vec3 stands = parts.skeleton.grains.position[5];
    const Placing placing = put_into_voids(parts.skeleton, parts.fines);
    EXPECT_TRUE(placing.touch_none);
    EXPECT_GT(placing.widening, 1.05);
    EXPECT_NEAR(parts.skeleton.cell.h(0, 0), placing.widening * cell(0, 0), 1e-12 * cell(0, 0));
    EXPECT_LT(norm(parts.skeleton.grains.position[5] - placing.widening * stands), 1e-12 * norm(stands));
    EXPECT_GT(least_gap(parts.skeleton), 0);
}

TEST(SkeletonFirst, EveryGrainOfTheCloudIsThereOnceAsItWas) {
    const dem::World cloud = cloud_with(300);
    Parts parts = parts_with(300);
    put_into_voids(parts.skeleton, parts.fines);
    dem::World& made = parts.skeleton;
    ASSERT_EQ(made.grains.size(), cloud.grains.size());
    for (std::size_t g = 0; g < made.grains.size(); ++g) {
        const auto before = std::ranges::find(cloud.grains.id, made.grains.id[g]) - cloud.grains.id.begin();
        EXPECT_EQ(made.grains.radius[g], cloud.grains.radius[static_cast<std::size_t>(before)]);
        EXPECT_EQ(made.grains.fine[g], cloud.grains.fine[static_cast<std::size_t>(before)]);
        EXPECT_EQ(made.grains.mass[g], cloud.grains.mass[static_cast<std::size_t>(before)]);
    }
}

TEST(SkeletonFirst, OneSeedGivesOneSampleAndAnotherSeedAnother) {
    const auto placed = [](std::uint64_t seed) {
        Parts parts = parts_with(300);
        parts.skeleton.seed = seed;
        put_into_voids(parts.skeleton, parts.fines);
        return parts.skeleton.grains.position;
    };
    EXPECT_EQ(placed(7), placed(7));
    EXPECT_NE(placed(7), placed(8));
}

} // namespace
} // namespace suffuse::packing
