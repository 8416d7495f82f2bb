#include "suffuse/stability/size_classes.hpp"

#include <gtest/gtest.h>

namespace suffuse::stability {
namespace {

TEST(SizeClasses, SharesOfTheTwoSystemsAddUp) {
    const grains::Grading grading{
        {0.002e-3, 0.063e-3, 0.075e-3, 2e-3, 4.75e-3, 40e-3}, {0, 0.1, 0.12, 0.5, 0.7, 1}, ""};
    EXPECT_EQ(classes_text(astm_classes(grading)), "gravel 30 %, sand 58 %, fines 12 %");
    EXPECT_EQ(classes_text(iso_classes(grading)), "gravel 50 %, sand 40 %, silt 10 %");
    for (const auto& classes : {astm_classes(grading), iso_classes(grading)}) {
        double sum = 0;
        for (const SizeClass& one : classes) {
            sum += one.share.value();
        }
        EXPECT_NEAR(sum, 1, 1e-12);
    }
}

TEST(SizeClasses, AreUnknownBeyondWhatWasMeasured) {
    const grains::Grading open{{0.063e-3, 2e-3, 6.3e-3}, {0.04, 0.7, 0.9}, ""};
    EXPECT_EQ(classes_text(iso_classes(open)), "cobbles ?, gravel ?, sand 66 %, silt ?, clay ?");
}

} // namespace
} // namespace suffuse::stability
