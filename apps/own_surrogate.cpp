// A soil too wide to simulate as two fractions: where its curve is split, and at which size ratios.

#include "apps/own_surrogate.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/surrogate.hpp"
#include "suffuse/stability/curve.hpp"
#include "suffuse/stability/filter_ratio.hpp"
#include "suffuse/stability/kenney_lau.hpp"
#include "suffuse/stability/open_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::apps {
namespace {

using grains::Grading;

struct Split {
    double finer_than = 0; ///< [m]
    std::string reason;
};

/// Where the criteria find the soil least stable: at its gap, else where the shape curve is worst, else at the split
/// with the worst filter ratio. @throws CaseError where none of them finds it unstable.
Split find_split(const Grading& measured, const std::string& path) {
    constexpr double least_shape = 1, largest_filter = 4; // Kenney and Lau 1986, Kezdi 1979
    const Grading sharp = stability::complete_ends(measured).front();
    if (const auto gap = stability::find_gap(sharp)) {
        return {gap->fine_end, "the fine end of the gap in the curve"};
    }
    const double limit = stability::finer_limit(grains::uniformity(sharp));
    const auto shape = stability::least_measured_ratio(measured, limit, stability::shape_ratio_measure);
    if (shape && shape->value < least_shape) {
        return {
            shape->at.diameter,
            fmt::format("the worst split by Kenney and Lau 1986, H/F = {:.2g} of what was measured", shape->value)};
    }
    const stability::FilterRatio filter = stability::worst_filter_ratio(sharp);
    if (filter.value > largest_filter) {
        return {
            grains::size_at(sharp, filter.split),
            fmt::format("the worst split by Kezdi 1979, D15c/d85f = {:.2g}", filter.value)};
    }
    throw CaseError(
        fmt::format(
            "{}: no split of this curve is unstable: it has no gap, H/F is at least {:.2g} (Kenney and Lau 1986: 1), "
            "D15c/d85f at most {:.2g} (Kezdi 1979: 4)\n  = the coarse grains hold the finer ones; there are no fines "
            "that a surrogate could show to move\n  = all criteria: suffuse assess {}\n  = to simulate a split "
            "anyway, add --fines D",
            path, shape ? shape->value : stability::least_shape_ratio(sharp, limit).value, filter.value,
            shell_word(path)
        ),
        path
    );
}

double to_half(double value) {
    return std::floor(2 * value) / 2;
}

/// Of a sample with the least coarse grains.
double grains_at(double ratio, double content) {
    return surrogate_coarse_grains * (1 + content / (1 - content) * ratio * ratio * ratio);
}

/// The soil's own ratio; where that is out of reach, three up to the largest that is not.
std::vector<double> simulated_ratios(double of_soil, double content, double most) {
    constexpr double tried = 10; // the pore network and `wide` were compared with others' numbers up to that
    constexpr std::array steps{0.4, 0.65};
    if (grains_at(of_soil, content) <= most) {
        return {of_soil};
    }
    const double reach = std::cbrt((most / surrogate_coarse_grains - 1) * (1 - content) / content);
    const double largest = to_half(std::min(reach, tried));
    std::vector<double> ratios;
    ratios.reserve(steps.size() + 1);
    for (const double step : steps) {
        ratios.push_back(std::max(to_half(step * largest), to_half(grains::least_size_ratio) + 0.5));
    }
    ratios.push_back(largest);
    return ratios;
}

} // namespace

OwnSurrogate
model_surrogate(const Grading& measured, const std::string& path, std::optional<double> finer_than, double most) {
    const Split split = finer_than ? Split{*finer_than, "as specified"} : find_split(measured, path);
    OwnSurrogate own;
    own.name = soil_name(path);
    own.reason = split.reason;
    own.soil = grains::surrogate_of(measured, split.finer_than);
    own.ratios = simulated_ratios(own.soil.surrogate->ratio_of_soil, own.soil.fines_content, most);
    if (own.ratios.back() < own.soil.surrogate->ratio_of_soil) {
        own.soil = grains::surrogate_of(measured, split.finer_than, own.ratios.back());
    }
    own.grains = std::llround(std::ceil(grains_at(own.ratios.back(), own.soil.fines_content)));
    return own;
}

} // namespace suffuse::apps
