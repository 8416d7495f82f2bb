#include "suffuse/stability/filter_between.hpp"

#include "suffuse/grains/grading.hpp"
#include "suffuse/stability/criterion_guide.hpp"
#include "suffuse/stability/curve.hpp"
#include "suffuse/stability/filter_itself.hpp"
#include "suffuse/stability/measured_part.hpp"
#include "suffuse/stability/open_curve.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::stability {

using grains::Grading;

namespace {

constexpr double gravel_size = 4.75e-3; // No. 4 [m]

/// A soil without its grains above `size` [m]; both ends of its curve may be open.
struct FinerPart {
    const Grading& measured;
    double size = std::numeric_limits<double>::infinity();
    Bounds share{1, 1}; ///< of the mass

    [[nodiscard]] Bounds size_of(double passing) const {
        const double least = size_bounds(measured, passing * share.least).least;
        return {std::min(size, least), std::min(size, size_bounds(measured, passing * share.most).most)};
    }

    [[nodiscard]] Bounds finer_than(double sieve) const {
        const Bounds whole = share_bounds(measured, sieve);
        return {
            std::min(1.0, whole.least / share.most), share.least > 0 ? std::min(1.0, whole.most / share.least) : 1.0};
    }
};

/// "0.7 mm", "below 0.075 mm", "0.2 to 0.675 mm".
std::string bounds_text(const Bounds& bounds, double unit, const char* unit_text) {
    const double least = bounds.least / unit, most = bounds.most / unit;
    return bounds.is_known()  ? fmt::format("{:.3g}{}", least, unit_text)
           : least <= 0       ? fmt::format("below {:.3g}{}", most, unit_text)
           : std::isinf(most) ? fmt::format("above {:.3g}{}", least, unit_text)
                              : fmt::format("{:.3g} to {:.3g}{}", least, most, unit_text);
}

std::string mm(const Bounds& size) {
    return bounds_text(size, 1e-3, " mm");
}

/// A ratio of two sizes. Where one was not measured, its bounds decide if they lie on one side of the limit.
void judge_ratio(const Bounds& over, const Bounds& under, const std::string& remark, Criterion& criterion) {
    const Bounds ratio{over.least / under.most, over.most / under.least};
    criterion.value = ratio.most;
    const Verdict at_most = judge(criterion);
    criterion.value = ratio.least;
    criterion.verdict = judge(criterion);
    criterion.remark = remark;
    if (over.is_known() && under.is_known()) {
        return;
    }
    criterion.value.reset();
    if (criterion.verdict == at_most) {
        criterion.remark = fmt::format("the ratio is {}; {}", bounds_text(ratio, 1, ""), remark);
        return;
    }
    criterion.verdict = Verdict::CannotSay;
    criterion.remark =
        fmt::format("{} was not measured; {}", over.is_known() ? "the size of the base" : "D15 of the filter", remark);
}

/// 1 to 4 by the share of fines.
int category_of(double fines) {
    return fines > 0.85 ? 1 : fines >= 0.40 ? 2 : fines >= 0.15 ? 3 : 4;
}

/// By a rule that rises with d85, and falls with the fines.
double largest_d15(int category, double d85, double fines) {
    constexpr double least_of_silts = 0.2e-3, of_silty_sands = 0.7e-3; // [m]
    return category == 1   ? std::max(9 * std::min(d85, sieve_200), least_of_silts)
           : category == 2 ? of_silty_sands
           : category == 3 ? (0.40 - fines) / 0.25 * std::max(4 * d85 - of_silty_sands, 0.0) + of_silty_sands
                           : 4 * d85;
}

constexpr const char* rule_of_category[] = {
    " (9 d85, no less than 0.2 mm)", "", " (between 0.7 mm at 40 % of fines and 4 d85 at 15 %)", " (4 d85)"};

/// Shares of fines at which a category begins and ends.
constexpr Bounds fines_of_category[] = {{0.85, 1}, {0.40, 0.85}, {0.15, 0.40}, {0, 0.15}};

/// "14 to 15.9 % fines".
std::string fines_text(const Bounds& fines) {
    return fines.is_known() ? fmt::format("{:.3g} % fines", 100 * fines.least)
                            : fmt::format("{:.3g} to {:.3g} % fines", 100 * fines.least, 100 * fines.most);
}

} // namespace

BaseSoil characterize_base(const Grading& measured) {
    BaseSoil base;
    base.d15 = size_bounds(measured, 0.15);
    const auto gap = find_finest_gap(measured);
    base.has_gap = gap && gap->fine_end < gravel_size;
    const double split = base.has_gap ? gap->fine_end : gravel_size;
    const Bounds below = share_bounds(measured, split);
    const bool is_regraded = below.least < 1 && below.most > 0;
    base.regraded_on = is_regraded ? std::optional(split) : std::nullopt;
    const FinerPart regraded = is_regraded ? FinerPart{measured, split, below} : FinerPart{measured};
    base.fines = regraded.finer_than(sieve_200);
    base.d85 = regraded.size_of(0.85);
    base.d95 = regraded.size_of(0.95);
    const Bounds d15 = regraded.size_of(0.15);
    base.width = base.d85.is_known() && d15.is_known() ? std::optional(base.d85.least / d15.least) : std::nullopt;
    return base;
}

LargestFilter largest_filter(const BaseSoil& base) {
    LargestFilter largest{{std::numeric_limits<double>::infinity(), 0}, {}, ""};
    for (int category = category_of(base.fines.most); category <= category_of(base.fines.least); ++category) {
        const Bounds& range = fines_of_category[category - 1];
        const double least = std::max(range.least, base.fines.least), most = std::min(range.most, base.fines.most);
        largest.d15.least = std::min(largest.d15.least, largest_d15(category, base.d85.least, most));
        largest.d15.most = std::max(largest.d15.most, largest_d15(category, base.d85.most, least));
        largest.category.push_back(category);
    }
    largest.rule = largest.category.size() == 1 ? rule_of_category[largest.category.front() - 1] : "";
    return largest;
}

namespace {

/// How D15 of a filter, whole or washed out, stands to what holds the base.
std::vector<Criterion> judge_retention(const BaseSoil& base, const Bounds& d15) {
    const std::string regraded = base.regraded_on ? fmt::format(
                                                        ", base regraded on {:.3g} mm{}", 1e3 * *base.regraded_on,
                                                        base.has_gap ? ", the fine end of its gap" : ""
                                                    )
                                                  : "";
    Criterion terzaghi = define("terzaghi-filter");
    judge_ratio(d15, base.d85, fmt::format("D15F {}, d85B {}{}", mm(d15), mm(base.d85), regraded), terzaghi);

    Criterion no_erosion = define("no-erosion-filter");
    const LargestFilter largest = largest_filter(base);
    const std::string limit = mm(largest.d15.least > 0 ? largest.d15 : Bounds{largest.d15.most, largest.d15.most});
    judge_ratio(
        d15, largest.d15,
        fmt::format(
            "base of category {} ({}{}): at most {}{}; not for dispersive clay", fmt::join(largest.category, " or "),
            fines_text(base.fines), regraded, limit, largest.rule
        ),
        no_erosion
    );

    Criterion continuing = define("continuing-erosion-filter");
    judge_ratio(
        d15, base.d95, fmt::format("d95B {}{}; beyond, the filter never seals", mm(base.d95), regraded), continuing
    );
    return {terzaghi, no_erosion, continuing};
}

Criterion judge_drainage(const BaseSoil& base, const Bounds& d15) {
    constexpr Bounds least_d15{0.1e-3, 0.1e-3}; // [m]
    Criterion drains = define("permeability-filter");
    judge_ratio(
        d15, base.d15, fmt::format("D15F {}, d15B {}; D15F also at least 0.1 mm", mm(d15), mm(base.d15)), drains
    );
    Criterion is_coarse = drains; // the second half of the rule, where it decides
    is_coarse.measure = "D15F/0.1 mm", is_coarse.limit = 1;
    judge_ratio(d15, least_d15, fmt::format("D15F {}, at least 0.1 mm", mm(d15)), is_coarse);
    return drains.verdict != Verdict::Unstable && is_coarse.verdict != Verdict::Stable ? is_coarse : drains;
}

/// One rule that fails decides; so does one that cannot say, where none fails. Unverified rules do not count.
void sum_up(FilterCheck& check) {
    std::vector<std::string> failing, silent, uncounted;
    std::size_t counted = 0;
    for (const Criterion& criterion : check.criteria) {
        counted += criterion.verified ? 1 : 0;
        if (criterion.verified && criterion.verdict != Verdict::Stable) {
            (criterion.verdict == Verdict::CannotSay ? silent : failing).push_back(criterion.name);
        } else if (criterion.verdict == Verdict::Unstable) {
            uncounted.push_back(criterion.name);
        }
    }
    if (!failing.empty()) {
        check.verdict = Verdict::Unstable;
        check.outcome = fmt::format("fails by {} of {} rules", failing.size(), counted);
        check.deciding = failing;
    } else if (!silent.empty()) {
        check.outcome = fmt::format("cannot be judged by {} of {} rules", silent.size(), counted);
        check.deciding = silent;
    } else {
        check.verdict = Verdict::Stable;
        check.outcome = fmt::format("holds by all {} rules", counted);
        if (!uncounted.empty()) {
            check.outcome += fmt::format(" that count, and fails by {}, unverified", fmt::join(uncounted, " and "));
        }
    }
}

} // namespace

FilterCheck check_filter(const Grading& measured, const Grading& filter) {
    const BaseSoil base = characterize_base(measured);
    const Bounds d15 = size_bounds(filter, 0.15);
    FilterCheck check{assess_measured(filter), judge_retention(base, d15)};
    check.criteria.push_back(judge_drainage(base, d15));
    for (Criterion& criterion : judge_filter_itself(filter, check.own)) {
        check.criteria.push_back(std::move(criterion));
    }
    if (const auto washed = washed_out_d15(filter, check.own)) {
        for (Criterion& criterion : judge_retention(base, washed->d15)) {
            criterion.id += "-washed-out";
            criterion.name += ", washed out";
            criterion.remark += fmt::format("; without the filter's grains below {:.3g} mm", 1e3 * washed->finer_than);
            check.criteria.push_back(std::move(criterion));
        }
    }
    sum_up(check);
    return check;
}

std::string filter_summary(const FilterCheck& check) {
    return check.deciding.empty() ? check.outcome
                                  : fmt::format("{}: {}", check.outcome, fmt::join(check.deciding, ", "));
}

const char* filter_word(Verdict verdict) {
    return verdict == Verdict::Stable ? "holds" : verdict == Verdict::CannotSay ? "cannot say" : "fails";
}

} // namespace suffuse::stability
