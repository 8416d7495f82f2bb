#include "suffuse/facts/ending_words.hpp"

#include <gtest/gtest.h>

namespace suffuse::facts {
namespace {

using namespace erosion;

TEST(EndingWords, AreThoseOfFilesAndWarnings) {
    const auto words = [](Ending ending) { return words_of(ending); };
    EXPECT_EQ(words({}), "");
    EXPECT_EQ(words({NothingLeaves{}}), "nothing leaves any more");
    EXPECT_EQ(words({NoiseDecides{}}), "the fines that leave cannot be distinguished from the twin's noise");
    EXPECT_EQ(
        words({SkeletonFailed{0.2}}),
        "the skeleton fails: it no longer carries its stresses and strained by more than 20 %"
    );
    EXPECT_EQ(
        words({SkeletonRestless{400'050, 0.0123}}),
        "the skeleton fails: after 400050 steps under its stresses it is not at rest and carries 1.23 % of them, or "
        "[balance] is too strict"
    );
    EXPECT_EQ(
        words({TargetReached{0.0512, 0.05, ErodedTarget::Of::Solids, SkeletonDoubt{13, 0}}}),
        "5.12 % of the solids has left, 5 % was specified; the coarse skeleton has 13 grains left: too few for "
        "meaningful constrictions"
    );
    EXPECT_EQ(
        words({SkeletonDoubt{120, 4.04}}),
        "the cell is only 4.0 coarse diameters wide (at least 5 required): the coarse skeleton is no longer meaningful"
    );
    EXPECT_EQ(words({NoneToRemove{3, 10}}), "no grain is left to be removed after pass 3 of 10");
}

} // namespace
} // namespace suffuse::facts
