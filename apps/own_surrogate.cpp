// A soil too wide to simulate as two fractions: where its curve is split, and at which size ratios.

#include "apps/own_surrogate.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/shell_word.hpp"
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

/// The soil's own ratio; where that is out of reach, three up to the largest that is not.
std::vector<double> simulated_ratios(const Grading& measured, double finer_than, double most) {
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
    own.ratios = simulated_ratios(measured, split.finer_than, most);
    own.soil = grains::surrogate_of(measured, {.finer_than = split.finer_than, .size_ratio = own.ratios.back()});
    own.coarse_grains = coarse_grains_of(own.soil);
    own.grains = std::llround(std::ceil(grains_of(own.soil)));
    return own;
}

} // namespace suffuse::apps
