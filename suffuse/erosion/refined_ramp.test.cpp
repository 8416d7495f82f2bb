// The ramp on curves that are known in closed form.

#include "suffuse/erosion/refined_ramp.hpp"

#include "suffuse/erosion/ramp.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace suffuse::erosion {
namespace {

struct Level {
    double gradient = 0, share = 0;
};

/// The levels that are kept where `share` of the mass moves at a gradient, and how many were borne.
struct Climbed {
    std::vector<Level> kept;
    int borne = 0;

    /// The step of the ramp that reaches it.
    [[nodiscard]] std::pair<Level, Level> reaching(double share) const {
        Level below;
        for (const Level& level : kept) {
            if (level.share >= share) {
                return {below, level};
            }
            below = level;
        }
        return {below, {INFINITY, 1}};
    }
};

Climbed climb(RefinedRamp ramp, const std::function<double(double)>& share) {
    Climbed climbed;
    while (const std::optional<double> gradient = ramp.next()) {
        ++climbed.borne;
        const double moved = share(*gradient);
        if (ramp.take(moved)) {
            climbed.kept.push_back({*gradient, moved});
        }
    }
    return climbed;
}

/// 1 % at `first`, 10 % at twice that, 50 % at 3.2 times.
std::function<double(double)> growing_from(double first) {
    return
        [=](double i) { return i < first ? 0 : std::min(1.0, 0.01 * std::pow(i / first, std::log(10) / std::log(2))); };
}

TEST(RefinedRamp, KnowsWhatMovesOneAndTenPercentToAHundredthWhateverStepsAreGiven) {
    for (const double first : {0.004, 0.013, 0.1499, 0.15, 0.31}) {
        for (const std::vector<double>& given :
             {even_gradients(1.2, 8), even_gradients(1.2, 16), even_gradients(1.2, 64),
              std::vector<double>{0.7, 100}}) {
            const Climbed climbed = climb({given, 1.1, {}}, growing_from(first));
            for (const auto& [share, gradient] : {std::pair{0.01, first}, {0.1, 2 * first}}) {
                const auto [below, above] = climbed.reaching(share);
                EXPECT_LT(below.gradient, gradient * (1 + 1e-12)) << first;
                EXPECT_GE(above.gradient, gradient * (1 - 1e-12)) << first;
                EXPECT_LE(above.gradient - below.gradient, gradient_width * (1 + 1e-9)) << first << " " << given.size();
            }
            const auto [below, above] = climbed.reaching(0.5);
            EXPECT_LE(above.gradient - below.gradient, widest_step * (1 + 1e-9)) << first;
        }
    }
}

TEST(RefinedRamp, RisesAndKeepsEveryLevelThatIsGiven) {
    const std::vector<double> given = even_gradients(1.2, 16);
    const Climbed climbed = climb({given, 1.1, {}}, growing_from(0.2));
    for (std::size_t k = 1; k < climbed.kept.size(); ++k) {
        EXPECT_LT(climbed.kept[k - 1].gradient, climbed.kept[k].gradient);
    }
    for (const double gradient : given) {
        EXPECT_TRUE(std::ranges::count(climbed.kept, gradient, &Level::gradient)) << gradient;
    }
}

TEST(RefinedRamp, BearsNoMoreThanABisectionNeeds) {
    const std::vector<double> given = even_gradients(1.2, 24); // steps of 0.05: three halvings, and both ends anew
    EXPECT_LE(climb({given, {}, {}}, growing_from(0.21)).borne, 24 + 2 * 5);
    EXPECT_EQ(climb({given, {}, {}}, [](double) { return 0; }).borne, 24);
}

TEST(RefinedRamp, HasNoWideStepUpToHeaveAndIsTheSameForAnyCoarserOne) {
    const auto nothing = [](double) { return 0; };
    const Climbed usual = climb({even_gradients(1.05, 21), 1.06, {}}, nothing);
    for (const std::vector<double>& given : {std::vector<double>{0.1, 100}, {0.3, 3}, {1.05, 2}, {0.1, 0.2, 0.9, 2}}) {
        const Climbed climbed = climb({given, 1.06, {}}, nothing);
        ASSERT_EQ(climbed.kept.size(), usual.kept.size() + 1) << "and what is beyond heave";
        for (std::size_t k = 0; k < usual.kept.size(); ++k) {
            EXPECT_EQ(climbed.kept[k].gradient, usual.kept[k].gradient);
        }
    }
    EXPECT_EQ(climb({{100}, {}, {}}, nothing).borne, 40) << "level flow: up to 2 in steps of 0.05, then at once";
}

TEST(RefinedRamp, IsLeftAloneWhereItsStepsAreFineEnough) {
    const std::vector<double> given = even_gradients(1.2, 120);
    EXPECT_EQ(climb({given, {}, {}}, growing_from(0.2)).borne, 120);
}

TEST(RefinedRamp, LooksJustBelowHeaveAndSeeksNothingBeyond) {
    const Climbed climbed = climb({{0.1, 100}, 1.087, {}}, [](double i) { return i > 1.05 ? 0.02 : 0; });
    ASSERT_EQ(climbed.kept.back().gradient, 100);
    EXPECT_EQ(climbed.kept[climbed.kept.size() - 2].gradient, 1.08);
    const Climbed late = climb({{0.1, 100}, 1.087, {}}, [](double i) { return i >= 1.087 ? 1 : 0; });
    EXPECT_EQ(late.borne, 23) << "21 up to 1.05, 1.08 and 100: heave comes first";
    EXPECT_EQ(late.kept[21].gradient, 1.08);
    EXPECT_EQ(climb({{0.1, 1.083, 2}, 1.087, {}}, [](double) { return 0; }).borne, 23) << "1.083 is near enough";
}

TEST(RefinedRamp, BearsTheSpecifiedGradient) {
    const auto nothing = [](double) { return 0; };
    EXPECT_EQ(climb({{0.1, 0.3}, {}, 0.22}, nothing).kept[4].gradient, 0.22);
    EXPECT_EQ(climb({{0.1, 0.3}, {}, 0.1}, nothing).borne, 6);
    EXPECT_EQ(climb({{0.1, 0.3}, {}, 0.4}, nothing).borne, 6) << "beyond the ramp";
}

TEST(RefinedRamp, GoesOnWhereALevelThatMovedTooMuchAtOnceMovesLessAfterOthers) {
    RefinedRamp ramp({0.05}, {}, {});
    EXPECT_FALSE(ramp.take(0.3)); // in one step from 0
    while (const std::optional<double> gradient = ramp.next()) {
        if (ramp.take(0.001) && *gradient == 0.05) { // after steps in between
            break;
        }
    }
    EXPECT_FALSE(ramp.next());
}

} // namespace
} // namespace suffuse::erosion
