#include "suffuse/stability/filter_between.hpp"

#include "suffuse/stability/criterion_guide.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::stability {
namespace {

grains::Grading straight(double from, double to) {
    return {{from, to}, {0, 1}, ""};
}

TEST(FilterBetween, HasItsRulesExplainedWithTheirSource) {
    for (const Criterion& rule : check_filter(straight(1e-4, 4e-4), straight(2e-3, 2.0001e-3)).criteria) {
        if (rule.name.starts_with("The filter's own stability")) {
            continue; // criteria of any soil
        }
        const auto text = explain_criterion(rule.id);
        ASSERT_TRUE(text) << rule.id;
        EXPECT_NE(text->find(rule.source), std::string::npos) << *text;
        EXPECT_EQ(text->find("unverified") == std::string::npos, rule.verified) << *text;
        EXPECT_NE(explain_criterion("filter")->find(*text), std::string::npos) << "all of them by one word";
    }
}

TEST(FilterBetween, ASandUnderAGravelIsJudgedByItsD85) {
    // A base of category 4, log-uniform from 0.1 to 1 mm: d85 = 10^-0.15 mm, d15 = 10^-0.85 mm, d95 = 10^-0.05 mm.
    const grains::Grading base = straight(1e-4, 1e-3);
    const double d85 = 1e-3 * std::pow(10, -0.15), d15 = 1e-3 * std::pow(10, -0.85), d95 = 1e-3 * std::pow(10, -0.05);
    const auto good = check_filter(base, straight(2e-3, 2.0001e-3)).criteria;
    EXPECT_NEAR(good[0].value.value(), 2e-3 / d85, 1e-4);
    EXPECT_NEAR(good[1].value.value(), 2e-3 / (4 * d85), 1e-4); // category 4: the same rule
    EXPECT_NEAR(good[2].value.value(), 2e-3 / d95, 1e-4);
    EXPECT_NEAR(good[3].value.value(), 2e-3 / d15, 2e-3);
    for (const Criterion& criterion : good) {
        EXPECT_STREQ(filter_word(criterion.verdict), "holds") << criterion.name;
    }
    const auto coarse = check_filter(base, straight(9e-3, 9.001e-3)).criteria;
    EXPECT_STREQ(filter_word(coarse[0].verdict), "fails");
    EXPECT_STREQ(filter_word(coarse[2].verdict), "fails"); // 9/0.891 > 9: it never seals
    EXPECT_STREQ(filter_word(coarse[3].verdict), "holds");
}

TEST(FilterBetween, TheLargestFilterFollowsTheFinesOfTheBase) {
    const auto with = [](double fines, double d85) {
        BaseSoil base;
        base.fines = {fines, fines}, base.d85 = {d85, d85};
        return largest_filter(base).d15.least;
    };
    EXPECT_NEAR(with(0.90, 0.05e-3), 0.45e-3, 1e-12);
    EXPECT_NEAR(with(0.95, 0.01e-3), 0.2e-3, 1e-12); // at least
    EXPECT_NEAR(with(0.60, 0.2e-3), 0.7e-3, 1e-12);
    EXPECT_NEAR(with(0.40, 1e-3), 0.7e-3, 1e-12);
    EXPECT_NEAR(with(0.39999, 1e-3), 0.7e-3, 2e-7); // joined at 40 % ...
    EXPECT_NEAR(with(0.15, 1e-3), 4e-3, 1e-12);
    EXPECT_NEAR(with(0.1499, 1e-3), 4e-3, 1e-12);   // ... and at 15 %
    EXPECT_NEAR(with(0.20, 1e-3), 3.34e-3, 1e-12);  // 0.7 + 20/25 (4 - 0.7) mm
    EXPECT_NEAR(with(0.20, 0.1e-3), 0.7e-3, 1e-12); // no less where 4 d85 is finer
}

/// Of a base.
std::vector<int> categories(const grains::Grading& measured) {
    return largest_filter(characterize_base(measured)).category;
}

TEST(FilterBetween, TheCategoryOfABaseFollowsItsFines) {
    for (const auto& [fines, category] :
         {std::pair{0.851, 1}, {0.849, 2}, {0.401, 2}, {0.399, 3}, {0.151, 3}, {0.149, 4}}) {
        EXPECT_EQ(categories({{0.04e-3, 0.075e-3, 0.2e-3}, {0, fines, 1}, ""}), std::vector{category}) << fines;
    }
}

TEST(FilterBetween, TheBaseIsRegradedOnTheSieveOf475Millimeters) {
    // Half of the mass is gravel; what passes 4.75 mm is log-uniform from 0.05 mm on.
    const grains::Grading base{{0.05e-3, 4.75e-3, 50e-3}, {0, 0.5, 1}, ""};
    const BaseSoil found = characterize_base(base);
    EXPECT_EQ(found.regraded_on, 4.75e-3);
    EXPECT_FALSE(found.has_gap);
    EXPECT_NEAR(found.d85.least, 0.05e-3 * std::pow(95, 0.85), 1e-9);
    EXPECT_NEAR(found.fines.least, std::log(1.5) / std::log(95), 1e-12);
    EXPECT_TRUE(found.fines.is_known());
    EXPECT_NEAR(found.d15.least, 0.05e-3 * std::pow(95, 0.30), 1e-9); // of the whole base
}

TEST(FilterBetween, WhatWasNotMeasuredIsNotGuessed) {
    const grains::Grading open{{0.075e-3, 0.6e-3, 4e-3}, {0.2, 0.6, 1}, ""};
    const auto criteria = check_filter(open, straight(1e-3, 2e-3)).criteria;
    EXPECT_TRUE(criteria[0].value);    // d85 was
    EXPECT_TRUE(criteria[1].verified); // category 3
    // d15 is finer than 0.075 mm: a filter of 0.3 mm may be too fine for it or not.
    const Criterion unknown = check_filter(open, straight(0.29e-3, 0.3e-3)).criteria[3];
    EXPECT_EQ(unknown.verdict, Verdict::CannotSay);
    EXPECT_NE(unknown.remark.find("not measured"), std::string::npos);
    EXPECT_FALSE(unknown.value);
}

TEST(FilterBetween, WhatIsCertainWithoutAMeasurementIsJudged) {
    const auto verdict = [](const grains::Grading& base, const grains::Grading& filter, std::size_t rule) {
        return check_filter(base, filter).criteria[rule].verdict;
    };
    // d85 and d95 of the base are finer than 0.075 mm and at most 0.35 mm; D15 of the filter is 0.711 mm.
    const grains::Grading fine{{0.075e-3, 0.425e-3, 2e-3, 4.75e-3}, {.90, .96, .99, 1}, ""};
    const grains::Grading coarse{{0.3e-3, 0.6e-3, 1e-3, 5e-3, 20e-3, 40e-3}, {0, .10, .25, .60, .95, 1}, ""};
    const auto certain = check_filter(fine, coarse).criteria;
    EXPECT_EQ(certain[0].verdict, Verdict::Unstable); // above 9.5
    EXPECT_EQ(certain[1].verdict, Verdict::Unstable); // at most 9 d85, below 0.675 mm
    EXPECT_FALSE(certain[0].value);
    EXPECT_NE(certain[0].remark.find("the ratio is above 9.4"), std::string::npos) << certain[0].remark;
    // D15 of the filter is below 0.6 mm: no more than 4 d85 = 0.8 mm, and less than 5 d15 = 0.75 mm.
    const grains::Grading open{{0.6e-3, 1e-3, 5e-3}, {.20, .25, 1}, ""}, sand = straight(0.14e-3, 0.22e-3);
    EXPECT_EQ(verdict(sand, open, 0), Verdict::Stable);
    EXPECT_EQ(verdict(sand, open, 1), Verdict::Stable);
    EXPECT_EQ(verdict(sand, open, 3), Verdict::Unstable);
    EXPECT_EQ(verdict(straight(0.05e-3, 0.14e-3), open, 0), Verdict::CannotSay); // 4 d85 = 0.48 mm
    // Less than 15 % pass 0.15 mm, so fewer are finer than 0.075 mm: category 4.
    EXPECT_EQ(categories({{0.15e-3, 2e-3}, {0.14, 1}, ""}), std::vector{4});
    EXPECT_EQ(categories({{0.15e-3, 2e-3}, {0.16, 1}, ""}), (std::vector{3, 4}));
}

TEST(FilterBetween, ItsSentencesGiveTheNumberThatDecides) {
    // D15F = 0.09 mm is 60 d15B, and below 0.1 mm.
    const Criterion drains = check_filter(straight(1e-6, 0.1e-3), straight(0.089e-3, 0.1e-3)).criteria[3];
    EXPECT_EQ(drains.verdict, Verdict::Unstable);
    EXPECT_EQ(drains.measure, "D15F/0.1 mm");
    EXPECT_LT(drains.value.value(), drains.limit.value());
    const auto no_erosion = [](double fines) {
        const grains::Grading base{{0.04e-3, 0.075e-3, 0.2e-3}, {0, fines, 1}, ""};
        return check_filter(base, straight(1e-3, 2e-3)).criteria[1].remark;
    };
    EXPECT_NE(no_erosion(0.5).find("at most 0.7 mm; not"), std::string::npos) << no_erosion(0.5);
    EXPECT_NE(no_erosion(0.3).find("at most 0.7 mm (between 0.7 mm at 40 %"), std::string::npos) << no_erosion(0.3);
    EXPECT_NE(no_erosion(0.1).find(" mm (4 d85); not"), std::string::npos) << no_erosion(0.1);
}

/// A laboratory's gravel with a gap from 0.25 to 2 mm, and a sandy filter for it.
grains::Grading gap_graded_gravel() {
    return {
        {2e-6, 6e-6, 20e-6, 63e-6, 125e-6, 0.25e-3, 0.5e-3, 1e-3, 2e-3, 4e-3, 8e-3, 16e-3, 31.5e-3, 63e-3},
        {.01, .025, .05, .09, .14, .20, .23, .245, .26, .31, .43, .61, .84, 1},
        ""};
}

grains::Grading sandy_filter() {
    return {
        {63e-6, 0.25e-3, 0.5e-3, 1e-3, 2e-3, 4e-3, 8e-3, 16e-3, 31.5e-3},
        {.01, .02, .05, .14, .30, .52, .74, .92, 1},
        ""};
}

const Criterion& rule(const FilterCheck& check, const std::string& id) {
    for (const Criterion& criterion : check.criteria) {
        if (criterion.id == id) {
            return criterion;
        }
    }
    throw std::runtime_error("no rule " + id);
}

TEST(FilterBetween, AGapGradedBaseIsRegradedOnTheFineEndOfItsGap) {
    const BaseSoil base = characterize_base(gap_graded_gravel());
    EXPECT_TRUE(base.has_gap);
    EXPECT_EQ(base.regraded_on, 0.25e-3);
    EXPECT_EQ(categories(gap_graded_gravel()), std::vector{2}); // 50 % of what is finer than the gap
    const FilterCheck check = check_filter(gap_graded_gravel(), sandy_filter());
    EXPECT_NEAR(rule(check, "no-erosion-filter").value.value(), 1.49, 0.005); // as its own curve below 0.25 mm gives
    EXPECT_NEAR(rule(check, "terzaghi-filter").value.value(), 5.91, 0.005);
    EXPECT_EQ(check.verdict, Verdict::Unstable);
    EXPECT_EQ(filter_summary(check), "fails by 2 of 7 rules: Terzaghi and Peck, No erosion (NRCS 2017)");
    // The part below the gap, as a soil of its own, is judged alike.
    const grains::Grading below{{2e-6, 6e-6, 20e-6, 63e-6, 125e-6, 0.25e-3}, {.05, .125, .25, .45, .70, 1}, ""};
    EXPECT_NEAR(
        rule(check_filter(below, sandy_filter()), "no-erosion-filter").value.value(),
        rule(check, "no-erosion-filter").value.value(), 1e-12
    );
}

TEST(FilterBetween, OfTwoGapsTheFineOneDecidesForTheGrainsBelowItPassBetweenTheOthers) {
    const std::vector<double> d{0.04e-3, 0.075e-3, 0.1e-3, 0.2e-3, 0.3e-3, 1e-3, 2e-3, 5e-3, 25e-3, 63e-3};
    const grains::Grading two{d, {0, .08, .14, .35, .47, .50, .68, .73, .75, 1}, ""};
    const grains::Grading one{d, {0, .08, .14, .35, .47, .50, .60, .65, .75, 1}, ""}; // without that of 5 to 25 mm
    const grains::Grading filter{{2.36e-3, 4.75e-3, 6.3e-3, 9.5e-3, 12.5e-3, 19e-3}, {0, .08, .18, .40, .70, 1}, ""};
    EXPECT_EQ(characterize_base(two).regraded_on, 0.3e-3);
    for (const char* id : {"terzaghi-filter", "no-erosion-filter", "continuing-erosion-filter"}) {
        const Criterion criterion = rule(check_filter(two, filter), id);
        EXPECT_EQ(criterion.verdict, Verdict::Unstable) << id;
        EXPECT_NEAR(*criterion.value, rule(check_filter(one, filter), id).value.value(), 1e-12) << id;
    }
}

TEST(FilterBetween, OfABaseWhoseCurveEndsBelowTheSieveOfRegradingTheGravelHasBounds) {
    // 88 % below 4 mm: 88 to 100 % below 4.75 mm, so d85 is of 74.8 to 85 %, and 14 to 15.9 % are fines.
    const grains::Grading base{
        {5e-6, 20e-6, 75e-6, 0.125e-3, 0.25e-3, 0.5e-3, 1e-3, 2e-3, 4e-3},
        {0, .04, .14, .22, .36, .48, .62, .76, .88},
        ""};
    const BaseSoil found = characterize_base(base);
    EXPECT_NEAR(found.d85.least, 1e-3 * std::pow(2, (0.85 * 0.88 - 0.62) / 0.14), 1e-9);
    EXPECT_NEAR(found.d85.most, 2e-3 * std::pow(2, 0.09 / 0.12), 1e-9);
    EXPECT_NEAR(found.fines.most, 0.14 / 0.88, 1e-12);
    EXPECT_EQ(categories(base), (std::vector{3, 4}));
    const auto verdict = [&base](double d15) {
        return rule(check_filter(base, straight(d15, 1.0001 * d15)), "no-erosion-filter").verdict;
    };
    EXPECT_EQ(verdict(13.6e-3), Verdict::Unstable); // above 4 x 3.36 mm
    EXPECT_EQ(verdict(13.2e-3), Verdict::CannotSay);
    EXPECT_EQ(verdict(7.5e-3), Verdict::CannotSay);
    EXPECT_EQ(verdict(7.2e-3), Verdict::Stable); // by 15.9 % of fines and the least d85
}

TEST(FilterBetween, OfABaseThatWasMeasuredAsGravelAloneAFilterThatHoldsNoSandFails) {
    // Whatever its 12 % below 4.75 mm are, d85 is no larger.
    const grains::Grading base{{4.75e-3, 9.5e-3, 19e-3, 37.5e-3, 63e-3}, {.12, .30, .60, .90, 1}, ""};
    for (const grains::Grading& measured : {base, grains::Grading{{9.5e-3, 19e-3, 63e-3}, {.30, .60, 1}, ""}}) {
        EXPECT_EQ(characterize_base(measured).d85.most, 4.75e-3);
        const auto verdict = [&measured](double d15) {
            return rule(check_filter(measured, straight(d15, 1.0001 * d15)), "no-erosion-filter").verdict;
        };
        EXPECT_EQ(verdict(19.1e-3), Verdict::Unstable);
        EXPECT_EQ(verdict(18.9e-3), Verdict::CannotSay);
    }
    // A gravel without any grain below it is its own.
    EXPECT_FALSE(characterize_base(straight(9.5e-3, 63e-3)).regraded_on);
}

TEST(FilterBetween, AFilterThatIsUnstableItselfFailsAndIsJudgedWashedOut) {
    const grains::Grading sand{{0.05e-3, 0.075e-3, 0.1e-3, 0.2e-3, 0.5e-3}, {0, .08, .20, .60, 1}, ""};
    const FilterCheck check = check_filter(sand, gap_graded_gravel());
    EXPECT_EQ(rule(check, "terzaghi-filter").verdict, Verdict::Stable); // by its fines, which do not stay
    EXPECT_EQ(rule(check, "no-erosion-filter").verdict, Verdict::Stable);
    EXPECT_EQ(rule(check, "filter-fines").verdict, Verdict::Unstable);
    EXPECT_NEAR(rule(check, "filter-fines").value.value(), 0.103, 0.001);
    EXPECT_EQ(rule(check, "filter-kezdi-1979").verdict, Verdict::Unstable);
    // D15 of what is coarser than 0.25 mm: at 20 + 0.15 x 80 = 32 % of the whole curve.
    const double d15 = 4e-3 * std::pow(2, 1.0 / 12), d85 = 0.2e-3 * std::pow(2.5, 25.0 / 40);
    EXPECT_NEAR(rule(check, "terzaghi-filter-washed-out").value.value(), d15 / d85, 1e-9);
    EXPECT_EQ(rule(check, "no-erosion-filter-washed-out").verdict, Verdict::Unstable);
    EXPECT_EQ(check.verdict, Verdict::Unstable);
}

TEST(FilterBetween, ACleanStableFilterHolds) {
    const grains::Grading base = straight(1e-4, 1e-3);
    const FilterCheck check = check_filter(base, straight(1e-3, 4e-3));
    EXPECT_EQ(check.verdict, Verdict::Stable);
    EXPECT_EQ(filter_summary(check), "holds by all 7 rules");
    const grains::Grading boulders = straight(2e-3, 400e-3);
    EXPECT_EQ(
        filter_summary(check_filter(straight(0.3e-3, 1.5e-3), boulders)),
        "holds by all 7 rules that count, and fails by Segregation (NRCS 2017), unverified"
    );
    EXPECT_EQ(rule(check, "filter-fines").value, 0);
}

TEST(FilterBetween, AFilterSegregatesIfItsCoarsestGrainsAreTooLargeForItsFinest) {
    const auto parts = [](double d10, double d90) {
        const double d0 = d10 * std::pow(d10 / d90, 1.0 / 8), d100 = d90 * std::pow(d90 / d10, 1.0 / 8);
        return rule(check_filter(straight(1e-4, 1e-3), straight(d0, d100)), "filter-segregation");
    };
    EXPECT_NEAR(parts(0.4e-3, 10e-3).value.value(), 0.5, 1e-9);
    EXPECT_EQ(parts(0.4e-3, 19e-3).verdict, Verdict::Stable);
    EXPECT_EQ(parts(0.4e-3, 21e-3).verdict, Verdict::Unstable);
    EXPECT_EQ(parts(0.6e-3, 24e-3).verdict, Verdict::Stable);
    EXPECT_EQ(parts(3e-3, 41e-3).verdict, Verdict::Unstable);
    EXPECT_EQ(parts(20e-3, 59e-3).verdict, Verdict::Stable);
    EXPECT_FALSE(parts(20e-3, 59e-3).verified);
}

} // namespace
} // namespace suffuse::stability
