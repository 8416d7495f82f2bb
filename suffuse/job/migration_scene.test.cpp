#include "suffuse/job/migration_scene.hpp"

#include "suffuse/dem/inspect.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

namespace suffuse::job {
namespace {

constexpr double radius = 1e-3;

/// Grains in a row along x, by their ids; each overlaps the next. The first two are a coarse skeleton, which is held.
dem::World row_of_grains(const std::vector<std::uint32_t>& ids) {
    dem::World world = test::empty_world(40 * radius);
    for (std::uint32_t k = 0; k < ids.size(); ++k) {
        const bool is_fine = k >= 2;
        test::add(world, {(1 + 1.98 * k) * radius, 20 * radius, 20 * radius}, radius, is_fine);
        world.grains.id[k] = ids[k];
        world.grains.motion[k] = is_fine ? grains::Motion::Free : grains::Motion::Held;
        if (k > 0) {
            test::add_contact(world, k - 1, k);
        }
    }
    return world;
}

struct AMigration {
    std::vector<dem::World> frames{row_of_grains({1, 2, 5, 7}), row_of_grains({1, 2, 5, 9}), row_of_grains({1, 2, 9})};
    erosion::MigrationResult result;

    AMigration() {
        result.frames = {{0, 0, 1}, {0.25, 0.5, 8}, {0.5, 0.75, 8}};
        using erosion::Whereabouts;
        result.fates.id = {5, 7, 8, 9}; // 8 came and left between two frames
        result.fates.where = {Whereabouts::Lodged, Whereabouts::Eroded, Whereabouts::Eroded, Whereabouts::Moving};
    }
};

TEST(SceneOfMigration, HasEveryGrainWhileItIsThere) {
    const AMigration of;
    const report::Scene scene = scene_of_frames(of.frames, of.result);
    EXPECT_EQ(scene.id, (std::vector<std::uint32_t>{1, 2, 5, 7, 9}));
    EXPECT_EQ(scene.entered_in, (std::vector<int>{0, 0, 0, 0, 1}));
    EXPECT_EQ(scene.left_in, (std::vector<int>{0, 0, 2, 1, 0}));
    const auto there = [&](std::size_t state) {
        std::vector<std::uint32_t> ids;
        for (std::size_t g = 0; g < scene.id.size(); ++g) {
            if (report::is_present(scene, scene.states[state], g)) {
                ids.push_back(scene.id[g]);
            }
        }
        return ids;
    };
    EXPECT_EQ(there(0), (std::vector<std::uint32_t>{1, 2, 5, 7}));
    EXPECT_EQ(there(1), (std::vector<std::uint32_t>{1, 2, 5, 9}));
    EXPECT_EQ(there(2), (std::vector<std::uint32_t>{1, 2, 9}));
}

TEST(SceneOfMigration, SaysWhereEachGrainEnds) {
    const AMigration of;
    const report::Scene scene = scene_of_frames(of.frames, of.result);
    std::vector<std::string> fates;
    for (const std::uint8_t fate : scene.fate) {
        fates.push_back(scene.fates.at(fate));
    }
    EXPECT_EQ(fates, (std::vector<std::string>{"coarse", "coarse", "lodged elsewhere", "left", "moving at the end"}));
}

TEST(SceneOfMigration, HasTheTimeAndTheGradientOfEachState) {
    const AMigration of;
    const report::Scene scene = scene_of_frames(of.frames, of.result);
    ASSERT_EQ(scene.states.size(), 3U);
    EXPECT_EQ(scene.states[1].label, "i = 0.5, 0.25\u00a0s");
    EXPECT_EQ(scene.states[2].time, 0.5);
    EXPECT_EQ(scene.states[2].gradient, 0.75);
    EXPECT_EQ(scene.gradient, 0.75) << "the highest";
}

TEST(SceneOfMigration, ShowsForcesOfFreeGrainsInTheirTrueSizeAndCountsThoseOfTheSkeleton) {
    const AMigration of;
    const report::Scene scene = scene_of_frames(of.frames, of.result);
    const double made = norm(dem::inspect_contacts(of.frames[1])[0].normal_force);
    ASSERT_GT(made, 0);
    const report::SceneState& state = scene.states[1];
    ASSERT_EQ(state.contacts.size(), 2U) << "that of the two held grains is left out";
    for (const report::SceneContact& contact : state.contacts) {
        EXPECT_NEAR(contact.normal_force, made / 8, 1e-12 * made) << contact.i << " and " << contact.j;
    }
    ASSERT_TRUE(state.whole);
    EXPECT_EQ(state.whole->contacts, 3);
    EXPECT_NEAR(state.whole->largest_force, made, 1e-12 * made) << "of the skeleton, which no factor made softer";
}

TEST(SceneOfMigration, KnowsHowFarAGrainWentThatCrossedTheCellMoreThanOnce) {
    AMigration of;
    of.frames[1].grains.position[2] += of.frames[1].cell.h * Vec3{2, -1, 0};
    const report::Scene scene = scene_of_frames(of.frames, of.result);
    EXPECT_EQ(scene.states[1].period[2], (std::array{2, -1, 0}));
    EXPECT_EQ(scene.states[0].period[2], (std::array{0, 0, 0}));
    EXPECT_NEAR(norm(scene.states[1].position[2] - scene.states[0].position[2]), 0, 1e-12 * radius) << "in the cell";
}

} // namespace
} // namespace suffuse::job
