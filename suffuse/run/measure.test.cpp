#include "suffuse/run/measure.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::run {
namespace {

/// A drained test that holds 100 kPa, off by a share in every tenth row.
std::vector<triaxial::PathRow> rows_off_by(double share) {
    std::vector<triaxial::PathRow> rows(100);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k].axial_strain = 1e-3 * static_cast<double>(k);
        rows[k].deviator_stress = 60e3;
        rows[k].mean_stress = 20e3 + 100e3 * (k % 10 == 9 ? 1 + share : 1);
        rows[k].hold_error = k % 10 == 9 ? std::abs(share) : 0;
    }
    return rows;
}

TEST(WordsOnHold, SayHowFarTheLateralStressWasOff) {
    EXPECT_EQ(words_on_hold(rows_off_by(0.019), {.path = triaxial::Path::Drained}), "");
    const std::string words = words_on_hold(rows_off_by(0.15), {.path = triaxial::Path::Drained});
    EXPECT_NE(words.find("the lateral stress that the test holds is off by up to 15 %"), std::string::npos) << words;
    EXPECT_NE(words.find("take a smaller inertial_number"), std::string::npos) << words;
    EXPECT_EQ(words_on_hold(rows_off_by(0.15), {.path = triaxial::Path::Undrained}), "");
}

TEST(WordsOnHold, LeaveAStressThatWasLostToTheFlawOfIt) {
    EXPECT_EQ(words_on_hold(rows_off_by(-0.5), {.path = triaxial::Path::Drained}), "");
}

} // namespace
} // namespace suffuse::run
