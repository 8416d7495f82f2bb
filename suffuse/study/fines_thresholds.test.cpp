#include "suffuse/study/fines_thresholds.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::study {
namespace {

ContentCurve curve_of(std::vector<double> content, std::vector<std::vector<double>> value) {
    ContentCurve curve{std::move(content), {}, std::move(value)};
    for (std::size_t s = 0; s < curve.value.size(); ++s) {
        curve.seed.push_back(s + 1);
    }
    return curve;
}

TEST(FinesThresholds, AParabolaHasItsVertexWhereItIsOnAnyGrid) {
    const std::vector<double> content{0, 0.1, 0.2, 0.35, 0.4, 0.6, 1};
    std::vector<double> value;
    for (const double x : content) {
        value.push_back(0.5 + 2 * (x - 0.37) * (x - 0.37));
    }
    const Extreme found = find_extreme(curve_of(content, {value}), 0, Which::Lowest).value();
    EXPECT_EQ(found.at, 0.35);
    EXPECT_NEAR(found.vertex, 0.37, 1e-12);
    EXPECT_EQ(found.least, 0.2);
    EXPECT_EQ(found.most, 0.4);
    EXPECT_FALSE(found.is_end);
}

TEST(FinesThresholds, TheVertexStaysBetweenTheNeighborsAndMissingSamplesAreLeftOut) {
    const double missing = std::nan("");
    const ContentCurve curve = curve_of({0, 0.2, 0.3, 0.4, 0.6}, {{0.8, 0.6, missing, 0.6, 0.9}, {3, 2, 1, 0.5, 0.1}});
    const Extreme flat = find_extreme(curve, 0, Which::Lowest).value();
    EXPECT_EQ(flat.at, 0.2);
    EXPECT_GT(flat.vertex, 0.2);
    EXPECT_LT(flat.vertex, 0.4);
    EXPECT_TRUE(find_extreme(curve, 1, Which::Lowest)->is_end);
    EXPECT_EQ(find_extreme(curve, 1, Which::Highest)->at, 0);
    EXPECT_FALSE(find_extreme(curve_of({0, 1}, {{1, 2}}), 0, Which::Lowest));
}

TEST(FinesThresholds, TwoStraightLinesBreakWhereTheyMeetAndAPlateauDoesNotCount) {
    const std::vector<double> content{0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.6, 0.8, 1};
    std::vector<double> value;
    for (const double x : content) {
        value.push_back(std::min(0.97, 0.02 + 0.1 * x + 5 * std::max(0.0, x - 0.22)));
    }
    // The search looks at 401 places between 10 and 35 %.
    EXPECT_NEAR(find_onset(curve_of(content, {value}), 0).value(), 0.22, 0.25 / 400);
}

TEST(FinesThresholds, ACurveThatOnlyBendsDownHasNoOnset) {
    EXPECT_FALSE(find_onset(curve_of({0, 0.1, 0.2, 0.3, 0.4}, {{0, 0.4, 0.6, 0.7, 0.75}}), 0));
    EXPECT_FALSE(find_onset(curve_of({0, 0.1, 0.2, 0.3, 0.4, 0.5}, {{0, 0.1, 0.2, 0.3, 0.6, 0.9}}), 0))
        << "it only steepens";
    EXPECT_FALSE(find_onset(curve_of({0, 0.1, 0.2}, {{0, 0.1, 0.6}}), 0)) << "too few points";
}

TEST(FinesThresholds, ABreakThatCouldBeAnywhereNextToAnEndCannotBeLocated) {
    const std::vector<double> content{0, 0.1, 0.2, 0.3, 0.4, 0.6};
    const auto broken_at = [&](double onset) {
        std::vector<double> value;
        for (const double x : content) {
            value.push_back(0.02 + std::max(0.0, x - onset));
        }
        return find_onset(curve_of(content, {value}), 0);
    };
    EXPECT_FALSE(broken_at(0.1)) << "at any place up to 10 % the first line goes through the first point";
    EXPECT_FALSE(broken_at(0.05));
    EXPECT_FALSE(broken_at(0.4)) << "at any place up to 60 % the second line goes through the last point";
    EXPECT_FALSE(broken_at(0.5));
    EXPECT_NEAR(broken_at(0.15).value(), 0.15, 0.3 / 400); // two points before it decide
    EXPECT_NEAR(broken_at(0.35).value(), 0.35, 0.3 / 400); // two points behind it decide
}

TEST(FinesThresholds, CurvesFollowSeedsAndNotTheirPlaces) {
    StageCurve stage{"loose", {}};
    SweepPoint both, one;
    both.value = {0};
    both.seed = {7, 8};
    both.number["e"] = scatter_of({1, 2});
    one.value = {0.5};
    one.seed = {8}; // the sample of seed 7 failed
    one.number["e"] = scatter_of({3});
    stage.points = {both, one};
    const ContentCurve curve = content_curve(stage, "e");
    EXPECT_EQ(curve.seed, (std::vector<std::uint64_t>{7, 8}));
    EXPECT_EQ(value_at(curve, 0, 0), 1);
    EXPECT_FALSE(value_at(curve, 0, 0.5));
    EXPECT_EQ(value_at(curve, 1, 0.5), 3);
    EXPECT_TRUE(std::isnan(content_curve(stage, "none").value[0][0]));
}

TEST(FinesThresholds, BetweenLooseAndDenseTheThresholdMovesWithTheDensity) {
    const std::vector<double> content{0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
    StageCurve loose{"loose", {}}, dense{"dense", {}};
    for (const double x : content) {
        SweepPoint point;
        point.value = {x};
        point.seed = {1, 2};
        // Parabolas of equal curvature: the blend of two of them has its vertex at the blend of theirs.
        const auto at = [&](double vertex) {
            return scatter_of({(x - vertex) * (x - vertex), (x - vertex - 0.02) * (x - vertex - 0.02)});
        };
        point.number["void_ratio"] = at(0.4);
        loose.points.push_back(point);
        point.number["void_ratio"] = at(0.24);
        dense.points.push_back(point);
    }
    const std::vector<ContentThreshold> thresholds = find_thresholds(loose, &dense);
    ASSERT_EQ(thresholds.size(), 7U);
    const std::vector<double> expected{0.41, 0.37, 0.33, 0.29, 0.25}; // means of the two seeds
    for (std::size_t k = 0; k < expected.size(); ++k) {
        EXPECT_EQ(thresholds[k].name(), "FC_threshold");
        EXPECT_NEAR(thresholds[k].at.mean, expected[k], 1e-12);
        EXPECT_NEAR(thresholds[k].at.standard_deviation, 0.02 / std::sqrt(2), 1e-12);
    }
    EXPECT_EQ(thresholds[5].name(), "FC_active");
    EXPECT_EQ(thresholds[5].at.seeds, 0) << "no such numbers in these curves";
    EXPECT_EQ(find_thresholds(loose, nullptr).size(), 3U);
}

TEST(FinesThresholds, ALowestPointWithOneFarNeighborIsNoThreshold) {
    const auto threshold = [](std::vector<double> content) {
        StageCurve loose{"loose", {}};
        for (const double x : content) {
            SweepPoint point;
            point.value = {x};
            point.seed = {1};
            point.number["void_ratio"] = scatter_of({(x - 0.35) * (x - 0.35)});
            loose.points.push_back(point);
        }
        return find_thresholds(loose, nullptr).front().at;
    };
    EXPECT_EQ(threshold({0, 0.1, 0.2, 0.3, 1}).seeds, 0) << "the parabola's vertex would follow the last point";
    EXPECT_NEAR(threshold({0, 0.1, 0.2, 0.3, 0.6}).mean, 0.35, 1e-12);
}

TEST(FinesThresholds, AnOnsetBeforeTwoPointsFarFromEachOtherIsNone) {
    const auto onset = [](std::vector<double> content) {
        ContentCurve curve{std::move(content), {1}, {{}}};
        for (const double x : curve.content) {
            curve.value[0].push_back(std::max(0.08 - 0.1 * x, x - 0.2));
        }
        return find_onset(curve, 0);
    };
    EXPECT_FALSE(onset({0.1, 0.2, 0.3, 1})) << "it may as well lie between the last two";
    EXPECT_NEAR(onset({0.1, 0.2, 0.3, 0.6}).value_or(0), 0.28 / 1.1, 1e-3); // of the 400 breaks that are tried
}

} // namespace
} // namespace suffuse::study
