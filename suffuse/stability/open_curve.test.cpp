#include "suffuse/stability/open_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace suffuse::stability {
namespace {

using grains::Grading;

/// A sandy gravel, gap-graded, from 0.1 to 40 mm.
const Grading whole{
    {0.1e-3, 0.2e-3, 0.5e-3, 1e-3, 5e-3, 10e-3, 20e-3, 40e-3}, {0, 0.08, 0.16, 0.25, 0.27, 0.5, 0.8, 1}, ""};

Grading measured_from(std::size_t first, std::size_t end = whole.diameter.size()) {
    Grading part = whole;
    part.diameter = {
        whole.diameter.begin() + static_cast<std::ptrdiff_t>(first),
        whole.diameter.begin() + static_cast<std::ptrdiff_t>(end)};
    part.passing = {
        whole.passing.begin() + static_cast<std::ptrdiff_t>(first),
        whole.passing.begin() + static_cast<std::ptrdiff_t>(end)};
    return part;
}

const Criterion& one(const Assessment& assessment, const std::string& id) {
    return *std::ranges::find(assessment.criteria, id, &Criterion::id);
}

TEST(OpenCurve, AClosedOneIsAssessedAsItIs) {
    EXPECT_FALSE(is_open(whole));
    EXPECT_EQ(complete_ends(whole).size(), 1U);
    const Assessment a = assess(whole), b = assess_measured(whole);
    for (std::size_t k = 0; k < a.criteria.size(); ++k) {
        EXPECT_EQ(a.criteria[k].verdict, b.criteria[k].verdict) << a.criteria[k].id;
        EXPECT_EQ(a.criteria[k].value, b.criteria[k].value);
        EXPECT_EQ(a.criteria[k].id == "kenney-lau-1985", k == kenney_lau_1985_row);
    }
}

TEST(OpenCurve, WhatDoesNotNeedTheMissingEndIsJudgedAsOnTheWholeCurve) {
    const Grading open = measured_from(1); // begins at 8 %
    ASSERT_TRUE(is_open(open));
    EXPECT_EQ(complete_ends(open).size(), 3U);
    const Assessment found = assess_measured(open), full = assess(whole);
    EXPECT_DOUBLE_EQ(found.missing_fine, 0.08);
    EXPECT_DOUBLE_EQ(found.missing_coarse, 0);
    // Burenkova reads d15, d60, d90, all measured.
    EXPECT_EQ(one(found, "burenkova-1993").verdict, one(full, "burenkova-1993").verdict);
    EXPECT_NEAR(*one(found, "burenkova-1993").value, *one(full, "burenkova-1993").value, 1e-12);
    // The gap from 1 to 5 mm makes H < 15 % at 1 mm, F = 25 %: unstable by Kezdi whatever lies below 0.2 mm.
    EXPECT_EQ(one(full, "kezdi-1979").verdict, Verdict::Unstable);
    EXPECT_EQ(one(found, "kezdi-1979").verdict, Verdict::Unstable);
}

TEST(OpenCurve, ACriterionThatLooksAtTheMissingEndCannotSay) {
    // A steep sand, stable by all; measured from 12 % on, its fines could be anything.
    const Grading sand{{0.2e-3, 0.4e-3, 0.8e-3}, {0.12, 0.6, 1}, ""};
    const Assessment found = assess_measured(sand);
    const Criterion& kenney = one(found, "kenney-lau-1986");
    EXPECT_EQ(kenney.verdict, Verdict::CannotSay);
    // H/F = (1 - F)/F once 4d is beyond the coarsest size: least at the limit. That is F = 20 % where the fines that
    // were not measured make D60/D10 more than 3.
    EXPECT_NEAR(kenney.value.value_or(0), 0.8 / 0.2, 1e-12);
    EXPECT_EQ(
        kenney.remark, "at d = 0.224 mm, F = 20 % (F up to 20 %) of what was measured; stable where the 12 % below 0.2 "
                       "mm end sharply, "
                       "unstable where they taper off or lie beyond a gap"
    );
    EXPECT_FALSE(found.has_constrictions); // surface area is mostly that of the finest
}

TEST(OpenCurve, ACriterionOfTheShapeGivesTheNumberOfWhatWasMeasured) {
    // The gap makes H/F least at 0.5 mm, F = 16 %, 4d = 2 mm in the gap. The whole curve begins at 0.1 mm with 0 %.
    const Assessment full = assess(whole), found = assess_measured(measured_from(1));
    for (const char* id : {"kenney-lau-1985", "kenney-lau-1986", "li-fannin-2008"}) {
        const Criterion &part = one(found, id), &all = one(full, id);
        ASSERT_TRUE(part.value) << id;
        EXPECT_NEAR(*part.value, *all.value, 1e-12) << id;
        EXPECT_DOUBLE_EQ(*part.diameter, *all.diameter) << id;
        EXPECT_EQ(part.measured, part.value) << id;
        EXPECT_NE(part.remark.find("of what was measured; "), std::string::npos) << part.remark;
    }
}

TEST(OpenCurve, NoNumberIsGivenWhereNothingOfItWasMeasured) {
    // It begins at 35 %: no F up to 30 % was measured.
    const Assessment fines = assess_measured({{0.2e-3, 0.4e-3, 0.8e-3}, {0.35, 0.6, 1}, ""});
    EXPECT_FALSE(one(fines, "kenney-lau-1985").value);
    EXPECT_FALSE(one(fines, "kenney-lau-1985").measured);
    // It ends at 1 mm with 50 %: F(4d) is known up to d = 0.25 mm, F = 5 %, alone.
    const Assessment coarse = assess_measured({{0.125e-3, 0.25e-3, 0.5e-3, 1e-3}, {0, 0.05, 0.2, 0.5}, ""});
    const Criterion& kenney = one(coarse, "kenney-lau-1985");
    ASSERT_TRUE(kenney.value) << kenney.remark;
    EXPECT_NEAR(*kenney.value, 0.45 / 0.05, 1e-12);
    EXPECT_DOUBLE_EQ(*kenney.diameter, 0.25e-3);
}

TEST(OpenCurve, IsNotStableWhereNothingOfTheJudgedRangeWasMeasured) {
    // Its fines may hide a gap from 0.001 to 0.01 mm, and then it is unstable.
    const Grading sieves{{0.075e-3, 0.425e-3, 2e-3, 4.75e-3}, {.90, .96, .99, 1}, ""};
    const Grading full{
        {.0005e-3, .001e-3, .01e-3, .075e-3, .425e-3, 2e-3, 4.75e-3}, {0, .18, .20, .90, .96, .99, 1}, ""};
    AssessSpec spec;
    spec.seepage = Seepage{.gradient = 0.9};
    const Assessment found = assess_measured(sieves, spec), real = assess(full);
    for (const char* id : {"kenney-lau-1985", "kenney-lau-1986", "li-fannin-2008", "chang-zhang-2013"}) {
        EXPECT_EQ(one(found, id).verdict, Verdict::CannotSay) << id;
    }
    EXPECT_EQ(one(real, "kenney-lau-1985").verdict, Verdict::Unstable);
    EXPECT_NE(
        one(found, "kenney-lau-1985").remark.find("unstable where they lie partly beyond a gap"), std::string::npos
    ) << one(found, "kenney-lau-1985").remark;
    EXPECT_EQ(found.gradients[1].verdict, Verdict::CannotSay) << "alpha is unknown";
    EXPECT_EQ(complete_ends({{0.2e-3, 2e-3}, {0.2, 1}, ""}).size(), 3U);
}

TEST(OpenCurve, MixesNeitherMeasuresNorLimits) {
    // More than 35 % are finer than 0.063 mm: Chang and Zhang judge H/F, or the ratio of a gap where there is one.
    const Criterion mixed = one(assess_measured({{0.06e-3, 0.3e-3, 4e-3}, {0.4, 0.7, 1}, ""}), "chang-zhang-2013");
    EXPECT_EQ(mixed.verdict, Verdict::Stable);
    EXPECT_EQ(mixed.measure, "");
    EXPECT_FALSE(mixed.value || mixed.limit);
    EXPECT_EQ(mixed.remark, "the measure and its limit depend on the 40 % below 0.06 mm, the verdict does not");
}

TEST(OpenCurve, AVerdictIsVerifiedOnlyIfThatOfEveryCompletionIs) {
    // P below 0.063 mm is 0 where the fines end sharply, below 0.08 mm, and 9 to 10 % in other completions.
    const Grading silty{{0.08e-3, 0.16e-3, 0.32e-3, 0.64e-3, 5e-3, 20e-3}, {0.1, 0.133, 0.166, 0.2, 0.6, 1}, ""};
    const Grading sandy{{0.2e-3, 0.4e-3, 0.8e-3, 1.6e-3, 5e-3, 20e-3}, {0.02, 0.12, 0.153, 0.186, 0.6, 1}, ""};
    for (const auto& [open, is_verified] : {std::pair(silty, false), {sandy, true}}) {
        for (const Grading& completed : complete_ends(open)) {
            EXPECT_EQ(one(assess(completed), "chang-zhang-2013").verdict, Verdict::Unstable);
        }
        const Criterion found = one(assess_measured(open), "chang-zhang-2013");
        EXPECT_EQ(found.verdict, Verdict::Unstable);
        EXPECT_EQ(found.verified, is_verified);
    }
}

TEST(OpenCurve, NoCompletionThatWasTriedContradictsAVerdict) {
    // Verdicts on the open curve hold for the real one, of which it is a part.
    int reported = 0;
    for (const std::size_t first : {0U, 1U, 2U, 3U}) {
        for (const std::size_t end : {8U, 7U, 6U}) {
            const Assessment found = assess_measured(measured_from(first, end)), full = assess(whole);
            for (std::size_t k = 0; k < found.criteria.size(); ++k) {
                if (found.criteria[k].verdict != Verdict::CannotSay) {
                    ++reported;
                    EXPECT_EQ(found.criteria[k].verdict, full.criteria[k].verdict)
                        << found.criteria[k].id << " from " << first << " to " << end;
                }
            }
        }
    }
    EXPECT_GE(reported, 24) << "two criteria of each curve, or nothing was compared";
}

TEST(OpenCurve, TheGradientOfTheFinesAccountsForWhatTheCurveDoesNotShow) {
    AssessSpec spec;
    spec.seepage = Seepage{};
    const Assessment found = assess_measured({{0.2e-3, 0.4e-3, 0.8e-3}, {0.12, 0.6, 1}, ""}, spec);
    ASSERT_EQ(found.gradients.size(), 2U);
    EXPECT_EQ(found.gradients[1].verdict, Verdict::CannotSay);
}

} // namespace
} // namespace suffuse::stability
