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

namespace suffuse::stability {

using grains::Grading;

namespace {

constexpr double gravel_size = 4.75e-3; // No. 4 [m]

/// The curve of what is finer than `size` [m], which `passing` of the mass is.
Grading finer_part(const Grading& measured, double size, double passing) {
    Grading regraded;
    regraded.origin = measured.origin;
    for (std::size_t k = 0; k < measured.diameter.size() && measured.diameter[k] < size; ++k) {
        regraded.diameter.push_back(measured.diameter[k]);
        regraded.passing.push_back(measured.passing[k] / passing);
    }
    regraded.diameter.push_back(size);
    regraded.passing.push_back(1);
    return regraded;
}

/// "0.7 mm", "below 0.075 mm", "0.2 to 0.675 mm".
std::string bounds_text(const SizeBounds& bounds, double unit, const char* unit_text) {
    const double least = bounds.least / unit, most = bounds.most / unit;
    return bounds.is_known()  ? fmt::format("{:.3g}{}", least, unit_text)
           : least <= 0       ? fmt::format("below {:.3g}{}", most, unit_text)
           : std::isinf(most) ? fmt::format("above {:.3g}{}", least, unit_text)
                              : fmt::format("{:.3g} to {:.3g}{}", least, most, unit_text);
}

std::string mm(const SizeBounds& size) {
    return bounds_text(size, 1e-3, " mm");
}

/// A ratio of two sizes. Where one was not measured, its bounds decide if they lie on one side of the limit.
void judge_ratio(const SizeBounds& over, const SizeBounds& under, const std::string& remark, Criterion& criterion) {
    const SizeBounds ratio{over.least / under.most, over.most / under.least};
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

} // namespace

BaseSoil characterize_base(const Grading& measured) {
    BaseSoil base;
    base.d15 = size_bounds(measured, 0.15);
    const auto gap = find_gap(measured);
    base.has_gap = gap && gap->fine_end < gravel_size;
    const double split = base.has_gap ? gap->fine_end : gravel_size;
    const auto below = share_within(measured, split);
    const bool is_regraded = below && *below < 1 && *below > measured.passing.front();
    base.regraded_on = is_regraded ? std::optional(split) : std::nullopt;
    const Grading regraded = is_regraded ? finer_part(measured, split, *below) : measured;
    base.fines = share_within(regraded, sieve_200);
    base.d85 = size_bounds(regraded, 0.85);
    base.d95 = size_bounds(regraded, 0.95);
    const auto d15 = size_within(regraded, 0.15);
    base.width = base.d85.is_known() && d15 ? std::optional(base.d85.least / *d15) : std::nullopt;
    constexpr int least_fines = 4;
    if (base.fines) {
        base.category = category_of(*base.fines);
    } else if (regraded.diameter.front() > sieve_200 && category_of(regraded.passing.front()) == least_fines) {
        base.category = least_fines; // a larger size passes no more than that
    }
    return base;
}

std::optional<LargestFilter> largest_filter(const BaseSoil& base) {
    static constexpr double least_of_silts = 0.2e-3, of_silty_sands = 0.7e-3; // [m]
    const auto of_d85 = [&base](auto&& largest) { return SizeBounds{largest(base.d85.least), largest(base.d85.most)}; };
    switch (base.category) {
    case 1:
        return LargestFilter{
            of_d85([](double d85) { return std::max(9 * d85, least_of_silts); }), " (9 d85, no less than 0.2 mm)"};
    case 2:
        return LargestFilter{{of_silty_sands, of_silty_sands}, ""};
    case 3:
        return LargestFilter{
            of_d85([&base](double d85) {
                const double rise = std::max(4 * d85 - of_silty_sands, 0.0);
                return (0.40 - *base.fines) / 0.25 * rise + of_silty_sands;
            }),
            " (between 0.7 mm at 40 % of fines and 4 d85 at 15 %)"};
    case 4:
        return LargestFilter{of_d85([](double d85) { return 4 * d85; }), " (4 d85)"};
    default:
        return std::nullopt;
    }
}

namespace {

/// How D15 of a filter, whole or washed out, stands to what holds the base.
std::vector<Criterion> judge_retention(const BaseSoil& base, const SizeBounds& d15) {
    const std::string regraded = base.regraded_on ? fmt::format(
                                                        ", base regraded on {:.3g} mm{}", 1e3 * *base.regraded_on,
                                                        base.has_gap ? ", the fine end of its gap" : ""
                                                    )
                                                  : "";
    Criterion terzaghi = define("terzaghi-filter");
    judge_ratio(d15, base.d85, fmt::format("D15F {}, d85B {}{}", mm(d15), mm(base.d85), regraded), terzaghi);

    Criterion no_erosion = define("no-erosion-filter");
    const auto largest = largest_filter(base);
    const std::string fines = base.fines ? fmt::format("{:.3g} % fines", 100 * *base.fines) : "few fines";
    if (largest) {
        judge_ratio(
            d15, largest->d15,
            fmt::format(
                "base of category {} ({}{}): at most {}{}; not for dispersive clay", base.category, fines, regraded,
                mm(largest->d15), largest->rule
            ),
            no_erosion
        );
    } else {
        no_erosion.remark = "the fines of the base below 0.075 mm were not measured";
    }

    Criterion continuing = define("continuing-erosion-filter");
    judge_ratio(
        d15, base.d95, fmt::format("d95B {}{}; beyond, the filter never seals", mm(base.d95), regraded), continuing
    );
    return {terzaghi, no_erosion, continuing};
}

Criterion judge_drainage(const BaseSoil& base, const SizeBounds& d15) {
    constexpr SizeBounds least_d15{0.1e-3, 0.1e-3}; // [m]
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
    std::vector<std::string> failing, silent;
    std::size_t counted = 0;
    for (const Criterion& criterion : check.criteria) {
        counted += criterion.verified ? 1 : 0;
        if (criterion.verified && criterion.verdict != Verdict::Stable) {
            (criterion.verdict == Verdict::CannotSay ? silent : failing).push_back(criterion.name);
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
    }
}

} // namespace

FilterCheck check_filter(const Grading& measured, const Grading& filter) {
    const BaseSoil base = characterize_base(measured);
    const SizeBounds d15 = size_bounds(filter, 0.15);
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
