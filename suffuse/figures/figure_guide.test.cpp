#include "suffuse/figures/figure_guide.hpp"

#include <gtest/gtest.h>

#include "tests/support/sample_results.hpp"

namespace suffuse::figures {
namespace {

TEST(FigureGuide, ExplainsEveryFigureThatAReportHas) {
    for (const Figure& figure : test::sample_figures()) {
        EXPECT_TRUE(explain_figure(figure.id)) << figure.id;
    }
    for (const std::string& name : figure_names()) {
        EXPECT_TRUE(explain_figure(name)) << name;
    }
}

TEST(FigureGuide, KnowsTheFigureOfOneStudyOrStage) {
    EXPECT_TRUE(explain_figure("own-paths-strength"));
    EXPECT_TRUE(explain_figure("own-triaxial-strength-sheared"));
    EXPECT_FALSE(explain_figure("own-pathsx"));
}

TEST(FigureGuide, KnowsAFigureByItsNumberHoweverItIsWritten) {
    const auto ninth = explain_figure("figure-9");
    ASSERT_TRUE(ninth);
    for (const char* name : {"9", "fig9", "fig09", "figure-09"}) {
        EXPECT_EQ(explain_figure(name), ninth) << name;
    }
    EXPECT_FALSE(explain_figure("figure-99"));
    EXPECT_FALSE(explain_figure("figure-"));
    EXPECT_FALSE(explain_figure(""));
}

} // namespace
} // namespace suffuse::figures
