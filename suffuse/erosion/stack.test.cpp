// Layers: where they are, which head each takes, and a base that goes through a filter or does not.

#include "suffuse/erosion/stack.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/erosion/base_profile.hpp"
#include "suffuse/erosion/filter_view.hpp"
#include "suffuse/erosion/migration.hpp"

#include <gtest/gtest.h>

#include "tests/support/migrations.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace suffuse::erosion {
namespace {

using test::migrate;

constexpr double side = 2e-3; // of the cross-section [m]

/// Cubic lattices of touching grains on a square of `side`: fine ones from `begin`, coarse ones behind them, as many
/// layers of each.
dem::World two_lattices(int fines_across, int fine_layers, int coarse_layers, double begin, double gap = 1.001) {
    constexpr int coarse_across = 2;
    const double d = side / fines_across, D = side / coarse_across;
    dem::World world;
    const double base = gap * fine_layers * d, length = base + gap * coarse_layers * D;
    world.cell.h = diagonal({gap * side, gap * side, length});
    const auto add = [&](double diameter, int across, int layers, double from, std::uint8_t fine) {
        for (int k = 0; k < across * across * layers; ++k) {
            const int x = k % across, y = k / across % across, z = k / across / across;
            const Vec3 corner{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
            Vec3 at = gap * diameter * (corner + Vec3{0.5, 0.5, 0.5}) + Vec3{0, 0, from};
            at.z = std::fmod(at.z, length);
            world.grains.fine[add_grain(world.grains, at, diameter / 2, world.material.density)] = fine;
        }
    };
    add(d, fines_across, fine_layers, begin, 1);
    add(D, coarse_across, coarse_layers, begin + base, 0);
    return world;
}

TEST(Stack, FindsItsLayersWhereverTheCellBegins) {
    for (const double begin : {0.0, 0.7e-3, 2.5e-3, 4.9e-3}) {
        const Stack stack = find_layers(two_lattices(10, 6, 4, begin), {0, 0, 1});
        EXPECT_NEAR(stack.base_thickness(), 1.2e-3, 0.01e-3);
        EXPECT_NEAR(stack.filter_thickness(), 4e-3, 0.02e-3);
        const double off = (stack.face - begin) / stack.length;
        EXPECT_NEAR(off, std::round(off), 0.005);
        EXPECT_NEAR(stack.base_grain, 0.2e-3, 1e-9);
        EXPECT_NEAR(stack.filter_grain, 1e-3, 1e-9);
    }
}

TEST(Stack, HoldsItsFilterAndAScreenOfTheBase) {
    const dem::World world = two_lattices(10, 6, 4, 4.9e-3);
    const std::vector<std::uint8_t> held = held_in_stack(world, find_layers(world, {0, 0, 1}), {0, 0, 1});
    const auto fines = static_cast<std::ptrdiff_t>(600);
    EXPECT_EQ(std::accumulate(held.begin(), held.begin() + fines, 0), 100) << "the layer at the face";
    EXPECT_EQ(std::accumulate(held.begin() + fines, held.end(), 0), 16) << "all of the filter";
}

TEST(Stack, HoldsAGrainThatIsNoFurtherFromTheFaceThanTheLargestIsWide) {
    dem::World world = two_lattices(10, 6, 4, 0);
    const Stack stack = find_layers(world, {0, 0, 1});
    constexpr std::size_t in_second_layer = 150;
    const auto is_held = [&](double from_face) {
        world.grains.position[in_second_layer].z = stack.face + from_face * stack.base_grain;
        return held_in_stack(world, stack, {0, 0, 1})[in_second_layer] != 0;
    };
    EXPECT_TRUE(is_held(0.95));
    EXPECT_FALSE(is_held(1.05));
}

TEST(Stack, OfMixedGrainsIsNone) {
    dem::World world = two_lattices(4, 4, 4, 0);
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        world.grains.fine[g] = g % 2 == 0 ? 1 : 0;
    }
    try {
        find_layers(world, {0, 0, 1});
        FAIL() << "these are no layers";
    } catch (const StateError& error) {
        EXPECT_NE(std::string(error.what()).find("no layers"), std::string::npos);
    }
}

flow::Seepage unit_flow(const dem::World& world) {
    return flow::solve_seepage(
        world.cell, world.grains.position, world.grains.radius, {.gradient = 1, .direction = {0, 0, 1}}, {}
    );
}

/// The slow way: each lattice alone, periodic.
double permeability_alone(const dem::World& both, bool fine, double length) {
    dem::World alone;
    alone.cell.h = diagonal({both.cell.h(0, 0), both.cell.h(1, 1), length});
    double first = 1;
    for (std::size_t g = 0; g < both.grains.size(); ++g) {
        first = (both.grains.fine[g] != 0) == fine ? std::min(first, both.grains.position[g].z) : first;
    }
    for (std::size_t g = 0; g < both.grains.size(); ++g) {
        if ((both.grains.fine[g] != 0) == fine) {
            const Vec3 x = both.grains.position[g] - Vec3{0, 0, first};
            add_grain(alone.grains, x, both.grains.radius[g], both.material.density);
        }
    }
    return unit_flow(alone).permeability;
}

TEST(Stack, GivesEachLayerTheHeadOfItsOwnResistance) {
    const dem::World world = two_lattices(10, 12, 6, 0);
    const Stack stack = find_layers(world, {0, 0, 1});
    const flow::Seepage seepage = unit_flow(world);
    const LayerHeads gradients = layer_heads(seepage, world.grains, seepage.grain_force, stack, {0, 0, 1});
    const double base = permeability_alone(world, true, stack.base_thickness());
    const double filter = permeability_alone(world, false, stack.filter_thickness());
    // The same water goes through all: the gradient of a layer is that of the sample by the ratio of permeabilities.
    EXPECT_NEAR(seepage.permeability / gradients.base / base, 1, 0.01);
    EXPECT_NEAR(seepage.permeability / gradients.filter / filter, 1, 0.02);
    // Resistances add up, but for the planes between the layers, which are open: half a grain of each side.
    const double share = stack.base_thickness() / stack.length;
    const double of_layers = share / base + (1 - share) / filter;
    EXPECT_NEAR(of_layers * seepage.permeability, 1, 0.05);
    EXPECT_NEAR(share * gradients.base + (1 - share) * gradients.filter, 1, 0.05);
}

TEST(Stack, HasTheHeadOfItsInterfaceByTheForcesThere) {
    const dem::World world = two_lattices(10, 12, 6, 0);
    const flow::Seepage seepage = unit_flow(world);
    Stack stack = find_layers(world, {0, 0, 1});
    const auto heads = [&] { return layer_heads(seepage, world.grains, seepage.grain_force, stack, {0, 0, 1}); };
    const LayerHeads both = heads();
    const double D = stack.filter_thickness() / 6;
    const double of_both = 0.5 * stack.base_grain * both.base + stack.filter_grain * both.filter;
    EXPECT_LT(both.interface, of_both / stack.length) << "the plane between the lattices is open";
    EXPECT_GT(both.interface, 0.8 * of_both / stack.length);
    // Deep in the filter each layer of the lattice has its thickness's share of the gradient there. All heads add up.
    const double begin = stack.interface, base_thickness = stack.base_thickness();
    stack.base_grain = 0;
    stack.filter_grain = D;
    double sum = 0;
    for (int k = 0; k < 6; ++k) {
        stack.interface = begin + k * D;
        const double head = heads().interface;
        sum += head;
        if (k > 0 && k < 5) {
            EXPECT_NEAR(head / (both.filter * D / stack.length), 1, 0.02) << "layer " << k;
        }
    }
    stack.interface = stack.face;
    stack.filter_grain = base_thickness;
    EXPECT_NEAR(sum + heads().interface, 1, 1e-3);
}

MigrateSpec downward(double gradient) {
    return {
        .gradients = {gradient},
        .hold_at_most = 0.06,
        .still_for = 0.02,
        .gravity = Gravity{.down = {0, 0, 1}},
        .stack = true,
    };
}

TEST(Stack, HoldsABaseThatIsAsCoarseAsItsHolesAndLosesOneThatFitsThroughThem) {
    // Holes of a cubic lattice are 0.414 of its grains: of a half none gets through, of a quarter all could.
    const Migration held = migrate(two_lattices(4, 4, 3, 0), downward(1));
    EXPECT_EQ(eroded_mass(held.ledger), 0);
    EXPECT_TRUE(held.result.holds.back().ended);
    EXPECT_LT(held.result.holds.back().depth, 0.6e-3) << "the first layer of the filter stops them";
    dem::World fine = two_lattices(8, 3, 2, 0);
    fine.material.friction = 0;     // with it they arch
    MigrateSpec spec = downward(3); // under 1 the last bits of the forces decide how many get through
    spec.hold_at_most = 0.2;
    const Migration lost = migrate(fine, spec);
    EXPECT_GT(eroded_mass(lost.ledger), 0.5 * lost.result.fines_mass);
    // Grains that stop in the filter's face clog it; where none is left, its interface has the filter's own head.
    EXPECT_GT(held.now.interface, 1.2 * held.at_first.interface);
    const flow::Seepage left = unit_flow(lost.world);
    const double own = layer_heads(left, lost.world.grains, left.grain_force, lost.stack, {0, 0, 1}).interface;
    EXPECT_NEAR(lost.now.interface / own, 1, 0.05);
}

TEST(Stack, GivesTheBaseItsGradientAndKeepsItsMass) {
    const dem::World sample = two_lattices(6, 4, 3, 1e-3);
    const Migration migration = migrate(sample, downward(2));
    const MigrationRow& first = migration.result.rows.front();
    EXPECT_NEAR(first.base_gradient, 2, 1e-9);
    EXPECT_LT(first.sample_gradient, 1.5);
    EXPECT_LT(first.filter_gradient, 1);
    for (const MigrationRow& row : migration.result.rows) {
        EXPECT_EQ(row.sample_gradient, first.sample_gradient) << "the head is kept";
        const double share = migration.stack.base_thickness() / migration.stack.length;
        const double of_layers = share * row.base_gradient + (1 - share) * row.filter_gradient;
        // It is lost in the layers; between them as well, once base grains lie in the filter's face.
        EXPECT_LT(of_layers, 1.1 * row.sample_gradient);
        EXPECT_GT(of_layers, 0.4 * row.sample_gradient);
    }
    double before = 0, after = eroded_mass(migration.ledger);
    for (const double mass : sample.grains.mass) {
        before += mass;
    }
    for (const double mass : migrated_sample(migration, {}).grains.mass) {
        after += mass;
    }
    EXPECT_NEAR(after / before, 1, 1e-13);
    // The profile holds the base's volume, but for what has left; before, all of it.
    const BaseProfile& profile = migration.result.profile;
    ASSERT_EQ(profile.base.size(), 2U);
    const double slice = sample.cell.h(0, 0) * sample.cell.h(1, 1) * profile.step * sample.material.density;
    const double shown = slice * std::accumulate(profile.base.front().begin(), profile.base.front().end(), 0.0);
    const double all = migration.result.fines_mass + mass_of(migration.ledger, Whereabouts::Fixed);
    EXPECT_NEAR(shown / all, 1, 1e-9);
    const double left = slice * std::accumulate(profile.base.back().begin(), profile.base.back().end(), 0.0);
    EXPECT_NEAR((left + eroded_mass(migration.ledger)) / all, 1, 1e-9);
}

TEST(Stack, HasTheGradientOfItsWeightInABedThatTheWaterCarries) {
    dem::World sample = two_lattices(8, 4, 2, 0);
    sample.material.friction = 0;
    constexpr double room = 1e-3; // between base and filter
    sample.cell.h(2, 2) += room;
    for (std::size_t g = 0; g < sample.grains.size(); ++g) {
        sample.grains.position[g].z += sample.grains.fine[g] != 0 ? 0 : room;
    }
    MigrateSpec spec = downward(3);
    spec.hold_at_most = 0.02;
    spec.gravity = Gravity{.down = {0, 0, -1}};
    const Migration up = migrate(sample, spec);
    // Once it rises steadily, the drag bears its weight; of the few grains that stand no layer has two pores.
    const double area = sample.cell.h(0, 0) * sample.cell.h(1, 1);
    const double excess = sample.material.density / flow::Fluid{}.density - 1; // G - 1
    const double head = up.result.fines_mass / sample.material.density * excess / area;
    ASSERT_GT(up.result.rows.size(), 6U);
    for (std::size_t k = 4; k < up.result.rows.size(); ++k) {
        const MigrationRow& row = up.result.rows[k];
        EXPECT_EQ(row.moving_mass, up.result.fines_mass);
        const double of_base = row.base_gradient * up.stack.base_thickness();
        EXPECT_NEAR((of_base + row.filter_gradient * up.stack.filter_thickness()) / head, 1, 0.05) << row.time;
    }
    double at_interface = 0; // of the bed [kg]
    for (std::size_t k = 0; k < up.ledger.size(); ++k) {
        const bool moves = up.ledger.where[k] == Whereabouts::Moving;
        const double share = share_at_interface(up.ledger.end[k].z, 0.5 * up.ledger.diameter[k], up.stack);
        at_interface += moves ? up.ledger.mass[k] * share : 0;
    }
    const double all = up.result.rows.back().sample_gradient * up.stack.length; // [m]
    EXPECT_NEAR(up.now.interface * all / (head * at_interface / up.result.fines_mass), 1, 0.05);
}

TEST(Stack, MigratesToTheSameBitsForAnyNumberOfThreadsAndFromAnyOfItsStates) {
    const dem::World sample = two_lattices(6, 4, 3, 1e-3);
    const MigrateSpec spec = downward(5);
    const int threads = thread_count();
    set_thread_count(1);
    const Migration one = migrate(sample, spec);
    set_thread_count(3);
    Migration three = begin_migration(sample, spec, {});
    while (!three.over) {
        Migration copy = three;
        migrate_on(copy, spec, {});
        three = copy;
    }
    set_thread_count(threads);
    EXPECT_EQ(one.ledger.end, three.ledger.end);
    EXPECT_EQ(one.result.profile.base, three.result.profile.base);
    EXPECT_EQ(dem::state_hash(one.world), dem::state_hash(three.world));
}

TEST(BaseProfile, HasTheFilterOnBothSidesOfTheBase) {
    const dem::World world = two_lattices(8, 4, 3, 0.3e-3); // the base is as thick as two slices
    const BaseProfile profile = begin_profile(world, find_layers(world, {0, 0, 1}), {0, 0, 1});
    const double cubic = pi / 6;
    for (std::size_t k = 0; k < profile.filter.size(); ++k) {
        const double middle = profile.first + (static_cast<double>(k) + 0.5) * profile.step;
        const bool is_within = (middle > -1e-3 && middle < 0) || middle > 3e-3; // the next base
        EXPECT_NEAR(profile.filter[k], is_within ? 0 : cubic, 0.01) << "slice at " << middle;
    }
}

TEST(FilterView, HasTheHoleOfALatticeAsControllingConstrictionAndTheSizesOfBoth) {
    const dem::World world = two_lattices(6, 4, 3, 1e-3);
    const FilterView view = view_filter(world, find_layers(world, {0, 0, 1}), {0, 0, 1});
    constexpr double D = side / 2, gap = 1.001;
    EXPECT_NEAR(view.constriction, (std::sqrt(2.0) * gap - 1) * D, 1e-9 * D);
    EXPECT_NEAR(view.filter_d15, D, 1e-12);
    EXPECT_NEAR(view.base_d85, side / 6, 1e-12);
}

TEST(FilterView, CutsEachGrainThatThePlaneMeetsInItsCircle) {
    dem::World world = two_lattices(6, 4, 3, 1e-3);
    constexpr double off = 0.1e-3; // of the filter's centers from the plane
    const double middle = 0.5 * world.cell.h(1, 1);
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        if (world.grains.fine[g] == 0) {
            world.grains.position[g].y = world.grains.position[g].y < middle ? middle - off : middle + 5 * off;
        }
    }
    // The plane is normal to the axis two behind that of the flow.
    const StackCut cut = cut_stack(world, find_layers(world, {0, 0, 1}), {0, 0, 1});
    EXPECT_EQ(std::accumulate(cut.is_base.begin(), cut.is_base.end(), 0), 0) << "between two layers of the base";
    ASSERT_EQ(cut.radius.size(), 6U);
    for (std::size_t k = 0; k < cut.radius.size(); ++k) {
        EXPECT_NEAR(cut.radius[k], std::sqrt(0.25e-6 - off * off), 1e-12);
        EXPECT_GT(cut.along[k], 0);
        EXPECT_LT(cut.along[k], 3.01e-3);
    }
}

/// A frictionless base that a filter does not hold; every other grain is smaller by `factor`.
Migration lose_base_of_two_sizes(double factor, const std::optional<double>& gap) {
    dem::World world = two_lattices(8, 3, 2, 0);
    world.material.friction = 0;
    for (std::size_t g = 0; g < world.grains.size(); g += 2) {
        if (world.grains.fine[g] != 0) {
            world.grains.radius[g] *= factor;
            world.grains.mass[g] *= factor * factor * factor;
        }
    }
    MigrateSpec spec = downward(1);
    spec.hold_at_most = 0.1;
    spec.base_gap = gap;
    return migrate(world, spec);
}

TEST(FilterView, OfABaseWithAGapCountsTheGrainsBelowIt) {
    const double small = 0.6 * side / 8;
    const Migration lost = lose_base_of_two_sizes(0.6, 1.1 * small);
    const FilterView& view = lost.result.filter;
    EXPECT_EQ(view.base_gap, 1.1 * small);
    EXPECT_NEAR(view.base_d85, small, 1e-12);
    double all = 0, left = 0;
    for (std::size_t k = 0; k < lost.ledger.size(); ++k) {
        if (lost.ledger.diameter[k] < 1.1 * small && lost.ledger.where[k] != Whereabouts::Fixed) {
            all += lost.ledger.mass[k];
            left += lost.ledger.where[k] == Whereabouts::Eroded ? lost.ledger.mass[k] : 0;
        }
    }
    EXPECT_GT(left, 0);
    EXPECT_NEAR(view.passed, left / all, 1e-12);
    EXPECT_LT(all, 0.3 * lost.result.fines_mass);
}

TEST(FilterView, SharesWhatLeftAmongTheSizesOfTheBase) {
    const Migration lost = lose_base_of_two_sizes(0.8, std::nullopt);
    EXPECT_NEAR(lost.result.filter.passed, eroded_mass(lost.ledger) / lost.result.fines_mass, 1e-12);
    const BaseSizes& sizes = lost.result.filter.sizes;
    ASSERT_GT(sizes.diameter.size(), 2U);
    EXPECT_TRUE(std::ranges::is_sorted(sizes.diameter));
    double share = 0, left = 0;
    for (std::size_t k = 0; k < sizes.diameter.size(); ++k) {
        share += sizes.mass_share[k];
        left += sizes.mass_share[k] * sizes.eroded[k];
        EXPECT_LE(sizes.eroded[k], sizes.entered[k]);
    }
    EXPECT_NEAR(share, 1, 1e-12);
    EXPECT_GT(left, 0);
    EXPECT_NEAR(left * lost.result.fines_mass, eroded_mass(lost.ledger), 1e-12 * lost.result.fines_mass);
    EXPECT_GT(lost.result.filter.largest_eroded, 0.19e-3);
    EXPECT_NE(lost.result.filter.before.along, lost.result.filter.after.along);
}

TEST(Stack, NeedsAnExitBehindItsBase) {
    MigrateSpec spec = downward(1);
    spec.exit = 0.5e-3;
    try {
        begin_migration(two_lattices(6, 5, 3, 0), spec, {});
        FAIL() << "the base is 1.7 mm thick";
    } catch (const StateError& error) {
        EXPECT_NE(std::string(error.what()).find("the base has not ended"), std::string::npos);
    }
}

} // namespace
} // namespace suffuse::erosion
