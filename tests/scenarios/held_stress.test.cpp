// Which stresses an extraction of fines resettles under: those that the stage before it has left the sample with.

#include <gtest/gtest.h>

#include "tests/support/run_text.hpp"
#include <algorithm>

namespace suffuse::test {
namespace {

std::string stage(const std::string& name, const std::string& from, const std::string& keys) {
    return "[[study.s.stage]]\nname = \"" + name + "\"\nfrom = \"" + from + "\"\n" + keys;
}

/// Stress of an axis of the cell [Pa].
double axial(const nlohmann::json& stress, std::size_t axis) {
    return stress.at(axis).at(axis);
}

TEST(HeldStress, IsThatOfTheLastLoadingWhateverItControlled) {
    const std::string keeps_loose_fines = "do = \"remove\"\ngrains = \"inactive-fines\"\n";
    std::string text = reference_constants + reference_soil() + study_of_packing("packing500");
    text += stage(
        "sheared", "settled", "do = \"advance\"\nsteps = 2000\nstrain_rate = [\"0 1/s\", \"0 1/s\", \"20 1/s\"]\n"
    );
    text += stage("one-length", "settled", "do = \"settle\"\nstress = [\"150 kPa\", \"120 kPa\", \"-\"]\n");
    text += stage("constant-volume", "sheared", "do = \"settle\"\n");
    text += stage("triaxial", "sheared", "do = \"triaxial\"\nstrain = \"0.2 %\"\ninertial_number = \"loose\"\n");
    const std::vector<std::string> loadings{"sheared", "one-length", "constant-volume", "triaxial"};
    for (const std::string& loading : loadings) {
        text += stage("less-" + loading, loading, keeps_loose_fines);
    }
    const TempFolder folder;
    run_text(text, folder.path());
    for (const std::string& loading : loadings) {
        const nlohmann::json numbers = stage_of(folder.path(), "less-" + loading);
        const nlohmann::json &before = numbers.at("stress_before"), &after = numbers.at("stress_after");
        ASSERT_GT(std::max(axial(before, 2), axial(before, 0)), 1.1e5) << loading; // more than "settled" held
        for (std::size_t a = 0; a < 3; ++a) { // to the balance of the settling before, and that of the one after
            EXPECT_NEAR(axial(after, a), axial(before, a), 5e-3 * axial(before, 2)) << loading << ", axis " << a;
        }
        EXPECT_GT(numbers.at("time_step"), 0) << loading;
    }
}

} // namespace
} // namespace suffuse::test
