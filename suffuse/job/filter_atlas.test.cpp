#include "suffuse/job/filter_atlas.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::job {
namespace {

using grains::Grading;

/// Straight over the logarithm of the size, with d15 and d85 as given [m].
Grading straight_curve(double d15, double d85) {
    const double factor = std::pow(d85 / d15, 1 / 0.70);
    return {{d15 / std::pow(factor, 0.15), d15 * std::pow(factor, 0.85)}, {0, 1}, "curve"};
}

atlas::FilterRow base_on_filter(double ratio, double width, double passed, bool ended = true) {
    atlas::FilterRow row;
    row.ratio = ratio, row.width = width, row.seed = 1, row.gradient = 5;
    row.passed = passed, row.ended = ended, row.moving = ended ? 0 : 0.1;
    return row;
}

const std::vector<atlas::FilterRow> few_filters = {
    base_on_filter(4, 1.2, 0), base_on_filter(8, 1.2, 0.4, false), base_on_filter(4, 2, 0.021),
    base_on_filter(8, 2, 0.3, false)};

std::string summary_for(double ratio, double width) {
    const double d85 = 0.2e-3;
    return summary_of(consult_filter_atlas(
        straight_curve(d85 / width, d85), straight_curve(ratio * d85, 1.2 * ratio * d85), few_filters
    ));
}

TEST(FilterAtlas, AnswersForBasesLikeTheSimulatedOnes) {
    EXPECT_EQ(
        summary_for(4, 1.2),
        "Simulated bases like this one (D15/d85 4, d85/d15 1.2): the filter holds: at i = 5, nothing "
        "passes, then motion ends."
    );
    EXPECT_EQ(
        summary_for(4, 2),
        "Simulated bases like this one (D15/d85 4, d85/d15 2): the filter holds after a loss: at i = 5, "
        "2.1 % passes, then motion ends."
    );
    EXPECT_NE(summary_for(8, 1.5).find("the filter lets the base pass: at i = 5, at least "), std::string::npos);
}

TEST(FilterAtlas, OutsideItNamesTheNearestAndSaysWhereThatIsNoAnswer) {
    const std::string wide = summary_for(4, 6), coarse = summary_for(12, 1.2), fine = summary_for(2, 1.2);
    EXPECT_EQ(
        wide,
        "No simulated base is like this one (D15/d85 4, d85/d15 6): the atlas of filters has D15/d85 of 4 to 8 and "
        "d85/d15 up to 2. Of the nearest (D15/d85 4, d85/d15 2) the filter holds after a loss: at i = 5, 2.1 % "
        "passes, then motion ends; that is no answer for yours."
    );
    EXPECT_NE(coarse.find("that is no answer for yours"), std::string::npos);
    EXPECT_EQ(fine.find("that is no answer for yours"), std::string::npos) << "a finer filter holds as well";
}

TEST(FilterAtlas, AFilterThatLetsItsBasePassSaysNothingOfAFinerOne) {
    for (const auto& row :
         {base_on_filter(4, 2, 0.065, false), base_on_filter(4, 2, 0.02, false), base_on_filter(4, 2, 0.3)}) {
        const std::string text =
            summary_of(consult_filter_atlas(straight_curve(0.1e-3, 0.19e-3), straight_curve(0.4e-3, 0.5e-3), {row}));
        EXPECT_NE(text.find("that is no answer for yours"), std::string::npos) << text;
    }
}

TEST(FilterAtlas, NamesWhatWasNotMeasured) {
    const Grading open = {{0.1e-3, 0.2e-3}, {0.3, 1}, "open"};
    const FilterAtlasAnswer answer = consult_filter_atlas(open, straight_curve(1e-3, 2e-3), few_filters);
    EXPECT_FALSE(answer.pair);
    EXPECT_NE(summary_of(answer).find("was not measured"), std::string::npos);
    EXPECT_TRUE(filter_atlas_json(answer).at("size_ratio").is_null());
    EXPECT_TRUE(filter_atlas_json(answer).at("gradients").empty());
}

TEST(FilterAtlas, TextHasALineForEachGradientAndItsLimits) {
    std::vector<atlas::FilterRow> rows = few_filters;
    rows.push_back(base_on_filter(4, 1.2, 0.01));
    rows.back().seed = 2;
    const FilterAtlasAnswer answer =
        consult_filter_atlas(straight_curve(0.2e-3 / 1.2, 0.2e-3), straight_curve(0.8e-3, 1e-3), rows);
    const std::string text = text_of(answer);
    EXPECT_NE(
        text.find("i = 5: 0.5 % passes, none moves at the end; 2 samples, standard deviation 0.7 %"), std::string::npos
    ) << text;
    EXPECT_NE(text.find("bears no load"), std::string::npos);
    const nlohmann::json about = filter_atlas_json(answer);
    EXPECT_EQ(about["gradients"][0]["samples"], 2);
    EXPECT_NEAR(about["gradients"][0]["passed"].get<double>(), 0.005, 1e-15);
    EXPECT_EQ(about["gradients"][0]["inside"], true);
}

} // namespace
} // namespace suffuse::job
