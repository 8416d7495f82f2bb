// One fine grain in the pocket between three that touch: the closed forms of docs/theory/weight.md.

#include "suffuse/erosion/mobility.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/dem/step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace suffuse::erosion {
namespace {

constexpr double coarse_radius = 0.5e-3; // [m]

/// A fine grain above three coarse ones whose centers lie in a plane across z, one of them toward +x.
struct Pocket {
    dem::World world;
    double level = 0;  ///< of the fine grain's center above the plane [m]
    double center = 0; ///< from the middle of two coarse grains to the middle of all three [m]

    explicit Pocket(double size_ratio, double friction = 0) {
        const double R = coarse_radius, r = size_ratio * R, edge = 10 * R;
        level =
            std::sqrt(std::max((R + r) * (R + r) - 4 * R * R / 3, R * R / 4)); // or above a gap that it falls through
        center = R / std::sqrt(3.0);
        world.cell.h = diagonal({edge, edge, edge});
        world.material.friction = friction;
        world.material.rolling_stiffness = 0;
        for (const double angle : {0.0, 2 * pi / 3, 4 * pi / 3}) {
            const Vec3 outward{std::cos(angle), std::sin(angle), 0};
            add_grain(world.grains, Vec3{5 * R, 5 * R, 5 * R} + 2 * center * outward, R, world.material.density);
        }
        add_grain(world.grains, {5 * R, 5 * R, 5 * R + 1.0005 * level}, r, world.material.density);
        world.grains.fine = {0, 0, 0, 1};
    }
};

/// In units of the fine grain's weight, of which a gradient of 1 pulls with `unit` along the flow.
constexpr double unit = 100;

SolveFlow pull_along(const Pocket& pocket, const Vec3& direction, double pull = unit) {
    const std::vector<Vec3> weight = buoyant_weights(pocket.world, {}, {});
    return [=](const dem::World&) {
        UnitSeepage water;
        water.force.resize(weight.size());
        water.force[3] = pull * norm(weight[3]) * direction;
        return water;
    };
}

/// Steps of a hundredth of what theory says, from a tenth below it on.
std::vector<double> around(double theory) {
    std::vector<double> gradients;
    for (double share = 0.9; share < 1.1; share += 0.01) {
        gradients.push_back(share * theory / unit);
    }
    return gradients;
}

/// The pull along `direction` that moves the grain out of its pocket, over its weight.
double pull_that_moves(const Pocket& pocket, const Vec3& direction, std::vector<double> gradients) {
    const MobilitySetting setting{.direction = direction, .gradients = std::move(gradients)};
    return unit * find_mobility(pocket.world, setting, pull_along(pocket, direction)).mobile_gradient.front();
}

/// What is found is the first step above theory, or one or two later: a grain that barely moves is taken to rest.
void expect_just_above(double found, double theory) {
    EXPECT_GT(found, 0.995 * theory); // overlaps of a thousandth of the radius
    EXPECT_LT(found, 1.035 * theory);
}

TEST(Mobility, OfAGrainInAPocketNeedsItsWeightUpward) {
    for (const double ratio : {1.0, 0.3}) {
        expect_just_above(pull_that_moves(Pocket(ratio), {0, 0, 1}, around(1)), 1);
    }
}

TEST(Mobility, ReportsTheGradientThatItHolds) {
    const Pocket pocket(1);
    const MobilitySetting setting{.direction = {0, 0, 1}, .gradients = {0.001, 0.0025}};
    std::vector<std::string> parts;
    const Pulse note = [&](std::string_view part, long long) {
        if (parts.empty() || parts.back() != part) {
            parts.emplace_back(part);
        }
    };
    (void)find_mobility(pocket.world, setting, pull_along(pocket, setting.direction), note);
    EXPECT_EQ(parts, (std::vector<std::string>{"rest", "gradient 0.001, 1 of 2", "gradient 0.0025, 2 of 2"}));
}

TEST(Mobility, ShowsItsCurveAsItGoes) {
    const Pocket pocket(1);
    const MobilitySetting setting{.direction = {0, 0, 1}, .gradients = {0.9 / unit, 1.1 / unit}};
    std::size_t most_kept = 0;
    std::vector<MobilityStep> held;
    std::vector<std::vector<MobilityStep>> kept;
    const MobilityResult result = find_mobility(
        pocket.world, setting, pull_along(pocket, setting.direction), {},
        [&](std::span<const MobilityStep> ramp, const MobilityStep& step) {
            EXPECT_GE(ramp.size(), most_kept);
            most_kept = ramp.size();
            kept.emplace_back(ramp.begin(), ramp.end());
            held.push_back(step);
        }
    );
    ASSERT_FALSE(held.empty());
    EXPECT_EQ(most_kept + 1, result.ramp.size());
    for (std::size_t k = 0; k < most_kept; ++k) {
        EXPECT_EQ(kept.back()[k].gradient, result.ramp[k].gradient);
        EXPECT_EQ(kept.back()[k].mobile_mass_share, result.ramp[k].mobile_mass_share);
    }
    EXPECT_EQ(held.back().gradient, result.ramp.back().gradient);
    EXPECT_EQ(held.back().mobile_mass_share, 1); // the only fine grain has moved
    EXPECT_EQ(held.front().mobile_mass_share, 0);
}

TEST(Mobility, OfAGrainInAPocketIsNotReachedDownward) {
    EXPECT_TRUE(std::isnan(pull_that_moves(Pocket(1), {0, 0, -1}, {1 / unit, 2 / unit, 5 / unit, 10 / unit})));
}

TEST(Mobility, SiftingIsNotableAboveAHundredthOfTheFines) {
    EXPECT_FALSE(is_notable_sifting(0.0099));
    EXPECT_TRUE(is_notable_sifting(0.0101));
}

TEST(Mobility, IsNotReachedUnderARoofThatLeavesLessThanHalfADiameter) {
    for (const auto& [room, moves] : {std::pair{0.45, false}, std::pair{0.55, true}}) { // in diameters
        Pocket pocket(1);
        const double R = coarse_radius, roof = 5 * R + 2 * pocket.level + room * 2 * R;
        for (const double angle : {0.0, 2 * pi / 3, 4 * pi / 3}) {
            const Vec3 outward{std::cos(angle), std::sin(angle), 0};
            const Vec3 place = Vec3{5 * R, 5 * R, roof} + 2 * pocket.center * outward;
            add_grain(pocket.world.grains, place, R, pocket.world.material.density);
        }
        EXPECT_EQ(std::isnan(pull_that_moves(pocket, {0, 0, 1}, {2 / unit})), !moves) << room;
    }
}

TEST(Mobility, LiftsAGrainThatRisesByMoreThanATenthOfItsDiameter) {
    for (const auto& [room, lifted] : {std::pair{0.09, 0.0}, std::pair{0.11, 1.0}}) { // below a roof, in diameters
        Pocket pocket(1);
        const double R = coarse_radius, roof = 5 * R + 2 * pocket.level + room * 2 * R;
        for (const double angle : {0.0, 2 * pi / 3, 4 * pi / 3}) {
            const Vec3 outward{std::cos(angle), std::sin(angle), 0};
            const Vec3 place = Vec3{5 * R, 5 * R, roof} + 2 * pocket.center * outward;
            add_grain(pocket.world.grains, place, R, pocket.world.material.density);
        }
        const MobilitySetting setting{.direction = {0, 0, 1}, .gradients = {2 / unit}};
        const MobilityResult result = find_mobility(pocket.world, setting, pull_along(pocket, setting.direction));
        EXPECT_EQ(result.ramp.back().lifted_mass_share, lifted) << room;
        EXPECT_EQ(result.ramp.back().mobile_mass_share, 0);
    }
}

/// Coarse grains in a row, each with a fine grain of the same size that is pressed onto it: none of them moves.
dem::World pressed_fines(int count) {
    const double R = coarse_radius;
    dem::World world;
    world.cell.h = diagonal({10 * R, 10 * R, 10 * count * R});
    for (int k = 0; k < count; ++k) {
        const Vec3 place{3 * R, 5 * R, (5 + 10 * k) * R};
        add_grain(world.grains, place, R, world.material.density);
        add_grain(world.grains, place + Vec3{2 * R * (1 - 1e-4), 0, 0}, R, world.material.density);
        world.grains.fine.back() = 1;
    }
    dem::StepCaches caches;
    dem::step(world, caches, {.dt = 1e-12}); // finds the contacts
    return world;
}

TEST(Mobility, ComparesTheSeepageForceOfFinesWithTheirWeight) {
    const dem::World world = pressed_fines(21);
    const std::vector<Vec3> weight = buoyant_weights(world, {}, {});
    const SolveFlow solve = [&](const dem::World&) { // fines 1, 2 ... 21 times their weight, coarse grains 33 times
        UnitSeepage water;
        for (std::size_t g = 0; g < weight.size(); ++g) {
            const double pull = world.grains.fine[g] != 0 ? 0.5 * (static_cast<double>(g) + 1) : 33;
            water.force.push_back(Vec3{0, 0, pull * norm(weight[g])});
        }
        return water;
    };
    const MobilityResult result = find_mobility(world, {.direction = {0, 0, 1}, .gradients = {1e-4}}, solve);
    EXPECT_EQ(result.load_bearing_mass_share, 1);
    EXPECT_NEAR(*result.single_grain_gradient, 1.0 / 20, 1e-12) << "the second of 21: a twentieth of the way";
    EXPECT_NEAR(result.drag_share, 0.25, 1e-12) << "11 against 33";
    EXPECT_NEAR(*result.fines_heave_gradient, 2 * *result.heave_gradient, 1e-12)
        << "half of the mass, a quarter of the force";
    EXPECT_NEAR(*result.skempton_brogan_gradient, *result.alpha_fines * *result.heave_gradient, 1e-12);
    const MobilityResult inclined = find_mobility(world, {.direction = {0, 1, 1}, .gradients = {1e-4}}, solve);
    EXPECT_TRUE(inclined.heave_gradient);
    EXPECT_FALSE(inclined.skempton_brogan_gradient) << "their rule is of vertical flow";
}

TEST(Mobility, AcrossASaddleIsReachedAtTheSlopeOfTheWayToItWithAndWithoutFriction) {
    for (const double ratio : {1.0, 0.3}) {
        for (const double friction : {0.0, std::atan(0.5)}) {
            const Pocket pocket(ratio, friction);
            const double theory = pocket.center / pocket.level;
            expect_just_above(pull_that_moves(pocket, {-1, 0, 0}, around(theory)), theory);
        }
    }
}

TEST(Mobility, OverTheThirdGrainIsReachedAtTwiceThatSlope) {
    const Pocket pocket(1);
    const double theory = 2 * pocket.center / pocket.level;
    expect_just_above(pull_that_moves(pocket, {1, 0, 0}, around(theory)), theory);
}

TEST(Mobility, OverTheThirdGrainIsHeldBackByRollingFrictionAsAnAngle) {
    Pocket pocket(1, std::atan(0.5));
    pocket.world.material.rolling_stiffness = 7.5;
    pocket.world.material.rolling_friction = 0.22;
    const double theory = std::tan(std::atan(2 * pocket.center / pocket.level) + std::atan(0.22));
    expect_just_above(pull_that_moves(pocket, {1, 0, 0}, around(theory)), theory);
}

// The grain rolls in the wedge of the two that it passes between: half the angle of the wedge, and the shear springs
// that its rolling winds up there, raise what the rolling moments hold.
TEST(Mobility, AcrossASaddleIsHeldBackByRollingFrictionAsTheWedgesAngleRaisesIt) {
    Pocket pocket(1, radians(37));
    grains::Material& material = pocket.world.material;
    material.rolling_stiffness = 7.5;
    material.rolling_friction = 0.22;
    const double half_angle = std::asin(0.5); // R/(R + r)
    const double springs = material.shear_ratio * std::tan(half_angle) * std::sin(half_angle);
    const double held = std::atan(material.rolling_friction / (std::cos(half_angle) + springs));
    const double theory = std::tan(std::atan(pocket.center / pocket.level) + held);
    expect_just_above(pull_that_moves(pocket, {-1, 0, 0}, around(theory)), theory);
}

TEST(Mobility, DoesNotDependOnHowFarForcesAreScaledUp) {
    const Pocket pocket(1);
    const double theory = pocket.center / pocket.level;
    MobilitySetting setting{.direction = {-1, 0, 0}, .gradients = around(theory)};
    for (const double softness : {1e-3, 1e-4}) {
        setting.motion.softness = softness;
        const MobilityResult result = find_mobility(pocket.world, setting, pull_along(pocket, setting.direction));
        expect_just_above(unit * result.mobile_gradient.front(), theory);
    }
}

/// The gradient is the pull over the weight.
MobilityResult across_the_saddle(std::vector<double> gradients) {
    const Pocket pocket(1);
    const MobilitySetting setting{.direction = {-1, 0, 0}, .gradients = std::move(gradients)};
    return find_mobility(pocket.world, setting, pull_along(pocket, setting.direction, 1));
}

TEST(Mobility, IsFoundToAHundredthBetweenLevelsThatAreFarApart) {
    const Pocket pocket(1);
    const double theory = pocket.center / pocket.level;
    const MobilityResult found = across_the_saddle({0.1, 10}), fine = across_the_saddle(even_gradients(0.6, 60));
    EXPECT_NEAR(*found.moves_1, *fine.moves_1, gradient_width);
    EXPECT_GT(*found.moves_1, 0.995 * theory - gradient_width);
    EXPECT_LT(*found.moves_1, 1.035 * theory);
    EXPECT_FALSE(is_upper_bound(found, 0.01));
}

TEST(Mobility, IsThatOfTheLevelsThatWereKeptAlone) {
    const MobilityResult found = across_the_saddle({0.1, 10});
    std::vector<double> kept;
    for (const MobilityStep& step : found.ramp) {
        kept.push_back(step.gradient);
    }
    ASSERT_GT(kept.size(), 4U);
    const MobilityResult direct = across_the_saddle(kept);
    ASSERT_EQ(direct.ramp.size(), kept.size());
    EXPECT_LT(direct.ramp_steps, found.ramp_steps) << "nothing was undone";
    for (std::size_t k = 0; k < kept.size(); ++k) {
        EXPECT_EQ(direct.ramp[k].held_for, found.ramp[k].held_for) << kept[k];
        EXPECT_EQ(direct.ramp[k].still_moving, found.ramp[k].still_moving) << kept[k];
        EXPECT_EQ(direct.ramp[k].mobile_mass_share, found.ramp[k].mobile_mass_share) << kept[k];
        EXPECT_EQ(direct.ramp[k].lifted_mass_share, found.ramp[k].lifted_mass_share) << kept[k];
    }
    EXPECT_EQ(direct.mobile_gradient, found.mobile_gradient);
}

TEST(Mobility, ThatIsReachedAboveHeaveAloneIsNotReached) {
    const Pocket pocket(1);
    const MobilitySetting setting{.direction = {0, 0, 1}, .gradients = {0.01, 5}, .specified_gradient = 0.005};
    const MobilityResult found = find_mobility(pocket.world, setting, pull_along(pocket, setting.direction, 1));
    ASSERT_LT(*found.heave_gradient, 0.03);
    ASSERT_EQ(found.ramp.size(), 4U) << "what the soil has to bear, 0.01, just below heave, and 5";
    EXPECT_EQ(found.ramp[0].gradient, 0.005);
    EXPECT_EQ(found.ramp[2].gradient, 0.02);
    EXPECT_EQ(found.ramp[3].mobile_mass_share, 1);
    EXPECT_FALSE(found.moves_1);
    EXPECT_FALSE(factor_of_safety(found)->factor);
    EXPECT_NEAR(factor_of_safety(found)->at_least, 0.02 / 0.005, 1e-12);
}

TEST(Mobility, IsABoundWhereMotionHadNotEndedWhenTheGradientRose) {
    const Pocket pocket(1);
    MobilitySetting setting{.direction = {0, 0, 1}, .gradients = {0.5 / unit, 1.2 / unit, 2 / unit}};
    const MobilityResult held = find_mobility(pocket.world, setting, pull_along(pocket, setting.direction));
    EXPECT_EQ(held.ramp[1].mobile_mass_share, 1) << "it rises slowly, and is given the time";
    EXPECT_FALSE(is_still_growing(held.ramp[1]));
    EXPECT_GT(held.ramp[1].held_for, 4);
    setting.motion.hold_at_most = 4;
    const MobilityResult hasty = find_mobility(pocket.world, setting, pull_along(pocket, setting.direction));
    EXPECT_EQ(hasty.ramp[1].held_for, 4);
    EXPECT_EQ(hasty.ramp[1].mobile_mass_share, 0);
    EXPECT_TRUE(is_still_growing(hasty.ramp[1]));
    EXPECT_TRUE(is_lower_bound(hasty, 1.2 / unit));
    EXPECT_EQ(hasty.ramp[2].mobile_mass_share, 1);
    EXPECT_TRUE(is_upper_bound(hasty, 0.5));
}

TEST(Mobility, BeginsAsFarAlongTheFlowAsOneLikes) {
    const Pocket pocket(1);
    MobilitySetting setting{.direction = {0, 0, 1}, .gradients = {2 / unit}};
    for (const auto& [moved, mobile] : {std::pair{0.5, true}, {1e6, false}}) {
        setting.motion.moved = moved;
        const MobilityResult found = find_mobility(pocket.world, setting, pull_along(pocket, setting.direction));
        EXPECT_EQ(found.ramp.back().mobile_mass_share == 1, mobile) << moved;
    }
}

TEST(Mobility, OfAGrainWithoutAPocketIsSiftingUnderItsOwnWeight) {
    const Pocket pocket(0.15); // three that touch let through what is 6.46 times smaller
    const MobilityResult result =
        find_mobility(pocket.world, {.direction = {0, 0, 1}, .gradients = {0.5 / unit}}, pull_along(pocket, {0, 0, 1}));
    EXPECT_TRUE(result.sifts);
    EXPECT_EQ(result.sifting_mass_share, 1);
}

TEST(Mobility, OfAGrainThatBearsTheSkeletonsLoadIsNotNeeded) {
    Pocket pocket(1);
    pocket.world.grains.position[3].z -= 0.0006 * pocket.level; // pressed in, by far more than its weight
    dem::StepCaches caches;
    dem::step(pocket.world, caches, {.dt = 1e-12}); // finds the contacts
    const MobilitySetting setting{.direction = {0, 0, 1}, .gradients = {0.5 / unit, 2 / unit}};
    const MobilityResult result = find_mobility(pocket.world, setting, pull_along(pocket, setting.direction));
    EXPECT_EQ(result.load_bearing_mass_share, 1);
    EXPECT_EQ(result.ramp.back().mobile_mass_share, 0);
}

TEST(Mobility, GoesOnFromAnyLevelToTheSameBits) {
    const Pocket pocket(1);
    const MobilitySetting setting{.direction = {0, 0, 1}, .gradients = {0.5 / unit, 0.9 / unit, 2 / unit}};
    const SolveFlow solve = pull_along(pocket, setting.direction);
    const MobilityResult whole = find_mobility(pocket.world, setting, solve);
    MobilityRamp ramp = begin_ramp(pocket.world, setting, solve);
    while (!ramp.over) {
        const Pulse stop = [](std::string_view, long long) { throw std::runtime_error("stop"); };
        const std::size_t tried = ramp.tried.size();
        EXPECT_THROW(climb(ramp, setting, solve, stop), std::runtime_error);
        EXPECT_EQ(ramp.tried.size(), tried) << "as it was";
        ramp.water.reset(); // is not saved
        climb(ramp, setting, solve);
    }
    EXPECT_EQ(ramp.result.ramp.size(), whole.ramp.size());
    EXPECT_EQ(ramp.result.mobile_gradient, whole.mobile_gradient);
    EXPECT_EQ(ramp.result.ramp_steps, whole.ramp_steps);
    EXPECT_EQ(ramp.result.moves_10, whole.moves_10);
    EXPECT_GT(ramp.tried.size(), whole.ramp.size()) << "some were undone";
}

TEST(Mobility, HasTheSameBitsForAnyNumberOfThreads) {
    const Pocket pocket(1);
    const MobilitySetting setting{.direction = {-1, 0, 0}, .gradients = {0.2 / unit, 0.5 / unit}};
    std::vector<double> lifted;
    for (const int threads : {1, 2, 3}) {
        set_thread_count(threads);
        const MobilityResult result = find_mobility(pocket.world, setting, pull_along(pocket, setting.direction));
        lifted.push_back(static_cast<double>(result.ramp_steps) + result.mobile_gradient.front());
    }
    set_thread_count(1);
    EXPECT_EQ(lifted[0], lifted[1]);
    EXPECT_EQ(lifted[0], lifted[2]);
}

TEST(Mobility, NeedsFinesACoarseSkeletonAndARampThatRises) {
    Pocket pocket(1);
    const SolveFlow solve = pull_along(pocket, {0, 0, 1});
    EXPECT_THROW((void)find_mobility(pocket.world, {.gradients = {}}, solve), CaseError);
    EXPECT_THROW((void)find_mobility(pocket.world, {.gradients = {0.002, 0.001}}, solve), CaseError);
    EXPECT_THROW((void)find_mobility(pocket.world, {.gradients = {0, 0.001}}, solve), CaseError);
    EXPECT_THROW((void)find_mobility(pocket.world, {.direction = {0, 0, 0}, .gradients = {0.001}}, solve), CaseError);
    EXPECT_THROW((void)find_mobility(pocket.world, {.gradients = {0.9}}, solve), StateError); // heave comes before
    pocket.world.grains.fine = {0, 0, 0, 0};
    EXPECT_THROW((void)find_mobility(pocket.world, {.gradients = {0.001}}, solve), StateError);
    pocket.world.grains.fine = {1, 1, 1, 1};
    EXPECT_THROW((void)find_mobility(pocket.world, {.gradients = {0.001}}, solve), StateError);
}

TEST(Mobility, StepsAreFineWhereMostIsDecided) {
    EXPECT_EQ(gradients_up_to(0.03), std::vector<double>{0.03});
    const std::vector<double> ramp = gradients_up_to(1.2);
    ASSERT_EQ(ramp.size(), 16);
    EXPECT_NEAR(ramp[0], 0.05, 1e-15);
    EXPECT_NEAR(ramp[7], 0.4, 1e-15);
    EXPECT_NEAR(ramp[8], 0.5, 1e-15);
    EXPECT_EQ(ramp.back(), 1.2);
    EXPECT_EQ(even_gradients(1.2, 24).size(), 24);
    EXPECT_EQ(even_gradients(1.2, 24).back(), 1.2);
}

} // namespace
} // namespace suffuse::erosion
