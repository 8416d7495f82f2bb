#include "suffuse/stability/unstable_split.hpp"

#include "suffuse/grains/grading.hpp"
#include "suffuse/stability/curve.hpp"
#include "suffuse/stability/filter_ratio.hpp"
#include "suffuse/stability/kenney_lau.hpp"
#include "suffuse/stability/open_curve.hpp"

#include <fmt/format.h>

namespace suffuse::stability {
namespace {

constexpr double least_shape = 1, largest_filter = 4; // Kenney and Lau 1986, Kezdi 1979

/// More fines leave no skeleton: from about 35 % on the coarse grains float in them [Skempton and Brogan 1994]. Ours.
constexpr double most_fines = 0.40;

grains::Grading sharp_ends(const grains::Grading& measured) {
    return complete_ends(measured).front();
}

double finer_limit_of(const grains::Grading& sharp) {
    return finer_limit(grains::uniformity(sharp));
}

} // namespace

std::optional<UnstableSplit> find_unstable_split(const grains::Grading& measured) {
    const grains::Grading sharp = sharp_ends(measured);
    if (const auto gap = find_gap(measured); gap && gap->finer <= most_fines) {
        return UnstableSplit{gap->fine_end, "the fine end of the gap in the curve"};
    }
    const auto shape = least_measured_ratio(measured, finer_limit_of(sharp), shape_ratio_measure);
    if (shape && shape->value < least_shape) {
        return UnstableSplit{
            shape->at.diameter,
            fmt::format("the worst split by Kenney and Lau 1986, H/F = {:.2g} of what was measured", shape->value)};
    }
    const FilterRatio filter = worst_filter_ratio(sharp, most_fines);
    if (filter.value > largest_filter) {
        return UnstableSplit{
            grains::size_at(sharp, filter.split),
            fmt::format("the worst split by Kezdi 1979, D15c/d85f = {:.2g}", filter.value)};
    }
    return std::nullopt;
}

std::string no_split_text(const grains::Grading& measured) {
    const grains::Grading sharp = sharp_ends(measured);
    const double limit = finer_limit_of(sharp);
    const auto shape = least_measured_ratio(measured, limit, shape_ratio_measure);
    const auto gap = find_gap(measured);
    return fmt::format(
        "no split of {} is unstable: {}, H/F is at least {:.2g} (Kenney and Lau 1986: 1), D15c/d85f at most {:.2g} up "
        "to {:.0f} % of fines (Kezdi 1979: 4){}",
        is_open(measured) ? "what was measured of this curve" : "this curve",
        gap ? fmt::format("{:.2g} % are below its gap, too many for a skeleton above it", 100 * gap->finer)
            : "it has no gap",
        shape ? shape->value : least_shape_ratio(sharp, limit).value, worst_filter_ratio(sharp, most_fines).value,
        100 * most_fines, is_open(measured) ? fmt::format("; {} were not judged", missing_text(measured)) : ""
    );
}

} // namespace suffuse::stability
