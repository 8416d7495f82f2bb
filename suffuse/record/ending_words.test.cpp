#include "suffuse/record/ending_words.hpp"

#include "suffuse/record/result_json.hpp"

#include <gtest/gtest.h>

namespace {

using namespace suffuse;
using namespace suffuse::erosion;
using nlohmann::json;

/// With numbers that words round.
std::vector<Ending> endings() {
    const SkeletonDoubt few{13, 0}, narrow{120, 4.04};
    const auto fines = ErodedTarget::Of::Fines, solids = ErodedTarget::Of::Solids;
    return {
        {},
        {NothingLeaves{}},
        {NoiseDecides{}},
        {few},
        {narrow},
        {SkeletonFailed{0.2}},
        {SkeletonFailed{1e-6}},
        {SkeletonRestless{3'000'000, 0.98765}},
        {SkeletonRestless{400'050, 1.2e-7}},
        {TargetReached{0.123456, 0.1, fines, {}}},
        {TargetReached{1, 1, solids, few}},
        {TargetReached{0.99996, 0.3, fines, narrow}},
        {NoneToRemove{3, 10}}};
}

TEST(EndingWords, AreThoseOfFilesAndWarnings) {
    const auto told = [](Ending ending) { return record::words_of(ending); };
    EXPECT_EQ(told({}), "");
    EXPECT_EQ(told({NothingLeaves{}}), "nothing leaves any more");
    EXPECT_EQ(told({NoiseDecides{}}), "what leaves cannot be told from the twin's noise");
    EXPECT_EQ(
        told({SkeletonFailed{0.2}}),
        "the skeleton fails: it does not carry its stresses any more and strained by more than 20 %"
    );
    EXPECT_EQ(
        told({SkeletonRestless{400'050, 0.0123}}),
        "the skeleton fails: after 400050 steps under its stresses it is not at rest and carries 1.23 % of them, or "
        "[balance] asks too much"
    );
    EXPECT_EQ(
        told({TargetReached{0.0512, 0.05, ErodedTarget::Of::Solids, SkeletonDoubt{13, 0}}}),
        "5.12 % of the solids has left, 5 % was asked for; the coarse skeleton has 13 grains left: too few for its "
        "constrictions to mean anything"
    );
    EXPECT_EQ(
        told({SkeletonDoubt{120, 4.04}}),
        "the cell is only 4.0 coarse diameters wide (at least 5 wanted): the coarse skeleton has lost its meaning"
    );
    EXPECT_EQ(told({NoneToRemove{3, 10}}), "no grain is left to be removed after pass 3 of 10");
}

TEST(EndingWords, ReadBackAreTheSameWordsOfTheSameKind) {
    for (const Ending& ending : endings()) {
        const std::string words = record::words_of(ending);
        const Ending again = record::ending_told(words);
        EXPECT_EQ(again.why.index(), ending.why.index()) << words;
        EXPECT_EQ(record::words_of(again), words);
    }
}

TEST(EndingWords, OfAnotherVersionAreKeptAsTheyAre) {
    for (const std::string words : {"nothing leaves", "coarse skeleton too small: 3 grains", "1e999 % of the moon"}) {
        const Ending ending = record::ending_told(words);
        EXPECT_TRUE(std::holds_alternative<ToldOtherwise>(ending.why));
        EXPECT_TRUE(ending);
        EXPECT_EQ(record::words_of(ending), words);
    }
}

TEST(ResultJson, WordsOfAnErosionAreThoseOfItsFiles) {
    ErosionResult erosion;
    erosion.passes.emplace_back().verdict = {NothingLeaves{}};
    erosion.passes.emplace_back();
    for (const Phase phase : {Phase::Removal, Phase::ConstantVolume, Phase::Servo}) {
        erosion.path.emplace_back().phase = phase;
    }
    const auto reasons = {Reason::Velocity, Reason::Displacement,  Reason::Forced,
                          Reason::Removed,  Reason::RemovedActive, Reason::RemovedInactive};
    for (const Reason reason : reasons) {
        erosion.ledger.emplace_back().reason = reason;
    }
    const json written = erosion;
    EXPECT_EQ(written["passes"][0]["verdict"], "nothing leaves any more");
    EXPECT_EQ(written["passes"][1]["verdict"], "");
    const char* const phases[] = {"removal", "constant volume", "servo"};
    const char* const words[] = {"velocity", "displacement", "forced", "removed", "removed active", "removed inactive"};
    for (std::size_t k = 0; k < std::size(phases); ++k) {
        EXPECT_EQ(written["path"][k]["phase"], phases[k]);
    }
    for (std::size_t k = 0; k < std::size(words); ++k) {
        EXPECT_EQ(written["ledger"][k]["reason"], words[k]);
    }
    EXPECT_EQ(json(written.get<ErosionResult>()), written);
}

TEST(ResultJson, ReasonsOfEarlierRunsAreKnown) {
    EXPECT_EQ(json("removed, inactive").get<Reason>(), Reason::RemovedInactive);
    EXPECT_EQ(json("removed, active").get<Reason>(), Reason::RemovedActive);
}

} // namespace
