#include "suffuse/answer/mobility_words.hpp"

#include "suffuse/answer/mobility_headlines.hpp"
#include "suffuse/answer/mobility_remarks.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace suffuse::answer {
namespace {

using study::MobilityStory;

erosion::MobilityResult upward() {
    erosion::MobilityResult mobility;
    mobility.down = {0, 0, -1};
    mobility.direction = {0, 0, 1};
    mobility.heave_gradient = 1.05;
    mobility.alpha_fines = 0.2;
    mobility.skempton_brogan_gradient = 0.21;
    mobility.fines_heave_gradient = 0.8;
    mobility.ramp = {
        {.gradient = 0.2, .mobile_mass_share = 0.002, .leaving_mass_share = 0.001},
        {.gradient = 1.2, .mobile_mass_share = 0.2, .leaving_mass_share = 0.1}};
    mobility.moves_1 = 0.3, mobility.moves_10 = 0.51;
    mobility.specified_gradient = 0.2;
    mobility.id = {1}, mobility.mass = {1}, mobility.diameter = {1}, mobility.mobile_gradient = {0.3};
    mobility.bears_load = {0};
    return mobility;
}

/// Two stages of a study, of the given mobilities.
std::vector<MobilityStory> story_of(const std::vector<erosion::MobilityResult>& samples) {
    static casefile::Study study;
    study.name = "dam", study.replicates = static_cast<int>(samples.size());
    static const casefile::Variant variant;
    static const casefile::Stage stage{.name = "mobility", .spec = erosion::DetachStageSpec{}};
    static std::vector<record::FinishedStage> stages;
    stages.clear();
    for (const erosion::MobilityResult& mobility : samples) {
        stages.push_back({&study, &variant, &stage, nlohmann::json::object(), {}});
        stages.back().findings.mobility = mobility;
    }
    return study::gather_mobility(stages);
}

TEST(MobilityWords, GiveTheVerdictThatAnEngineerNeeds) {
    EXPECT_EQ(
        verdict(story_of({upward()}).front()),
        "Upward flow moves 1 % of the fines at i = 0.30, a tenth at 0.51; the "
        "soil heaves at 1.05. At the specified 0.20 it "
        "moves 0.2 % (factor of safety 1.5 before 1 % move half a diameter; one sample)."
    );
}

TEST(MobilityWords, OpenWithTwoShortLinesAndCardsThatKnowTheirStep) {
    const MobilityStory story = story_of({upward()}).front();
    EXPECT_EQ(
        short_verdict(story),
        (std::vector<std::string>{
            "Upward flow moves 1 % of the fines at i = 0.30, a tenth at 0.51; the soil heaves at 1.05.",
            "At the specified 0.20 it moves 0.2 %: factor of safety 1.5 before 1 % move half a diameter."})
    );
    const std::vector<Headline> cards = mobility_headlines(story);
    ASSERT_EQ(cards.size(), 4U);
    EXPECT_EQ(cards[0].value, "1.5");
    EXPECT_EQ(cards[1].value, "0.30");
    EXPECT_EQ(cards[1].spread, "± 0.50") << "half of the ramp's step from 0.2 to 1.2";
    EXPECT_NE(cards[3].detail.find("no replicate"), std::string::npos);
    EXPECT_TRUE(cards[0].caution.empty()) << cards[0].caution;
}

TEST(MobilityWords, ReportTheSharesByOtherMeasuresOfMotion) {
    erosion::MobilityResult caged = upward();
    caged.ramp.front().displaced_mass_share = 0.089, caged.ramp.front().lifted_mass_share = 0.12;
    const std::vector<std::string> remarks = remarks_on(story_of({caged}).front());
    EXPECT_EQ(
        remarks.front(), "The result depends on the definition of movement: at i = 0.20, 0.2 % of the mass moved half "
                         "a diameter along the flow, "
                         "8.9 % half a diameter in any direction, 12 % a tenth of one along it."
    );
    EXPECT_EQ(
        remarks_on(story_of({upward()}).front()).front().find("The result depends on the definition"), std::string::npos
    );
}

TEST(MobilityWords, ReportADisagreementOfRuleAndMotionInTheOpeningAndAtTheNumber) {
    erosion::MobilityResult carried = upward();
    carried.skempton_brogan_gradient = 0.14; // below the specified 0.20, while 1 % moves at 0.30
    const MobilityStory story = story_of({carried}).front();
    EXPECT_NE(
        disagreement(story).value_or("").find("is below the specified 0.20 and calls it unstable"), std::string::npos
    );
    EXPECT_NE(mobility_headlines(story).front().caution.find("gives 0.7"), std::string::npos);
    EXPECT_FALSE(disagreement(story_of({upward()}).front()));
}

TEST(MobilityWords, SayAtTheFactorOfSafetyThatTheSoilHeavesBefore) {
    erosion::MobilityResult late = upward();
    late.moves_1 = 1.1;
    EXPECT_NE(
        mobility_headlines(story_of({late}).front()).front().caution.find("heaves before, at 5.2 times"),
        std::string::npos
    );
}

TEST(MobilityWords, SayWhatIsKnownWhereTheRampEndsBefore) {
    erosion::MobilityResult still = upward();
    still.moves_1.reset(), still.moves_10.reset();
    still.ramp.back().mobile_mass_share = 0.004;
    const std::string reported = verdict(story_of({still}).front());
    EXPECT_NE(
        reported.find("moves less than 1 % of the fines below heave; the soil heaves at 1.05 first."), std::string::npos
    ) << reported;
    EXPECT_NE(reported.find("factor of safety at least 1.0"), std::string::npos)
        << reported << ": what is borne below heave";
    const Headline card = mobility_headlines(story_of({still}).front()).front();
    EXPECT_NE(card.detail.find("the soil heaves before 1 %"), std::string::npos) << card.detail;
    EXPECT_NE(card.caution.find("heaves before"), std::string::npos) << card.caution;
}

TEST(MobilityWords, BoundTheFactorOfSafetyByAllSamplesAlsoByThoseThatMoved) {
    erosion::MobilityResult still = upward(), moved = upward();
    still.moves_1.reset(), still.moves_10.reset();
    still.ramp.back().mobile_mass_share = 0.004;
    moved.moves_1 = 0.75 * *moved.specified_gradient;
    const study::MobilityStory story = story_of({still, moved, still}).front();
    EXPECT_NEAR(*story.safety_at_least, 0.75, 1e-12) << "less than the bound of the others";
    const Headline card = mobility_headlines(story).front();
    EXPECT_EQ(card.value, "≥ 0.7") << "rounding does not raise it";
    EXPECT_NE(card.detail.find("the least of three samples, of which one moves 1 % before"), std::string::npos)
        << card.detail;
}

TEST(MobilityWords, SayWhichGradientsAndSharesAreBounds) {
    erosion::MobilityResult creeping = upward();
    creeping.ramp = {
        {.gradient = 0.2, .mobile_mass_share = 0.002, .still_moving = 0.1},
        {.gradient = 0.31, .mobile_mass_share = 0.02},
        {.gradient = 0.5, .mobile_mass_share = 0.09},
        {.gradient = 0.51, .mobile_mass_share = 0.11}};
    EXPECT_EQ(
        verdict(story_of({creeping}).front()),
        "Upward flow moves 1 % of the fines at i = 0.30 or less, a tenth at "
        "0.51; the soil heaves at 1.05. At the specified "
        "0.20 it moves at least 0.2 % (factor of safety 1.5 before 1 % move half a diameter; one sample)."
    );
    const std::vector<Headline> cards = mobility_headlines(story_of({creeping}).front());
    EXPECT_EQ(cards[1].value, "≤ 0.30");
    EXPECT_EQ(cards[2].value, "0.51");
    EXPECT_EQ(cards[2].spread, "± 0.01") << "half of a step of 0.01, rounded up";
}

TEST(MobilityWords, OfSeveralSamplesGiveMeanAndDeviation) {
    erosion::MobilityResult other = upward();
    other.moves_1 = 0.4;
    const std::string reported = verdict(story_of({upward(), other}).front());
    EXPECT_NE(reported.find("i = 0.35 ± 0.07"), std::string::npos) << reported;
    EXPECT_NE(reported.find("2 samples"), std::string::npos) << reported;
}

TEST(MobilityWords, KnowTheWayOfTheFlow) {
    erosion::MobilityResult mobility = upward();
    for (const auto& [direction, word] :
         {std::pair{Vec3{0, 0, -1}, "Downward"}, {Vec3{0, 1, 0}, "Level"}, {Vec3{0.6, 0, 0.8}, "Oblique"}}) {
        mobility.direction = direction;
        EXPECT_EQ(flow_in_words(mobility), word);
    }
    mobility.direction = {1, 0, 0};
    mobility.heave_gradient.reset();
    const std::string reported = verdict(story_of({mobility}).front());
    EXPECT_NE(reported.find("it cannot lift the soil"), std::string::npos) << reported;
}

TEST(MobilityWords, SayWhyStressAndMotionDiffer) {
    const auto first = [](const erosion::MobilityResult& mobility) {
        return remarks_on(story_of({mobility}).front()).front();
    };
    EXPECT_NE(first(upward()).find("below the gradient that moves 1 %"), std::string::npos) << first(upward());
    erosion::MobilityResult carried = upward();
    carried.alpha_fines = 0.9, carried.skempton_brogan_gradient = 0.95;
    EXPECT_NE(first(carried).find("above the gradient that moves 1 %"), std::string::npos) << first(carried);
    carried.skempton_brogan_gradient = 0.31;
    EXPECT_NE(first(carried).find("near the gradient that moves 1 %"), std::string::npos) << first(carried);
}

TEST(MobilityWords, CallTwoGradientsNearThatDifferByLessThanAFactorOfOnePointThree) {
    const auto first = [](double factor) {
        erosion::MobilityResult mobility = upward();
        mobility.skempton_brogan_gradient = factor * *mobility.moves_1;
        return remarks_on(story_of({mobility}).front()).front();
    };
    for (const double near : {1 / 1.29, 1.0, 1.29}) {
        EXPECT_NE(first(near).find("near the gradient that moves 1 %"), std::string::npos) << first(near);
    }
    EXPECT_NE(first(1 / 1.31).find("below the gradient that moves 1 %"), std::string::npos) << first(1 / 1.31);
    EXPECT_NE(first(1.31).find("above the gradient that moves 1 %"), std::string::npos) << first(1.31);
}

TEST(MobilityWords, NameTheSampleWhereANumberIsOfOneAlone) {
    erosion::MobilityResult mobility = upward();
    mobility.ramp.back().displaced_mass_share = 0.3;
    const auto labels = [](const MobilityStory& story) {
        return std::ranges::count_if(remarks_on(story), [](const std::string& remark) {
            return remark.find(" in the first sample") != std::string::npos;
        });
    };
    EXPECT_EQ(labels(story_of({mobility}).front()), 0);
    EXPECT_EQ(labels(story_of({mobility, mobility}).front()), 3) << "measures, the share of the force, passage";
}

TEST(MobilityWords, MentionFinesThatSift) {
    erosion::MobilityResult sifting = upward();
    sifting.sifts = true, sifting.sifting_mass_share = 0.05;
    EXPECT_NE(remarks_on(story_of({sifting}).front()).back().find("5 % of the fines' mass sift"), std::string::npos);
    EXPECT_EQ(short_verdict(story_of({sifting}).front()).size(), short_verdict(story_of({upward()}).front()).size());
    sifting.sifting_mass_share = 0.5;
    EXPECT_EQ(
        short_verdict(story_of({sifting}).front())[1],
        "50 % of the fines fall through the skeleton without any flow: for them no gradient is critical."
    );
}

TEST(MobilityWords, CallAGradientThatRoundsToZeroLessThanTheSmallestKnown) {
    erosion::MobilityResult loose = upward();
    loose.moves_1 = 0.001, loose.moves_10 = 0.002, loose.specified_gradient.reset();
    const MobilityStory story = story_of({loose}).front();
    EXPECT_NE(short_verdict(story).front().find("1 % of the fines at i < 0.01, a tenth at i < 0.01"), std::string::npos)
        << short_verdict(story).front();
    EXPECT_EQ(mobility_headlines(story).front().value, "< 0.01");
}

} // namespace
} // namespace suffuse::answer
