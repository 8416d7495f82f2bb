#include "suffuse/gradings/grading_shares.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace suffuse::gradings {

namespace {

std::vector<SieveRow*> coarsest_first(SievedSoil& soil) {
    std::vector<SieveRow*> sieves;
    for (SieveRow& sieve : soil.sieves) {
        sieves.push_back(&sieve);
    }
    std::ranges::stable_sort(sieves, std::greater{}, &SieveRow::diameter);
    return sieves;
}

double sum_of(const SievedSoil& soil) {
    double sum = soil.pan.value_or(0);
    for (const SieveRow& sieve : soil.sieves) {
        sum += sieve.amount;
    }
    return sum;
}

/// Amounts that fall from a sieve to a finer one are no cumulative ones. Percents that add up to 100 are each sieve's
/// own; those that add up to more are not. Nothing where neither can be said.
std::optional<ShareMeaning> recognize_retained(SievedSoil& soil) {
    const std::vector<SieveRow*> sieves = coarsest_first(soil);
    const auto falls = [](const SieveRow* coarse, const SieveRow* fine) { return fine->amount < coarse->amount; };
    if (std::ranges::adjacent_find(sieves, falls) != sieves.end()) {
        return ShareMeaning::OnSieve;
    }
    const double sum = sum_of(soil);
    if (soil.unit == ShareUnit::Mass) { // a pan below the last cumulative mass is no cumulative one
        const bool is_less = soil.pan && !sieves.empty() && *soil.pan < sieves.back()->amount;
        const bool adds_up = soil.total && std::abs(sum - *soil.total) <= 0.01 * *soil.total;
        return is_less || adds_up ? std::optional(ShareMeaning::OnSieve) : std::nullopt;
    }
    return std::abs(sum - 1) <= 0.01 ? std::optional(ShareMeaning::OnSieve)
           : sum > 1.02              ? std::optional(ShareMeaning::CumulativeRetained)
                                     : std::nullopt;
}

/// A cumulative share that rises with the size is what is finer, one that falls what is coarser.
std::optional<ShareMeaning> recognize_cumulative(SievedSoil& soil) {
    const std::vector<SieveRow*> sieves = coarsest_first(soil);
    const double change = sieves.empty() ? 0 : sieves.front()->amount - sieves.back()->amount;
    return change > 0   ? std::optional(ShareMeaning::Passing)
           : change < 0 ? std::optional(ShareMeaning::CumulativeRetained)
                        : std::nullopt;
}

bool decide_meaning(SievedSoil& soil, Problems& problems) {
    const bool is_retained = soil.meaning == ShareMeaning::Retained,
               is_cumulative = soil.meaning == ShareMeaning::Cumulative;
    if (!is_retained && !is_cumulative) {
        return true;
    }
    const auto meaning = is_retained ? recognize_retained(soil) : recognize_cumulative(soil);
    if (!meaning) {
        problems.error(
            "E506", soil.heading_place,
            is_retained ? "retained: on each sieve alone, or on it and all coarser ones?"
                        : "a cumulative share that neither rises nor falls: of the finer or of the coarser grains?",
            is_retained
                ? "name the column `retained on sieve [%]` or `cumulative retained [%]`, with [g] where masses were "
                  "weighed"
                : "name the column `passing [%]` or `cumulative retained [%]`"
        );
        return false;
    }
    const char* const why = *meaning == ShareMeaning::Passing ? "it rises with the size: read as percent passing"
                            : *meaning == ShareMeaning::CumulativeRetained
                                ? "read as retained on a sieve and all coarser ones"
                                : "read as retained on each sieve alone";
    soil.meaning = *meaning;
    if (is_cumulative && !soil.name.empty() && *meaning == ShareMeaning::Passing) {
        return true; // one of several columns: reported once for all
    }
    problems.warning(
        sheet_remark, soil.heading_place, fmt::format("{}{}", soil.name.empty() ? "" : soil.name + ": ", why)
    );
    return true;
}

/// What the sheet calls its total, next to the sum of what the sieves keep.
void check_total(const SievedSoil& soil, double sum, Problems& problems) {
    constexpr double lost = 0.01; // ASTM D6913: a loss beyond requires another test
    if (soil.total && std::abs(*soil.total - sum) > lost * sum) {
        problems.warning(
            sheet_remark, soil.end,
            fmt::format(
                "the sheet's total is {:.4g} times what its sieves and pan add up to: the sum is taken",
                *soil.total / sum
            )
        );
    }
}

/// The mass of the whole sample by what is written in the table: sieves and pan, or a total.
std::optional<double> mass_in_table(const SievedSoil& soil, double sum, double last) {
    if (soil.meaning != ShareMeaning::CumulativeRetained) {
        return soil.pan ? std::optional(sum + *soil.pan) : soil.total;
    }
    if (!soil.pan) {
        return soil.total;
    }
    return *soil.pan < last ? last + *soil.pan : *soil.pan; // its own mass, or that of all
}

/// The mass that the shares are of: the stated dry mass where the pan is not given, or where the finest grains were
/// washed away before the sieving. Empty where it could be two things, which is reported.
std::optional<double> whole_mass(const SievedSoil& soil, double sum, double last, Problems& problems) {
    constexpr double lost = 0.01; // as above
    constexpr double split = 1.9; // halves and quarters of a sample are sieved, too
    if (soil.meaning == ShareMeaning::CumulativeRetained && soil.pan.value_or(last) < last) {
        problems.warning(
            sheet_remark, soil.end, "the pan holds less than all sieves: its mass is read as its own, not cumulative"
        );
    }
    const auto held = mass_in_table(soil, sum, last);
    if (!soil.dry || (held && std::abs(*soil.dry - *held) <= lost * *held)) {
        return held.value_or(0);
    }
    const double least = held.value_or(soil.meaning == ShareMeaning::CumulativeRetained ? last : sum);
    if (*soil.dry < least) {
        problems.warning(
            sheet_remark, soil.end,
            fmt::format("a dry mass of {:.6g} g is stated, and the sieves hold {:.6g} g", 1e3 * *soil.dry, 1e3 * least),
            "what the sieves hold is taken"
        );
        return held.value_or(0);
    }
    if (held && *soil.dry > split * *held) {
        problems.error(
            "E504", soil.end,
            fmt::format(
                "sieves and pan hold {:.6g} g of a stated dry mass of {:.6g} g: was the rest washed away, or the "
                "sample "
                "split?",
                1e3 * *held, 1e3 * *soil.dry
            ),
            "add a line `loss by washing` with its mass, or leave the stated mass out"
        );
        return std::nullopt;
    }
    problems.warning(
        sheet_remark, soil.end,
        fmt::format(
            "shares are of the stated dry mass of {:.6g} g: the {:.4g} g that are not held passed the finest sieve",
            1e3 * *soil.dry, 1e3 * (*soil.dry - least)
        )
    );
    return *soil.dry;
}

/// From masses to shares of the whole sample, which only the pan, a total or a stated dry mass completes. @return
/// whether they can be.
bool divide_by_total(SievedSoil& soil, Problems& problems) {
    if (!soil.pan && !soil.total && !soil.dry) {
        problems.error(
            "E504", soil.end, "masses retained, and no line `pan`: of what mass are they a share?",
            "add `pan` and the mass that passed the finest sieve, 0 where nothing did; in a cumulative column the mass "
            "of the whole sample"
        );
        return false;
    }
    bool is_good = soil.pan.value_or(0) >= 0;
    double sum = 0, most = 0;
    for (const SieveRow& sieve : soil.sieves) {
        sum += sieve.amount, most = std::max(most, sieve.amount);
        is_good = is_good && sieve.amount >= 0;
    }
    const auto total = is_good ? whole_mass(soil, sum, most, problems) : 0;
    if (!total) {
        return false;
    }
    if (!(*total > 0 && std::isfinite(*total))) {
        problems.error(
            "E504", soil.end, "the masses retained are no part of a mass", "masses are 0 or more, and not all 0"
        );
        return false;
    }
    if (soil.pan && soil.meaning != ShareMeaning::CumulativeRetained) {
        check_total(soil, sum + *soil.pan, problems);
    }
    for (SieveRow& sieve : soil.sieves) {
        sieve.amount /= *total;
    }
    return true;
}

/// From what each sieve retains to what it and all coarser ones do.
void add_up(SievedSoil& soil) {
    double retained = 0;
    for (SieveRow* sieve : coarsest_first(soil)) {
        retained += sieve->amount;
        sieve->amount = retained;
    }
}

} // namespace

std::optional<std::vector<GradingPoint>> find_passing(SievedSoil soil, Problems& problems) {
    constexpr double rounding = 0.01; // of percentages that should add up to 100
    if (!decide_meaning(soil, problems)) {
        return std::nullopt;
    }
    const bool is_retained = soil.meaning != ShareMeaning::Passing;
    if (is_retained && soil.unit == ShareUnit::Mass && !divide_by_total(soil, problems)) {
        return std::nullopt;
    }
    if (soil.meaning == ShareMeaning::OnSieve) {
        if (soil.unit != ShareUnit::Mass && soil.pan && std::abs(sum_of(soil) - 1) > rounding) {
            problems.warning(
                sheet_remark, soil.end,
                fmt::format("sieves and pan add up to {:.4g} %: what is missing counts as finer", 100 * sum_of(soil))
            );
        }
        add_up(soil);
    }
    std::vector<GradingPoint> points;
    for (const SieveRow& sieve : soil.sieves) {
        double passing = is_retained ? 1 - sieve.amount : sieve.amount;
        if (soil.meaning == ShareMeaning::OnSieve && passing < 1e-9 && passing > -rounding) {
            passing = 0;
        }
        points.push_back({sieve.diameter, passing, sieve.diameter_place, sieve.amount_place, sieve.has_unit});
    }
    return points;
}

} // namespace suffuse::gradings
