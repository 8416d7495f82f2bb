#include "suffuse/stability/open_curve.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/grouped.hpp"
#include "suffuse/stability/criterion_guide.hpp"
#include "suffuse/stability/kenney_lau.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace suffuse::stability {

using grains::Grading;

namespace {

constexpr double sharp = 1e-3; // of a size: as good as a step, and still a curve that rises by more than rounding
constexpr double fine_reach = 100, coarse_reach = 4; // how much finer, and coarser, the missing grains may be
constexpr std::size_t most_of_one_end = 4;           // ways in which one open end is completed
constexpr double judged = 0.20;                      // of the mass: the least F up to which Kenney and Lau look
constexpr double alike = 1e-3;                       // of a number that two completions share but for the steps' width

std::vector<Grading> complete_fine_end(const Grading& measured) {
    if (measured.passing.front() <= 0) {
        return {measured};
    }
    const double size = measured.diameter.front(), missing = measured.passing.front(), finest = size / fine_reach;
    const auto begun_with = [&](std::vector<double> sizes, std::vector<double> passing) {
        Grading grading = measured;
        grading.diameter.insert(grading.diameter.begin(), sizes.begin(), sizes.end());
        grading.passing.insert(grading.passing.begin(), passing.begin(), passing.end());
        return grading;
    };
    std::vector<Grading> completed{
        begun_with({size * (1 - sharp)}, {0}), begun_with({finest}, {0}),
        begun_with({finest * (1 - sharp), finest}, {0, missing})};
    if (missing > judged) { // then the others have no gap where the shape curve is judged
        completed.push_back(begun_with({finest * (1 - sharp), finest, size * (1 - sharp)}, {0, judged, judged}));
    }
    return completed;
}

std::vector<Grading> complete_coarse_end(const Grading& measured) {
    if (measured.passing.back() >= 1) {
        return {measured};
    }
    const double size = measured.diameter.back(), passing = measured.passing.back(), coarsest = coarse_reach * size;
    const auto ended_with = [&](std::vector<double> sizes, std::vector<double> shares) {
        Grading grading = measured;
        grading.diameter.insert(grading.diameter.end(), sizes.begin(), sizes.end());
        grading.passing.insert(grading.passing.end(), shares.begin(), shares.end());
        return grading;
    };
    return {
        ended_with({size * (1 + sharp)}, {1}), ended_with({coarsest}, {1}),
        ended_with({coarsest, coarsest * (1 + sharp)}, {passing, 1})};
}

bool same(const std::optional<double>& a, const std::optional<double>& b) {
    if (!a || !b) {
        return !a && !b;
    }
    return *a == *b || std::abs(*a - *b) <= alike * std::abs(*a);
}

/// Three digits, or whole from a thousand on.
std::string number_text(double value) {
    return value < 1000 ? fmt::format("{:.3g}", value) : grouped(std::llround(value));
}

/// "stable where the 4 % below 0.063 mm end sharply or taper off, unstable where they lie beyond a gap": of a curve
/// with one open end, whose completions are these, in this order.
std::string verdicts_by_end(const std::vector<Assessment>& completed, std::size_t which, const std::string& missing) {
    constexpr std::array<const char*, most_of_one_end> ends{
        "end sharply", "taper off", "lie beyond a gap", "lie partly beyond a gap"};
    std::string text;
    for (const Verdict verdict : {Verdict::Stable, Verdict::Transition, Verdict::Unstable, Verdict::CannotSay}) {
        std::string where;
        for (std::size_t k = completed.size(), found = 0; k-- > 0;) {
            if (completed[k].criteria[which].verdict == verdict) {
                const char* const join = found == 0 ? "" : found == 1 ? " or " : ", ";
                where = fmt::format("{}{}{}", ends[k], join, where);
                ++found;
            }
        }
        if (!where.empty()) {
            text += fmt::format(
                "{}{} where {} {}", text.empty() ? "" : ", ", verdict_word(verdict), text.empty() ? missing : "they",
                where
            );
        }
    }
    return text;
}

/// What one criterion says of all completions.
Criterion agree(const std::vector<Assessment>& completed, std::size_t which, const std::string& missing) {
    Criterion criterion = completed.front().criteria[which];
    criterion.verified =
        std::ranges::all_of(completed, [which](const Assessment& other) { return other.criteria[which].verified; });
    bool same_verdict = true, same_value = true, same_measure = true, same_limit = true;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const Assessment& other : completed) {
        if (const auto& value = other.criteria[which].value) {
            least = std::min(least, *value), most = std::max(most, *value);
        }
        same_verdict = same_verdict && other.criteria[which].verdict == criterion.verdict;
        same_value = same_value && same(other.criteria[which].value, criterion.value);
        same_measure = same_measure && other.criteria[which].measure == criterion.measure;
        same_limit = same_limit && same(other.criteria[which].limit, criterion.limit) &&
                     same(other.criteria[which].upper, criterion.upper);
    }
    if (same_value && same_verdict) {
        return criterion;
    }
    const std::optional<double> of_sharp_ends = criterion.value; // they add no size to what was measured
    criterion.value.reset(), criterion.diameter.reset();
    const bool do_agree = same_verdict && criterion.verdict != Verdict::CannotSay;
    if (!same_measure && (do_agree || criterion.measure != shape_ratio_measure)) { // none that what was measured has
        criterion.measure = define(criterion.id).measure;
        criterion.limit.reset();
    }
    if (do_agree) {
        if (!same_limit) {
            criterion.limit.reset(), criterion.upper.reset();
        }
        criterion.remark = !same_measure
                               ? fmt::format("the measure and its limit depend on {}, the verdict does not", missing)
                               : fmt::format(
                                     "{} to {}, depending on {}{}", number_text(least), number_text(most), missing,
                                     same_limit ? "" : ", as does the limit"
                                 );
        return criterion;
    }
    criterion.verdict = Verdict::CannotSay;
    criterion.measured = same_measure ? of_sharp_ends : std::nullopt;
    criterion.remark = same_verdict || completed.size() > most_of_one_end
                           ? "needs " + missing + ", which the curve does not resolve"
                           : verdicts_by_end(completed, which, missing);
    return criterion;
}

/// A number of the shape curve depends on a missing end: then it is that of what was measured, and none of guesses.
void give_measured_ratio(Criterion& criterion, const Grading& measured, double limit) {
    const bool is_ratio = criterion.measure == shape_ratio_measure || criterion.measure == secant_ratio_measure;
    if (criterion.value || !is_ratio) {
        return;
    }
    criterion.measured.reset();
    if (const auto least = least_measured_ratio(measured, limit, criterion.measure)) {
        criterion.value = criterion.measured = least->value;
        criterion.diameter = least->at.diameter;
        criterion.remark = place_of(*least, limit) + " of what was measured; " + criterion.remark;
    }
}

} // namespace

bool is_open(const Grading& measured) {
    return !measured.passing.empty() && (measured.passing.front() > 0 || measured.passing.back() < 1);
}

std::string missing_text(const Grading& measured) {
    std::string text;
    if (const double fine = measured.passing.front(); fine > 0) {
        text = fmt::format("the {:.3g} % below {:.3g} mm", 100 * fine, 1e3 * measured.diameter.front());
    }
    if (const double coarse = 1 - measured.passing.back(); coarse > 0) {
        text += fmt::format(
            "{}the {:.3g} % above {:.3g} mm", text.empty() ? "" : " and ", 100 * coarse, 1e3 * measured.diameter.back()
        );
    }
    return text;
}

std::vector<Grading> complete_ends(const Grading& measured) {
    std::vector<Grading> completed;
    for (const Grading& begun : complete_fine_end(measured)) {
        for (Grading& whole : complete_coarse_end(begun)) {
            completed.push_back(std::move(whole));
        }
    }
    return completed;
}

Assessment assess_measured(const Grading& measured, const AssessSpec& spec) {
    if (!is_open(measured)) {
        return assess(measured, spec);
    }
    std::vector<Assessment> completed;
    for (const Grading& grading : complete_ends(measured)) {
        completed.push_back(assess(grading, spec));
    }
    Assessment found = completed.front();
    found.gap = find_gap(measured);
    found.missing_fine = measured.passing.front();
    found.missing_coarse = 1 - measured.passing.back();
    const std::string missing = missing_text(measured);
    found.finer_limit = std::ranges::min(completed, {}, &Assessment::finer_limit).finer_limit;
    for (std::size_t k = 0; k < found.criteria.size(); ++k) {
        found.criteria[k] = agree(completed, k, missing);
        give_measured_ratio(found.criteria[k], measured, found.finer_limit);
    }
    for (const Assessment& other : completed) {
        const bool same_fines = other.fines && found.fines && same(other.fines->finer_than, found.fines->finer_than);
        if (!same_fines) {
            found.fines.reset();
        }
        found.has_constrictions = found.has_constrictions &&
                                  same(other.constrictions.densest_d35, found.constrictions.densest_d35) &&
                                  same(other.constrictions.densest_passes, found.constrictions.densest_passes) &&
                                  same(other.constrictions.loosest_passes, found.constrictions.loosest_passes);
    }
    if (!found.gradients.empty()) {
        found.gradients[1] = skempton_brogan(*spec.seepage, found.criteria[kenney_lau_1985_row].verdict);
    }
    return found;
}

} // namespace suffuse::stability
