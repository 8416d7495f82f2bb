// Layers: none reaches into another, each has the mass and the curve of its soil.

#include "suffuse/packing/stack.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/neighbors/pairs.hpp"
#include "suffuse/packing/compact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace suffuse::packing {
namespace {

grains::Soil band(double from, double to) {
    grains::Soil soil;
    soil.whole = grains::Grading{{from, to}, {0, 1}, ""};
    soil.grading_tolerance = 0.1;
    return soil;
}

/// A base of 0.2 mm below a filter of 0.6 mm, ratio D15/d85 about 2.9.
struct Stack {
    PackSpec spec{.porosity = stack_porosity, .layers = {{"base", 0.9e-3}, {"filter", 2e-3}}, .axis = 2, .width = 2e-3};
    std::vector<LayerSample> layers;

    Stack() {
        const std::vector<grains::Soil> soils{band(0.18e-3, 0.22e-3), band(0.54e-3, 0.66e-3)};
        for (std::size_t k = 0; k < soils.size(); ++k) {
            layers.push_back(sample_layer(soils[k], solid_of(spec.layers[k], *spec.width)));
        }
    }

    [[nodiscard]] Cloud make(std::uint64_t seed = 1) const { return make_stack(layers, spec, 2650, seed); }
};

TEST(Stack, DrawsEachLayerToItsMassAndItsCurve) {
    const Stack stack;
    for (std::size_t k = 0; k < stack.layers.size(); ++k) {
        const LayerSample& layer = stack.layers[k];
        const double wanted = 0.6 * 4e-6 * stack.spec.layers[k].thickness; // at a porosity of 0.4
        const double of_a_grain = wanted / static_cast<double>(layer.grains.radius.size());
        EXPECT_NEAR(layer.solid, wanted, 0.51 * of_a_grain);
        EXPECT_LE(layer.grains.largest_difference, 0.1);
    }
}

TEST(Stack, HasNoOverlapAndNoGrainBeyondTheInterface) {
    for (const int axis : {0, 2}) {
        Stack stack;
        stack.spec.axis = axis;
        const Cloud cloud = stack.make();
        const Mat3& h = cloud.cell.h;
        EXPECT_TRUE(neighbors::find_pairs(h, cloud.grains.position, cloud.grains.radius, 0.0).empty());
        const double length = h(axis, axis), interface = length * 0.9 / 2.9;
        EXPECT_NEAR(1 - grains::solid_volume(cloud.grains) / cell::volume(cloud.cell), 0.5, 0.01);
        for (std::size_t g = 0; g < cloud.grains.size(); ++g) {
            const double low = cloud.grains.position[g][axis] - cloud.grains.radius[g];
            const double high = cloud.grains.position[g][axis] + cloud.grains.radius[g];
            const bool is_base = cloud.grains.radius[g] < 0.2e-3;
            EXPECT_EQ(cloud.grains.fine[g], is_base ? 1 : 0);
            EXPECT_GE(low, (is_base ? 0 : interface) - 1e-12);
            EXPECT_LE(high, (is_base ? interface : length) + 1e-12);
        }
    }
}

TEST(Stack, HasTheSameBitsForTheSameSeedAndOthersForAnother) {
    const Stack stack;
    EXPECT_EQ(stack.make(1).grains.position, stack.make(1).grains.position);
    EXPECT_NE(stack.make(1).grains.position, stack.make(2).grains.position);
}

TEST(Stack, TooDenseForItsLayersIsRefusedWithAdvice) {
    Stack stack;
    stack.spec.porosity = 0.2;
    try {
        static_cast<void>(stack.make());
        FAIL() << "spheres are not that dense";
    } catch (const CaseError& error) {
        EXPECT_NE(std::string(error.what()).find("larger `porosity`"), std::string::npos);
    }
}

/// Compacted to 100 kPa.
dem::World compacted(const Stack& stack) {
    const Cloud cloud = stack.make();
    dem::World world;
    world.cell = cloud.cell;
    world.reference_h = cloud.cell.h;
    world.grains = cloud.grains;
    world.material.modulus = 1e9;
    CompactSpec spec;
    spec.pressure = 1e5;
    spec.protocol = Protocol::Wide;
    dem::StepCaches caches;
    const dem::BalanceSpec balance{.unbalanced_force = 1e-3, .stress_error = 1e-2, .patience = 100};
    CompactState state = begin_compaction(world, spec, dem::usual_damping);
    while (!compact_burst(world, caches, spec, balance, state)) {
    }
    return world;
}

TEST(Stack, CompactedAsOneStaysInLayersAndIsInEquilibrium) {
    const Stack stack;
    const int threads = thread_count();
    set_thread_count(1);
    const dem::World one = compacted(stack);
    set_thread_count(2);
    const dem::World two = compacted(stack);
    set_thread_count(threads);
    EXPECT_EQ(one.grains.position, two.grains.position);
    const Mat3 stress = dem::mean_stress_tensor(one);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(stress(axis, axis) / 1e5, 1, 0.02);
    }
    // From the plane that touches the filter first, base grains reach into its rough face, by less than a filter grain.
    constexpr double filter_diameter = 0.6e-3;
    const double length = one.cell.h(2, 2);
    double low = length, high = 0; // of filter grains
    for (std::size_t g = 0; g < one.grains.size(); ++g) {
        if (one.grains.fine[g] == 0) {
            low = std::min(low, one.grains.position[g].z - one.grains.radius[g]);
            high = std::max(high, one.grains.position[g].z + one.grains.radius[g]);
        }
    }
    const double middle = 0.5 * (low + high);
    double deepest = 0, deep = 0, base = 0;
    for (std::size_t g = 0; g < one.grains.size(); ++g) {
        if (one.grains.fine[g] != 0) {
            const double z = one.grains.position[g].z; // the base is around the origin, periodic
            const double depth = z < middle ? z - low : high - z;
            deepest = std::max(deepest, depth);
            base += one.grains.mass[g];
            deep += depth > 0.5 * filter_diameter ? one.grains.mass[g] : 0;
        }
    }
    EXPECT_LT(deepest, filter_diameter);
    EXPECT_LT(deep / base, 0.02);
}

} // namespace
} // namespace suffuse::packing
