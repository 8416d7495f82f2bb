#include "suffuse/casefile/dependencies.hpp"

#include "suffuse/casefile/case_for_tests.hpp"

#include <gtest/gtest.h>

namespace {

using namespace suffuse;
using namespace suffuse::casefile;
using namespace suffuse::casefile::testing;

/// What the cloud of the first variant of `full_case`'s study "main" depends on, after a change of its soil.
template <class Change>
std::string after(Change change) {
    const Case c = load(full_case);
    Variant variant = c.studies[0].variants[0];
    change(*variant.soil);
    return dependencies_of(c, variant, variant.stages[0]);
}

TEST(Dependencies, ASampleDependsOnEveryNumberOfItsSoil) {
    const std::string as_it_is = after([](grains::Soil&) {});
    EXPECT_EQ(after([](grains::Soil&) {}), as_it_is);
    EXPECT_NE(after([](grains::Soil& soil) { soil.fines_content += 0.05; }), as_it_is);
    EXPECT_NE(after([](grains::Soil& soil) { soil.grading_tolerance += 0.001; }), as_it_is);
    EXPECT_NE(after([](grains::Soil& soil) { soil.report_kenney_lau = !soil.report_kenney_lau; }), as_it_is);
    EXPECT_NE(after([](grains::Soil& soil) { soil.coarse->diameter.back() *= 1.1; }), as_it_is);
    EXPECT_NE(after([](grains::Soil& soil) { soil.fines->passing.front() += 0.01; }), as_it_is);
}

TEST(Dependencies, OfAStageThatKeepsItsShearStressesAreThoseOfBeforeTheyCouldBeReleased) {
    const Case c = load(full_case);
    const Variant& variant = c.studies[0].variants[0];
    Stage compact = variant.stages[0], settle = compact;
    packing::CompactSpec to_pressure;
    dem::SettleSpec at_stress;
    at_stress.loading.axis.fill({cell::Control::Stress, 1e5});
    const auto describe = [&] {
        compact.spec = to_pressure, settle.spec = at_stress;
        return dependencies_of(c, variant, compact) + dependencies_of(c, variant, settle);
    };
    const std::string kept = describe();
    EXPECT_EQ(kept.find("shear_stresses"), std::string::npos);
    to_pressure.shear_released = true;
    const std::string one = describe();
    EXPECT_NE(one.find("shear_stresses = \"released\""), std::string::npos);
    at_stress.loading.shear_released = true;
    EXPECT_NE(describe(), one);
}

TEST(Dependencies, OnlyATestWhoseVoidsAreFullAndClosedDependsOnTheStiffnessOfTheWater) {
    Case compressible = load(full_case);
    Variant variant = compressible.studies[0].variants[0];
    Case incompressible = compressible;
    compressible.fluid.bulk_modulus = 2.2e9, incompressible.fluid.bulk_modulus.reset();
    Stage stage = variant.stages[0];
    const auto depends = [&](const StageSpec& spec) {
        stage.spec = spec;
        return dependencies_of(compressible, variant, stage) != dependencies_of(incompressible, variant, stage);
    };
    triaxial::TriaxialSpec drained, undrained;
    undrained.path = triaxial::Path::Undrained;
    EXPECT_TRUE(depends(undrained));
    EXPECT_TRUE(depends(triaxial::CyclicSpec{}));
    EXPECT_TRUE(depends(triaxial::StiffnessSpec{}));
    EXPECT_FALSE(depends(drained));
    EXPECT_FALSE(depends(triaxial::OedometerSpec{}));
    EXPECT_FALSE(depends(dem::SettleSpec{}));
}

} // namespace
