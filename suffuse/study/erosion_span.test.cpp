#include "suffuse/study/erosion_span.hpp"

#include <gtest/gtest.h>

namespace suffuse::study {
namespace {

erosion::ErosionResult passes_at(const std::vector<double>& gradients) {
    erosion::ErosionResult erosion;
    for (const double gradient : gradients) {
        erosion::PassResult& pass = erosion.passes.emplace_back();
        pass.pass = static_cast<int>(erosion.passes.size());
        pass.probe.gradient = gradient;
    }
    return erosion;
}

TEST(ErosionSpan, HasTheGradientsOfAllPassesAndStages) {
    EXPECT_FALSE(span_of({}));
    const erosion::ErosionResult first = passes_at({0.5, 0.1}), second = passes_at({1});
    EXPECT_EQ(span_of({&first})->gradients(), "0.1 to 0.5");
    const ErosionSpan chain = *span_of({&first, &second});
    EXPECT_EQ(chain.gradients(), "0.1 to 1");
    EXPECT_EQ(chain.fewest_passes, 3);
    EXPECT_EQ(span_of({&second})->gradients(), "1");
    const ErosionSpan both = joined(chain, *span_of({&second}));
    EXPECT_EQ(both.fewest_passes, 1);
    EXPECT_EQ(both.most_passes, 3);
}

TEST(ErosionSpan, APassByForceHasNoGradient) {
    erosion::ErosionResult erosion = passes_at({0.1, 0.5});
    erosion.ledger.push_back({.pass = 2, .reason = erosion::Reason::Forced});
    const ErosionSpan span = *span_of({&erosion});
    EXPECT_TRUE(span.has_forced);
    EXPECT_FALSE(span.is_by_force());
    EXPECT_EQ(span.gradients(), "0.1");
    erosion.ledger.push_back({.pass = 1, .reason = erosion::Reason::Forced});
    EXPECT_TRUE(span_of({&erosion})->is_by_force());
}

TEST(ErosionSpan, KnowsWhichOfItsPermeabilitiesAreTooHigh) {
    erosion::ErosionResult erosion = passes_at({0.1, 0.1});
    erosion.passes.front().flow_after.raised_by_fines = 1.2;
    EXPECT_FALSE(span_of({&erosion})->after_is_too_high) << "the first pass does not end the erosion";
    erosion.passes.front().probe.flow.raised_by_fines = 1.2;
    EXPECT_TRUE(span_of({&erosion})->before_is_too_high);
    erosion.passes.back().flow_after.raised_by_fines = 1.2;
    EXPECT_TRUE(span_of({&erosion})->after_is_too_high);
}

} // namespace
} // namespace suffuse::study
