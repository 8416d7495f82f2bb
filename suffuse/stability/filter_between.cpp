#include "suffuse/stability/filter_between.hpp"

#include "suffuse/grains/grading.hpp"
#include "suffuse/stability/curve.hpp"
#include "suffuse/stability/filter_itself.hpp"
#include "suffuse/stability/measured_part.hpp"
#include "suffuse/stability/open_curve.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

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

/// A ratio of two sizes that were measured, or why there is none.
void judge_ratio(
    const std::optional<double>& over, const std::optional<double>& under, const std::string& remark,
    Criterion& criterion
) {
    if (!over || !under) {
        criterion.remark = fmt::format("{} was not measured", over ? "the size of the base" : "D15 of the filter");
        return;
    }
    criterion.value = *over / *under;
    criterion.verdict = judge(criterion);
    criterion.remark = remark;
}

std::string mm(const std::optional<double>& size) {
    return size ? fmt::format("{:.3g} mm", 1e3 * *size) : "unknown";
}

} // namespace

BaseSoil characterize_base(const Grading& measured) {
    BaseSoil base;
    base.d15 = size_within(measured, 0.15);
    const auto gap = find_gap(measured);
    base.has_gap = gap && gap->fine_end < gravel_size;
    const double split = base.has_gap ? gap->fine_end : gravel_size;
    const auto below = share_within(measured, split);
    const bool is_regraded = below && *below < 1 && *below > measured.passing.front();
    base.regraded_on = is_regraded ? std::optional(split) : std::nullopt;
    const Grading regraded = is_regraded ? finer_part(measured, split, *below) : measured;
    base.fines = share_within(regraded, sieve_200);
    base.d85 = size_within(regraded, 0.85);
    base.d95 = size_within(regraded, 0.95);
    const auto d15 = size_within(regraded, 0.15);
    base.width = base.d85 && d15 ? std::optional(*base.d85 / *d15) : std::nullopt;
    if (base.fines) {
        base.category = *base.fines > 0.85 ? 1 : *base.fines >= 0.40 ? 2 : *base.fines >= 0.15 ? 3 : 4;
    }
    return base;
}

std::optional<LargestFilter> largest_filter(const BaseSoil& base) {
    constexpr double least_of_silts = 0.2e-3, of_silty_sands = 0.7e-3; // [m]
    if (base.category == 2) {
        return LargestFilter{of_silty_sands, "0.7 mm"};
    }
    if (base.category == 0 || !base.d85) {
        return std::nullopt;
    }
    if (base.category == 1) {
        return LargestFilter{std::max(9 * *base.d85, least_of_silts), "9 d85, at least 0.2 mm"};
    }
    if (base.category == 4) {
        return LargestFilter{4 * *base.d85, "4 d85"};
    }
    const double rise = std::max(4 * *base.d85 - of_silty_sands, 0.0);
    return LargestFilter{
        (0.40 - *base.fines) / 0.25 * rise + of_silty_sands, "from 0.7 mm at 40 % of fines to 4 d85 at 15 %"};
}

namespace {

/// How D15 of a filter, whole or washed out, stands to what holds the base.
std::vector<Criterion> judge_retention(const BaseSoil& base, const std::optional<double>& d15) {
    const std::string regraded = base.regraded_on ? fmt::format(
                                                        ", base regraded on {}{}", mm(base.regraded_on),
                                                        base.has_gap ? ", the fine end of its gap" : ""
                                                    )
                                                  : "";
    Criterion terzaghi{"terzaghi-filter", "Terzaghi and Peck", "D15F/d85B"};
    terzaghi.source = "TerzaghiPeck1948";
    terzaghi.limit = 4, terzaghi.sense = Sense::AtMost;
    judge_ratio(d15, base.d85, fmt::format("D15F {}, d85B {}{}", mm(d15), mm(base.d85), regraded), terzaghi);

    Criterion no_erosion{"no-erosion-filter", "No erosion (NRCS 2017)", "D15F/largest D15F"};
    no_erosion.source = "NRCS2017";
    no_erosion.limit = 1, no_erosion.sense = Sense::AtMost;
    const auto largest = largest_filter(base);
    judge_ratio(
        d15, largest ? std::optional(largest->d15) : std::nullopt,
        largest ? fmt::format(
                      "base of category {} ({:.3g} % fines{}): at most {} = {}; not for dispersive clay", base.category,
                      100 * *base.fines, regraded, largest->rule, mm(largest->d15)
                  )
                : "",
        no_erosion
    );

    Criterion continuing{"continuing-erosion-filter", "Continuing erosion (Foster and Fell 2001)", "D15F/d95B"};
    continuing.source = "FosterFell2001";
    continuing.limit = 9, continuing.sense = Sense::AtMost;
    judge_ratio(
        d15, base.d95, fmt::format("d95B {}{}; beyond, the filter never seals", mm(base.d95), regraded), continuing
    );
    return {terzaghi, no_erosion, continuing};
}

Criterion judge_drainage(const BaseSoil& base, const std::optional<double>& d15) {
    constexpr double least_d15 = 0.1e-3; // [m]
    Criterion drains{"permeability-filter", "Permeability (NRCS 2017)", "D15F/d15B"};
    drains.source = "NRCS2017";
    drains.limit = 5;
    judge_ratio(d15, base.d15, fmt::format("d15B {}; D15F also at least 0.1 mm", mm(base.d15)), drains);
    if (drains.value && *d15 < least_d15) {
        drains.verdict = Verdict::Unstable;
    }
    return drains;
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
    const auto d15 = size_within(filter, 0.15);
    FilterCheck check{assess_measured(filter), judge_retention(base, d15)};
    check.criteria.push_back(judge_drainage(base, d15));
    for (Criterion& criterion : judge_filter_itself(filter, check.own)) {
        check.criteria.push_back(std::move(criterion));
    }
    if (const auto washed = washed_out_d15(filter, check.own)) {
        for (Criterion& criterion : judge_retention(base, washed->d15)) {
            criterion.id += "-washed-out";
            criterion.name += ", washed out";
            criterion.remark += fmt::format("; without the filter's grains below {}", mm(washed->finer_than));
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
