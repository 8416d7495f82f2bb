#include "suffuse/gradings/grading_shares.hpp"

#include "suffuse/gradings/class_edges.hpp"
#include "suffuse/gradings/column_content.hpp"
#include "suffuse/gradings/fines_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::gradings {

namespace {

/// With what was there before, added first: the order decides on the last digit.
double sum_on_sieves(const SievedSoil& soil, double sum = 0) {
    for (const SieveRow& sieve : soil.sieves) {
        sum += sieve.amount;
    }
    return sum;
}

constexpr double lost = 0.01;  // ASTM D6913: a loss beyond requires another test
constexpr double most_off = 2; // a stated mass and a sum that differ by more are not of one sample

double sum_of(const SievedSoil& soil) {
    return sum_on_sieves(soil, soil.pan.value_or(0));
}

/// Amounts whose whole is not known but from all of them.
bool is_weighed_or_counted(const SievedSoil& soil) {
    return soil.unit == ShareUnit::Mass || soil.unit == ShareUnit::Count;
}

/// Whether its pan is "< 0.063" or a size of 0: not where grains pass these sizes.
const SieveRow* find_bound(const SievedSoil& soil) {
    const auto count = std::ranges::count_if(soil.sieves, &SieveRow::is_bound);
    const bool may_be = count == 1 && soil.sieves.size() > 1;
    const SieveRow* const bound = may_be ? &*std::ranges::find_if(soil.sieves, &SieveRow::is_bound) : nullptr;
    const bool has_finer = may_be && std::ranges::any_of(soil.sieves, [bound](const SieveRow& sieve) {
                               return sieve.diameter < bound->diameter;
                           });
    return has_finer ? nullptr : bound;
}

Amounts amounts_of(SievedSoil& soil, bool with_bound_as_pan) {
    const SieveRow* const bound = with_bound_as_pan ? find_bound(soil) : nullptr;
    Amounts amounts{{}, soil.pan, soil.total, is_weighed_or_counted(soil) ? 0.0 : 1.0};
    for (const SieveRow* sieve : coarsest_first(soil)) {
        if (sieve != bound) {
            amounts.on_sieves.push_back(sieve->amount);
        }
    }
    if (bound != nullptr) {
        amounts.pan = amounts.pan.value_or(0) + bound->amount;
    }
    return amounts;
}

PossibleMeanings possible_meanings_of(SievedSoil& soil) {
    PossibleMeanings possible = find_possible_meanings(amounts_of(soil, true));
    possible.passing = find_possible_meanings(amounts_of(soil, false)).passing;
    return possible;
}

/// Why the numbers of a column leave its meaning open, and what to write.
void complain_about_meaning(const SievedSoil& soil, const PossibleMeanings& possible, Problems& problems) {
    const std::string of_soil = soil.name.empty() ? "" : soil.name + ": ";
    const bool is_mass = soil.unit == ShareUnit::Mass;
    std::string what =
        "the numbers neither rise nor fall with the size throughout, nor add up to 100 %: which share are "
        "they?";
    std::string advice = "name the column `passing [%]`, `cumulative retained [%]` or `retained on sieve [%]`";
    if (soil.meaning == ShareMeaning::Retained) {
        what = "retained: on each sieve alone, or on it and all coarser ones?";
        advice =
            "name the column `retained on sieve [%]` or `cumulative retained [%]`, with [g] where masses were weighed";
    } else if (possible.adds_up) {
        what = fmt::format(
            "the numbers fit two readings: {}, because they add up to {}, or {}, because they {} toward the finer "
            "sieves",
            words_of(ShareMeaning::OnSieve), is_mass ? "the total" : "100 %",
            words_of(possible.passing ? ShareMeaning::Passing : ShareMeaning::CumulativeRetained),
            possible.passing ? "fall" : "rise"
        );
        advice = fmt::format(
            "name the column `retained on sieve [%]` or `{}`",
            possible.passing ? "passing [%]" : "cumulative retained [%]"
        );
    }
    problems.error("E506", soil.heading_place, of_soil + what, advice);
}

bool decide_meaning(SievedSoil& soil, Problems& problems) {
    const ShareMeaning named = soil.meaning;
    const PossibleMeanings possible = possible_meanings_of(soil);
    const auto meaning = choose_meaning(named, possible);
    if (!meaning) {
        complain_about_meaning(soil, possible, problems);
        return false;
    }
    soil.meaning = *meaning;
    const bool is_one_of_several = !soil.name.empty() && *meaning == ShareMeaning::Passing; // reported once for all
    if (named == *meaning || is_one_of_several) {
        return true;
    }
    const char* const why = named == ShareMeaning::CumulativeRetained ? "no cumulative share, because the numbers add "
                                                                        "up to 100 %: "
                            : *meaning == ShareMeaning::Passing       ? "it rises with the size: "
                            : *meaning == ShareMeaning::OnSieve && named != ShareMeaning::Retained
                                ? "the numbers add up to 100 %: "
                                : "";
    problems.warning(
        sheet_remark, soil.heading_place,
        fmt::format("{}{}read as {}", soil.name.empty() ? "" : soil.name + ": ", why, words_of(*meaning))
    );
    return true;
}

/// A row that bounds the grains is the pan of a column of what sieves keep.
void settle_bound(SievedSoil& soil) {
    const SieveRow* const bound = soil.meaning == ShareMeaning::Passing ? nullptr : find_bound(soil);
    if (bound != nullptr) {
        soil.pan = soil.pan.value_or(0) + bound->amount;
        soil.sieves.erase(soil.sieves.begin() + (bound - soil.sieves.data()));
    }
}

/// Stones at the nodes of a grid: their number is as their volume is in a sieved sample.
void remark_on_count(const SievedSoil& soil, Problems& problems) {
    problems.warning(
        sheet_remark, soil.heading_place,
        fmt::format("{:.6g} stones are counted: shares of their number are read as shares by mass", sum_of(soil)),
        "valid for stones picked on a grid (Kellerhals and Bray 1971); if all grains were counted, add --by number"
    );
}

/// What the sheet calls its total, next to the sum of what the sieves keep. @return whether both may be of one sample
bool check_total(const SievedSoil& soil, double sum, Problems& problems) {
    const auto is_whole = [&](double whole) { return std::abs(*soil.total - whole) <= lost * whole; };
    if (!soil.total || is_whole(sum) || is_whole(sum + soil.lost)) {
        return true;
    }
    if (*soil.total > most_off * sum || sum > most_off * *soil.total) {
        const char* const unit = soil.unit == ShareUnit::Count ? "" : " g";
        const double scale = soil.unit == ShareUnit::Count ? 1 : 1e3;
        problems.error(
            "E504", soil.end,
            fmt::format(
                "the sheet's total is {:.6g}{}, and its sieves and pan add up to {:.6g}{}", scale * *soil.total, unit,
                scale * sum, unit
            ),
            "correct the numbers, or leave the total out"
        );
        return false;
    }
    problems.warning(
        sheet_remark, soil.end,
        fmt::format(
            "the sheet's total is {:.4g} times what its sieves{} add up to: the sum is taken",
            *soil.total / (sum + soil.lost), soil.lost > 0 ? ", pan and loss" : " and pan"
        )
    );
    return true;
}

/// The mass of the whole sample by what is written in the table: sieves and pan, or a total.
std::optional<double> mass_in_table(const SievedSoil& soil, double last) {
    if (!soil.pan) {
        return soil.total;
    }
    return soil.meaning != ShareMeaning::CumulativeRetained ? sum_on_sieves(soil) + *soil.pan
           : *soil.pan < last                               ? last + *soil.pan
                                                            : *soil.pan; // its own mass, or that of all
}

/// The mass that the shares are of: the stated dry mass where the pan is not given, or where the finest grains were
/// washed away before the sieving. Empty where it could be two things, which is reported.
std::optional<double> whole_mass(const SievedSoil& soil, double last, Problems& problems) {
    constexpr double split = 1.9; // halves and quarters of a sample are sieved, too
    if (soil.meaning == ShareMeaning::CumulativeRetained && soil.pan.value_or(last) < last) {
        problems.warning(
            sheet_remark, soil.end, "the pan holds less than all sieves: its mass is read as its own, not cumulative"
        );
    }
    const auto held = mass_in_table(soil, last);
    if (!soil.dry || (held && std::abs(*soil.dry - *held) <= lost * *held)) {
        return held.value_or(0);
    }
    const double least = held.value_or(soil.meaning == ShareMeaning::CumulativeRetained ? last : sum_on_sieves(soil));
    if (*soil.dry * most_off < least) {
        problems.error(
            "E504", soil.end,
            fmt::format("a dry mass of {:.6g} g is stated, and the sieves hold {:.6g} g", 1e3 * *soil.dry, 1e3 * least),
            "correct the numbers, or leave the stated mass out"
        );
        return std::nullopt;
    }
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
                "sample split?",
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
    const double most = soil.sieves.empty() ? 0 : std::ranges::max(soil.sieves, {}, &SieveRow::amount).amount;
    if (!soil.pan && !soil.total && !soil.dry && soil.is_of_largest) {
        soil.total = most;
        problems.warning(
            sheet_remark, soil.heading_place,
            fmt::format("what is retained is read as a share of the largest, {:.6g} g", 1e3 * most)
        );
    }
    if (!soil.pan && !soil.total && !soil.dry) {
        problems.error(
            "E504", soil.end, "masses retained, and no line `pan`: of what mass are they a share?",
            "add `pan` and the mass that passed the finest sieve, 0 where nothing did; in a cumulative column the mass "
            "of the whole sample"
        );
        return false;
    }
    if (soil.dry) { // what was lost is not held, and has not passed the finest sieve
        *soil.dry -= soil.lost;
    }
    if (soil.total && !soil.pan) {
        *soil.total -= soil.lost;
    }
    const bool is_good = soil.pan.value_or(0) >= 0 &&
                         std::ranges::all_of(soil.sieves, [](const SieveRow& sieve) { return sieve.amount >= 0; });
    const auto total = is_good ? whole_mass(soil, most, problems) : 0;
    if (!total) {
        return false;
    }
    if (!(*total > 0 && std::isfinite(*total))) {
        problems.error(
            "E504", soil.end, "the masses retained are no part of a mass", "masses are 0 or more, and not all 0"
        );
        return false;
    }
    if (soil.pan && soil.meaning != ShareMeaning::CumulativeRetained &&
        !check_total(soil, sum_on_sieves(soil) + *soil.pan, problems)) {
        return false;
    }
    for (SieveRow& sieve : soil.sieves) {
        sieve.amount /= *total;
    }
    return true;
}

/// From masses that pass to shares of the total or, without one, of the largest.
bool divide_by_most(SievedSoil& soil, Problems& problems) {
    const auto sieves = coarsest_first(soil);
    const double most = sieves.empty() ? 0 : sieves.front()->amount,
                 whole = soil.total.value_or(soil.dry.value_or(most));
    const std::string unit = soil.unit == ShareUnit::Count ? "" : " g";
    const double scale = unit.empty() ? 1 : 1e3;
    if (!(whole > 0 && most <= whole)) {
        problems.error(
            "E504", soil.end,
            fmt::format("{:.6g}{} pass of a total of {:.6g}{}", scale * most, unit, scale * whole, unit),
            "what passes is 0 or more, and never above the total"
        );
        return false;
    }
    problems.warning(
        sheet_remark, soil.heading_place,
        fmt::format(
            "what passes is read as a share of {} {:.6g}{}", whole > most ? "the total," : "the largest,",
            scale * whole, unit
        )
    );
    for (SieveRow& sieve : soil.sieves) {
        sieve.amount /= whole;
    }
    return true;
}

bool divide_by_whole(SievedSoil& soil, Problems& problems) {
    if (soil.unit == ShareUnit::Count) {
        soil.pan = soil.pan.value_or(0); // stones that are smaller were not picked
        if (!soil.is_by_number) {
            remark_on_count(soil, problems);
        }
    }
    return soil.meaning == ShareMeaning::Passing ? divide_by_most(soil, problems) : divide_by_total(soil, problems);
}

/// Percents of which some were lost become those of the rest.
void leave_loss_out(SievedSoil& soil) {
    constexpr double rounding = 0.01; // as below
    if (is_weighed_or_counted(soil) || !soil.pan || std::abs(sum_of(soil) + soil.lost - 1) > rounding) {
        return;
    }
    for (SieveRow& sieve : soil.sieves) {
        sieve.amount /= 1 - soil.lost;
    }
    *soil.pan /= 1 - soil.lost;
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

const char* words_of(ShareMeaning meaning) {
    return meaning == ShareMeaning::Passing              ? "percent passing"
           : meaning == ShareMeaning::CumulativeRetained ? "retained on a sieve and all coarser ones"
                                                         : "retained on each sieve alone";
}

void agree_on_meaning(std::vector<SievedSoil>& soils) {
    PossibleMeanings common{true, true, true, true};
    bool are_unstated = soils.size() > 1;
    for (SievedSoil& soil : soils) {
        are_unstated = are_unstated && soil.meaning == ShareMeaning::Unstated;
        common = in_common(common, possible_meanings_of(soil));
    }
    const auto meaning = are_unstated ? choose_meaning(ShareMeaning::Unstated, common) : std::nullopt;
    if (meaning == ShareMeaning::OnSieve || meaning == ShareMeaning::CumulativeRetained) {
        for (SievedSoil& soil : soils) {
            soil.meaning = *meaning == ShareMeaning::OnSieve ? ShareMeaning::Retained : ShareMeaning::Cumulative;
        }
    }
}

std::optional<std::vector<GradingPoint>> find_passing(SievedSoil& soil, Problems& problems) {
    constexpr double rounding = 0.01; // of percentages that should add up to 100
    if (!decide_meaning(soil, problems)) {
        return std::nullopt;
    }
    settle_bound(soil);
    const bool is_retained = soil.meaning != ShareMeaning::Passing;
    if (is_weighed_or_counted(soil) && !(settle_fines(soil, problems) && divide_by_whole(soil, problems))) {
        return std::nullopt;
    }
    settle_edges(soil, problems);
    if (soil.meaning == ShareMeaning::OnSieve) {
        leave_loss_out(soil);
        if (!is_weighed_or_counted(soil) && soil.pan && std::abs(sum_of(soil) - 1) > 2 * rounding + 1e-9) {
            problems.error(
                "E504", soil.end,
                fmt::format(
                    "the sieves retain {:.4g} % and the pan {:.4g} %: together {:.4g} % where 100 % are expected",
                    100 * sum_on_sieves(soil), 100 * *soil.pan, 100 * sum_of(soil)
                ),
                "correct the numbers, or leave the pan out if what is missing is finer than all sieves"
            );
            return std::nullopt;
        }
        if (!is_weighed_or_counted(soil) && soil.pan && std::abs(sum_of(soil) - 1) > rounding) {
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
        constexpr double printed = 5e-6; // the least that sheets print
        if (soil.meaning == ShareMeaning::OnSieve && passing < printed && passing > -rounding) {
            passing = 0;
        }
        points.push_back({sieve.diameter, passing, sieve.diameter_place, sieve.amount_place, sieve.has_unit});
    }
    close_curve(soil, points);
    if (soil.is_by_number && !weigh_by_size(soil, points, problems)) {
        return std::nullopt;
    }
    return points;
}

} // namespace suffuse::gradings
