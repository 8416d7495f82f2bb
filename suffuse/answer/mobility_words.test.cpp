#include "suffuse/answer/mobility_words.hpp"

#include "suffuse/answer/mobility_headlines.hpp"
#include "suffuse/answer/mobility_remarks.hpp"

#include <gtest/gtest.h>

#include <cmath>
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
    EXPECT_EQ(card.value, "≥ 0.75");
    EXPECT_NE(card.detail.find("the least of three samples, of which one moves 1 % before"), std::string::npos)
        << card.detail;
}

TEST(MobilityWords, OfASpecifiedGradientAboveHeaveSayThatTheWaterLiftsTheWholeSoil) {
    erosion::MobilityResult lifted = upward();
    lifted.specified_gradient = 1.2;
    lifted.ramp.back().displaced_mass_share = 0.3;
    EXPECT_NE(
        verdict(story_of({lifted}).front())
            .find("At the specified 1.20 the water lifts the whole soil (factor of safety 0.25 before 1 % move half a "
                  "diameter; one sample)."),
        std::string::npos
    ) << verdict(story_of({lifted}).front());
    lifted.moves_1.reset(), lifted.moves_10.reset();
    const MobilityStory story = story_of({lifted}).front();
    EXPECT_EQ(
        verdict(story), "Upward flow moves less than 1 % of the fines below heave; the soil heaves at 1.05 first. At "
                        "the specified 1.20 the water lifts the whole soil (factor of safety 0.88 against heave; one "
                        "sample)."
    );
    EXPECT_EQ(
        short_verdict(story).back(),
        "At the specified 1.20 the water lifts the whole soil: factor of safety 0.88 against heave."
    );
    const Headline card = mobility_headlines(story).front();
    EXPECT_EQ(card.value, "0.88");
    EXPECT_EQ(card.label, "Factor of safety against heave");
    for (const std::string& remark : remarks_on(story)) {
        EXPECT_EQ(remark.find("i = 1.20"), std::string::npos) << remark << ": a step that counts for nothing";
    }
}

TEST(MobilityWords, OfASampleThatHeavesAtTheSpecifiedGradientSayHowManyDo) {
    erosion::MobilityResult still = upward(), lifted = upward();
    still.heave_gradient = 1.3;
    for (erosion::MobilityResult* sample : {&still, &lifted}) {
        sample->moves_1.reset(), sample->moves_10.reset(), sample->specified_gradient = 1.2;
        sample->ramp.back().mobile_mass_share = 0.004;
    }
    EXPECT_NE(
        verdict(story_of({still, lifted}).front()).find("lifts the whole soil in 1 of 2 samples"), std::string::npos
    );
    EXPECT_NE(
        verdict(story_of({still, lifted, still}).front()).find("it moves 0.4 % in 2 of 3 samples"), std::string::npos
    );
}

TEST(MobilityWords, GiveNoLowerBoundOfNothing) {
    erosion::MobilityResult creeping = upward();
    creeping.ramp.front().mobile_mass_share = 0, creeping.ramp.front().still_moving = 0.1;
    EXPECT_NE(
        verdict(story_of({creeping}).front())
            .find("At the specified 0.20 it moved less than 0.1 % before the gradient rose"),
        std::string::npos
    ) << verdict(story_of({creeping}).front());
}

TEST(MobilityWords, RoundNoFactorOfSafetyUpToOne) {
    erosion::MobilityResult near = upward();
    near.moves_1 = 0.98 * *near.specified_gradient;
    const MobilityStory story = story_of({near}).front();
    EXPECT_NE(verdict(story).find("factor of safety 0.98 before"), std::string::npos) << verdict(story);
    EXPECT_EQ(mobility_headlines(story).front().value, "0.98");
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
        "0.20 it moves at least 0.2 % (factor of safety at most 1.5 before 1 % move half a diameter; one sample)."
    );
    const std::vector<Headline> cards = mobility_headlines(story_of({creeping}).front());
    EXPECT_EQ(cards[0].value, "≤ 1.5");
    EXPECT_EQ(cards[0].detail, "fines were still moving when the gradient rose; no replicate") << "no low end";
    EXPECT_EQ(cards[1].value, "≤ 0.30");
    EXPECT_EQ(cards[1].spread, "") << "it may be lower by more than a step";
    EXPECT_EQ(cards[2].value, "0.51");
    EXPECT_EQ(cards[2].spread, "± 0.01") << "half of a step of 0.01, rounded up";
}

TEST(MobilityWords, KnowNoFactorOfSafetyWhereNoStepEnded) {
    erosion::MobilityResult creeping = upward();
    creeping.moves_1.reset(), creeping.moves_10.reset();
    creeping.ramp.front().still_moving = 0.1;
    EXPECT_NE(
        verdict(story_of({creeping}).front()).find("(no factor of safety, as motion had not ended"), std::string::npos
    ) << verdict(story_of({creeping}).front());
    EXPECT_EQ(mobility_headlines(story_of({creeping}).front()).front().label, "Gradient of heave, i_c");
}

TEST(MobilityWords, SeeNoDisagreementWithARuleInWhatIsOnlyABound) {
    erosion::MobilityResult creeping = upward();
    creeping.skempton_brogan_gradient = 0.14;
    creeping.ramp.back().gradient = 1;
    EXPECT_TRUE(disagreement(story_of({creeping}).front()));
    creeping.ramp.front().still_moving = 0.1;
    EXPECT_FALSE(disagreement(story_of({creeping}).front())) << "at most 1.5 may be below 1";
    erosion::MobilityResult still = upward();
    still.moves_1.reset(), still.moves_10.reset();
    still.specified_gradient = 0.21, still.skempton_brogan_gradient = 0.25;
    EXPECT_FALSE(disagreement(story_of({still}).front())) << "at least 0.95 may be above 1";
}

TEST(MobilityWords, CallHeaveTheCriticalGradientOfFlowStraightUpAlone) {
    erosion::MobilityResult oblique = upward();
    oblique.direction = {std::sqrt(0.75), 0, 0.5}, oblique.heave_gradient = 1.87;
    const MobilityStory story = story_of({oblique}).front();
    EXPECT_EQ(mobility_headlines(story).back().label, "Gradient of heave");
    EXPECT_NE(mobility_headlines(story).back().detail.find("i_c over the sine of its rise"), std::string::npos);
    for (const std::string& remark : remarks_on(story)) {
        EXPECT_EQ(remark.find("FC i_c/s"), std::string::npos) << remark;
    }
    EXPECT_EQ(mobility_headlines(story_of({upward()}).front()).back().label, "Gradient of heave, i_c");
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
    mobility.ramp.back().gradient = 1, mobility.ramp.back().displaced_mass_share = 0.3;
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
