// A soil too wide to simulate as two fractions: where its curve is split, and at which size ratios.

#include "apps/own_surrogate.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/sampling.hpp"
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
stability::UnstableSplit find_split(const Grading& measured, const std::string& path, const std::string& words) {
    if (auto split = stability::find_unstable_split(measured)) {
        return *split;
    }
    throw CaseError(
        fmt::format(
            "{}: {}\n  = so there is no size at which to split it for a surrogate\n  = all criteria: suffuse assess "
            "{}\n"
            "  = to simulate a split anyway, add --fines D",
            path, stability::no_split_text(measured), words
        ),
        path
    );
}

constexpr double steps_of_ratio = 0.5; // between the ratios that are tried

double to_half(double value) {
    return std::floor(value / steps_of_ratio) * steps_of_ratio;
}

/// So many that the cell is about three of the largest wide.
std::int64_t coarse_grains_of(const grains::Soil& soil) {
    constexpr double least = 60, of_width_two = 105;
    return std::llround(std::max(least, of_width_two * std::pow(soil.surrogate->coarse_width / 2, 2.5)));
}

/// Of a sample with so many coarse grains.
double grains_of(const grains::Soil& soil) {
    const double content = soil.fines_content,
                 finer = grains::grains_per_volume(*soil.fines) / grains::grains_per_volume(*soil.coarse);
    return static_cast<double>(coarse_grains_of(soil)) * (1 + content / (1 - content) * finer);
}

/// The soil's own ratio; where that is out of reach, two or three up to the largest that is not.
/// @throws CaseError where fewer are in reach
std::vector<double> simulated_ratios(const Grading& measured, double finer_than, double most, const std::string& path) {
    constexpr double tried = 10; // the pore network and `wide` were compared with others' numbers up to that
    constexpr std::array steps{0.4, 0.65};
    const grains::Soil own = grains::surrogate_of(measured, {.finer_than = finer_than});
    if (grains_of(own) <= most) {
        return {own.surrogate->size_ratio};
    }
    const double least = to_half(grains::least_size_ratio) + steps_of_ratio;
    double largest = std::max(least, to_half(std::min(own.surrogate->size_ratio, tried)));
    while (largest > least &&
           grains_of(grains::surrogate_of(measured, {.finer_than = finer_than, .size_ratio = largest})) > most) {
        largest -= steps_of_ratio;
    }
    std::vector<double> ratios;
    ratios.reserve(steps.size() + 1);
    for (const double step : steps) {
        ratios.push_back(std::max(to_half(step * largest), least));
    }
    ratios.push_back(largest);
    const auto repeated = std::ranges::unique(ratios);
    ratios.erase(repeated.begin(), repeated.end());
    if (ratios.size() < 2) {
        throw CaseError(
            fmt::format(
                "{}: split at {:.4g} mm, {:.3g} % of the mass are fines with a size ratio of {:.3g}: {:.0f} grains do "
                "not reach a ratio of {:g}, and nothing can be extrapolated\n  = help: --particles N allows more, "
                "--fines "
                "D splits it elsewhere",
                path, 1e3 * finer_than, 100 * own.fines_content, own.surrogate->ratio_of_soil, most,
                least + steps_of_ratio
            ),
            path
        );
    }
    return ratios;
}

} // namespace

OwnSurrogate model_surrogate(
    const Grading& measured, const std::string& path, std::optional<double> finer_than, double most,
    const std::string& words
) {
    const stability::UnstableSplit split =
        finer_than ? stability::UnstableSplit{*finer_than, "as specified"} : find_split(measured, path, words);
    OwnSurrogate own;
    own.name = soil_name(path);
    own.reason = split.reason;
    own.ratios = simulated_ratios(measured, split.finer_than, most, path);
    own.soil = grains::surrogate_of(measured, {.finer_than = split.finer_than, .size_ratio = own.ratios.back()});
    own.coarse_grains = coarse_grains_of(own.soil);
    own.grains = std::llround(std::ceil(grains_of(own.soil)));
    return own;
}

bool is_surrogate_in_reach(const Grading& measured, std::optional<double> finer_than, double most) {
    try {
        model_surrogate(measured, "", finer_than, most, "");
        return true;
    } catch (const CaseError&) {
        return false;
    }
}

} // namespace suffuse::apps
