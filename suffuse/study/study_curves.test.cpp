#include "suffuse/study/study_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::study {
namespace {

TEST(StudyCurves, ScatterIsThatOfASampleAndLeavesOutMissingSeeds) {
    const Scatter three = scatter_of({1, 2, 6, std::nan("")});
    EXPECT_EQ(three.seeds, 3);
    EXPECT_DOUBLE_EQ(three.mean, 3);
    EXPECT_DOUBLE_EQ(three.standard_deviation, std::sqrt((4.0 + 1 + 9) / 2));
    EXPECT_EQ(three.of_seed.size(), 4U) << "seeds keep their places";
    EXPECT_EQ(scatter_of({5}).standard_deviation, 0);
    EXPECT_TRUE(std::isnan(scatter_of({}).mean));
}

TEST(StudyCurves, AScatterIsReportedWhereThereIsOne) {
    EXPECT_EQ(with_scatter(scatter_of({1, 2, 6})), "3 ± 2.6");
    EXPECT_EQ(with_scatter(scatter_of({0.1, 0.3}), 100, 2), "20 ± 14");
    EXPECT_EQ(with_scatter(scatter_of({-1, 1})), "0 ± 1.4");
    EXPECT_EQ(with_scatter(scatter_of({1.397, -1.603})), "−0.1 ± 2.1");
    EXPECT_EQ(with_scatter(scatter_of({0, 0})), "0");
    EXPECT_EQ(with_scatter(scatter_of({10, 10.001})), "10") << "below a thousandth";
    EXPECT_EQ(with_scatter(scatter_of({5, std::nan("")})), "5") << "of one seed there is none";
    EXPECT_EQ(with_scatter({}), "–");
}

} // namespace
} // namespace suffuse::study
