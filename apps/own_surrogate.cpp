// A soil too wide to simulate as two fractions: where its curve is split, and at which size ratios.

#include "apps/own_surrogate.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/surrogate.hpp"
#include "suffuse/stability/unstable_split.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::apps {
namespace {

using grains::Grading;

/// @throws CaseError where no split of the curve is unstable
stability::UnstableSplit find_split(const Grading& measured, const std::string& path) {
    if (auto split = stability::find_unstable_split(measured)) {
        return *split;
    }
    throw CaseError(
        fmt::format(
            "{}: no split of this curve is unstable: {}\n  = the coarse grains hold the finer ones; there are no fines "
            "that a surrogate could show to move\n  = all criteria: suffuse assess {}\n  = to simulate a split "
            "anyway, add --fines D",
            path, stability::stable_everywhere_text(measured), shell_word(path)
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
    const stability::UnstableSplit split =
        finer_than ? stability::UnstableSplit{*finer_than, "as specified"} : find_split(measured, path);
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
