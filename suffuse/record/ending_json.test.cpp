#include "suffuse/record/ending_json.hpp"

#include "suffuse/facts/ending_words.hpp"
#include "suffuse/record/earlier_endings.hpp"
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

PassResult read_pass(const json& pass) {
    return pass.get<PassResult>();
}

json written_pass(const Ending& ending) {
    PassResult pass;
    pass.verdict = ending;
    return pass;
}

TEST(EndingJson, HasItsNameItsNumbersToTheBitAndTheSentenceOfEarlierVersions) {
    for (const Ending& ending : endings()) {
        const json pass = written_pass(ending);
        EXPECT_EQ(pass.at("verdict"), facts::words_of(ending));
        EXPECT_EQ(pass.at("ended").is_null(), !ending);
        EXPECT_EQ(read_pass(pass).verdict, ending) << pass.at("ended");
        EXPECT_EQ(read_pass(json::from_cbor(json::to_cbor(pass))).verdict, ending) << pass.at("ended");
    }
    EXPECT_EQ(written_pass({NothingLeaves{}}).at("ended"), json({{"why", "nothing leaves"}}));
    EXPECT_EQ(
        written_pass({SkeletonRestless{400'050, 0.125}}).at("ended"),
        json({{"why", "skeleton restless"}, {"steps", 400'050}, {"carried", 0.125}})
    );
    const json doubted = written_pass({TargetReached{0.5, 0.25, ErodedTarget::Of::Solids, SkeletonDoubt{13, 0}}});
    EXPECT_EQ(
        doubted.at("ended"), json(
                                 {{"why", "target reached"},
                                  {"share", 0.5},
                                  {"asked", 0.25},
                                  {"of", "solids"},
                                  {"doubt", {{"coarse", 13}, {"width", 0}}}}
                             )
    );
}

TEST(EndingJson, IsReadWhateverTheSentenceNextToItSays) {
    for (const Ending& ending : endings()) {
        json pass = written_pass(ending);
        pass["verdict"] = "NOTHING LEAVES ANY MORE";
        EXPECT_EQ(read_pass(pass).verdict, ending) << pass.at("ended");
    }
}

TEST(EndingJson, OfALaterVersionIsReportedInItsSentence) {
    json pass = written_pass({NothingLeaves{}});
    pass.update({{"verdict", "the moon has set"}, {"ended", {{"why", "moon"}, {"hours", 3}}}});
    const Ending later{OtherWording{"the moon has set"}};
    EXPECT_EQ(read_pass(pass).verdict, later);
    EXPECT_EQ(written_pass(later).at("ended"), json({{"why", "told otherwise"}}));
    EXPECT_EQ(read_pass(written_pass(later)).verdict, later);
}

TEST(EarlierEndings, AreReadFromTheSentenceAlone) {
    const auto fines = ErodedTarget::Of::Fines, solids = ErodedTarget::Of::Solids;
    const std::string narrow = "the cell is only 4.0 coarse diameters wide (at least 5 wanted): the coarse skeleton "
                               "has lost its meaning";
    const std::string few = "the coarse skeleton has 13 grains left: too few for its constrictions to mean anything";
    const std::pair<std::string, Ending> pairs[] = {
        {"", {}},
        {"nothing leaves any more", {NothingLeaves{}}},
        {"what leaves cannot be told from the twin's noise", {NoiseDecides{}}},
        {few, {SkeletonDoubt{13, 0}}},
        {narrow, {SkeletonDoubt{0, 4}}},
        {"the skeleton fails: it does not carry its stresses any more and strained by more than 0.0001 %",
         {SkeletonFailed{0.0001 / 100}}},
        {"the skeleton fails: after 400050 steps under its stresses it is not at rest and carries 1.2e-05 % of them, "
         "or [balance] asks too much",
         {SkeletonRestless{400'050, 1.2e-5 / 100}}},
        {"12.3 % of the fines has left, 10 % was asked for", {TargetReached{12.3 / 100, 0.1, fines, {}}}},
        {"100 % of the solids has left, 100 % was asked for; " + few, {TargetReached{1, 1, solids, {{13, 0}}}}},
        {"75 % of the fines has left, 50 % was asked for; " + narrow, {TargetReached{0.75, 0.5, fines, {{0, 4}}}}},
        {"no grain is left to be removed after pass 3 of 10", {NoneToRemove{3, 10}}}};
    for (const auto& [sentence, ending] : pairs) {
        json pass = written_pass({});
        pass.erase("ended");
        pass["verdict"] = sentence;
        EXPECT_EQ(read_pass(pass).verdict, ending) << sentence;
    }
    const std::string other[] = {
        "nothing leaves", "coarse skeleton too small: 3 grains", "1e999 % of the moon",
        "12.3 % of the fines has left, 10 % was asked for; and more"};
    for (const std::string& sentence : other) {
        EXPECT_EQ(record::ending_of_sentence(sentence), Ending{OtherWording{sentence}});
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
