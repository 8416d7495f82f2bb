// Which pairs the contact table holds, and until when: those that touch, and those whose own speeds could close the
// gap.

#include "suffuse/dem/neighborhood.hpp"

#include "suffuse/base/random.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

namespace suffuse::dem {
namespace {

constexpr double radius = 1e-3, dt = 1e-6; // [m], [s]

/// A pair that touches, and far from it a pair with a gap [m] that closes at a speed [m/s].
World touching_and_closing(double gap, double speed) {
    World world = test::two_grains(radius, radius, 1e-6, {});
    const Vec3 far = world.grains.position[0] + Vec3{0, 10 * radius, 0};
    test::add(world, far, radius);
    test::add(world, far + Vec3{2 * radius + gap, 0, 0}, radius);
    world.grains.velocity[2] = {0.5 * speed, 0, 0};
    world.grains.velocity[3] = {-0.5 * speed, 0, 0};
    return world;
}

class Table {
public:
    explicit Table(World start) : world(std::move(start)) {
        to_rows(world.grains, rows);
        update();
    }

    void update() { neighborhood.update(world, rows, nullptr, dt); }

    [[nodiscard]] bool holds(const Mat3& h) const { return neighborhood.holds(world, nullptr, h); }

    World world;
    MovingRows rows;
    Neighborhood neighborhood;
};

TEST(Neighborhood, HoldsPairsThatTouchAndThoseThatCouldSoon) {
    const double gap = 0.1 * radius;
    const double slow = 0.1,
                 fast = 10; // [m/s]: in 32 steps of 1 us 3e-6 m, far less than the gap, and 3e-4 m, far more
    EXPECT_EQ(Table(touching_and_closing(gap, slow)).world.contacts.size(), 1U);
    EXPECT_EQ(Table(touching_and_closing(gap, fast)).world.contacts.size(), 2U);
}

TEST(Neighborhood, HoldsUntilItIsForgottenOrTheCellIsStrained) {
    EXPECT_FALSE(Neighborhood().holds(touching_and_closing(1e-4, 0), nullptr, identity()));
    Table table(touching_and_closing(1e-4, 0));
    const Mat3 h = table.world.cell.h;
    EXPECT_TRUE(table.holds(h));
    EXPECT_FALSE(table.holds(0.9 * h)) << "a branch shrinks by a tenth";
    table.neighborhood.invalidate();
    EXPECT_FALSE(table.holds(h));
}

TEST(Neighborhood, SearchesOnlyWhenItsWideListRunsOut) {
    Table table(touching_and_closing(1e-4, 0));
    table.update();
    EXPECT_EQ(table.neighborhood.searches(), 1);
    EXPECT_EQ(table.neighborhood.prunings(), 2);
    table.rows[3].position[0] -= 2 * radius; // by hand, further than any margin
    table.update();
    EXPECT_EQ(table.neighborhood.searches(), 2);
    EXPECT_EQ(table.world.contacts.size(), 2U) << "now they overlap";
}

TEST(Neighborhood, OfAFewThatLeaveItsWideListSeeksTheNeighborsAlone) {
    World many = touching_and_closing(1e-4, 0);
    for (const double height : {20, 23, 26, 29, 32, 35}) {
        test::add(many, many.grains.position[0] + Vec3{0, height * radius, 0}, radius);
    }
    Table table(many);
    table.rows[3].position[0] -= 2 * radius; // by hand, further than any margin
    table.update();
    EXPECT_EQ(table.neighborhood.searches(), 1);
    EXPECT_EQ(table.world.contacts.size(), 2U) << "now they overlap";
    table.rows[3].position[0] += 2 * radius;
    table.world.contacts = {};
    table.update();
    EXPECT_EQ(table.world.contacts.size(), 1U) << "and now no more";
}

TEST(Neighborhood, FindsAllPairsOfGrainsThatGoToAndFroAmongOthersThatRest) {
    constexpr int grains = 60;
    World world;
    world.cell.h = diagonal({12 * radius, 12 * radius, 12 * radius});
    RandomStream random(7, "to and fro");
    for (int g = 0; g < grains; ++g) {
        const Vec3 fraction{random.uniform(), random.uniform(), random.uniform()};
        test::add(world, world.cell.h * fraction, g % 5 == 0 ? radius : 0.4 * radius);
    }
    Table table(world);
    for (int step = 0; step < 300; ++step) {
        table.world.contacts = {}; // what touched is found anew, too
        for (std::size_t g = 0; g < grains; ++g) {
            const double stride = g % 7 == 0 ? 0.1 * radius : 0.001 * radius; // a few go far
            for (int a = 0; a < 3; ++a) {
                table.rows[g].position[a] += stride * (2 * random.uniform() - 1);
            }
        }
        table.update();
        std::vector<Vec3> position;
        for (const grains::MovingRow& row : table.rows) {
            position.push_back(xyz(row.position));
        }
        for (const neighbors::Pair& pair :
             neighbors::find_pairs_exhaustively(world.cell.h, position, world.grains.radius, 0)) {
            const contact::Contacts& contacts = table.world.contacts;
            bool is_there = false;
            for (std::size_t c = 0; c < contacts.size(); ++c) {
                is_there = is_there || (contacts.first[c] == pair.first && contacts.second[c] == pair.second &&
                                        contacts.image[c] == pair.image);
            }
            ASSERT_TRUE(is_there) << "step " << step << ": " << pair.first << ", " << pair.second;
        }
    }
    EXPECT_LT(table.neighborhood.searches(), 60) << "of 300 looks";
}

TEST(Neighborhood, WithoutPairsOfHeldGrainsTakesThemInOnceTheyAreFree) {
    World world = touching_and_closing(1e-4, 0);
    world.grains.motion[0] = world.grains.motion[1] = grains::Motion::Held;
    world.contacts = {};
    Table table(world);
    table.neighborhood.leave_out_held_pairs();
    table.world.contacts = {};
    table.neighborhood.forget_table();
    EXPECT_FALSE(table.holds(table.world.cell.h));
    table.update();
    EXPECT_EQ(table.world.contacts.size(), 0U);
    EXPECT_TRUE(table.neighborhood.all_sleepers_stand());
    table.world.grains.motion[0] = grains::Motion::Free;
    table.neighborhood.forget_table();
    table.update();
    EXPECT_EQ(table.world.contacts.size(), 1U);
    EXPECT_EQ(table.neighborhood.searches(), 1);
}

TEST(Neighborhood, ReportsTheMeanMotionSinceTheTableWasMade) {
    const Table table(touching_and_closing(1e-4, 0));
    const Mat3 h = table.world.cell.h;
    const Mat3 stretch = diagonal({1.25, 0.5, 2}); // powers of two but for one: no rounding beyond a bit
    const Mat3 motion = table.neighborhood.mean_motion(stretch * h);
    for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
            EXPECT_NEAR(motion(a, b), stretch(a, b), 1e-15);
        }
    }
}

TEST(Neighborhood, WatchesASleeperUntilItsSpeedTakesItOut) {
    Table still(touching_and_closing(0.5 * radius, 0)), slow(touching_and_closing(0.5 * radius, 0.01));
    const double of_still = still.neighborhood.sleepers_until(), of_slow = slow.neighborhood.sleepers_until();
    EXPECT_GT(of_still, of_slow);
    EXPECT_GT(of_slow, 0);
}

} // namespace
} // namespace suffuse::dem
