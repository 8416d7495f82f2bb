#include "suffuse/erosion/refined_ramp.hpp"

#include "suffuse/erosion/ramp.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::erosion {
namespace {

constexpr std::array sought_shares = {0.01, 0.1}; // of the fines' mass

constexpr double grid = 100, rounding = 1e-9; // levels in between are hundredths

/// A hundredth in the middle between two gradients; nothing where there is none between them.
std::optional<double> middle(double below, double above) {
    const double gradient = std::round(grid * (below + above) / 2) / grid;
    const bool lies_between = gradient > below + rounding && gradient < above - rounding;
    return lies_between ? std::optional(gradient) : std::nullopt;
}

/// The last hundredth below.
double just_below(double gradient) {
    return std::ceil(grid * gradient * (1 - rounding) - 1) / grid;
}

/// The gradients, and where two are far apart the multiples of the widest step between them, up to `end`.
std::vector<double> without_wide_steps(const std::vector<double>& rising, double end) {
    std::vector<double> all;
    double below = 0;
    for (const double gradient : rising) {
        const bool is_wide = gradient - below > widest_step + rounding;
        const double last = is_wide ? std::min(gradient, end) - rounding : 0;
        for (double k = std::floor(below / widest_step + rounding) + 1; k * widest_step < last; ++k) {
            all.push_back(rounded_gradient(k * widest_step));
        }
        all.push_back(gradient);
        below = gradient;
    }
    return all;
}

void insert(std::vector<double>& rising, double gradient) {
    const auto place = std::ranges::lower_bound(rising, gradient);
    if (place == rising.end() || *place > gradient) {
        rising.insert(place, gradient);
    }
}

} // namespace

RefinedRamp::RefinedRamp(std::vector<double> gradients, std::optional<double> heave, std::optional<double> specified)
    : heave_(heave) {
    if (specified && *specified < gradients.back()) {
        insert(gradients, *specified);
    }
    const auto floats = std::ranges::find_if(gradients, [&](double gradient) { return heave && gradient >= *heave; });
    if (floats != gradients.begin() && floats != gradients.end() && *heave - *(floats - 1) > gradient_width) {
        insert(gradients, just_below(*heave)); // what is mobile there is all that is mobile below heave
    }
    for (const double gradient : without_wide_steps(gradients, heave.value_or(2))) {
        ahead_.push_back({gradient});
    }
    given_count_ = ahead_.size();
}

std::optional<double> RefinedRamp::next() const {
    return ahead_.empty() ? std::nullopt : std::optional(ahead_.front().gradient);
}

std::optional<double> RefinedRamp::undone_at() const {
    if (ahead_.empty() || (heave_ && ahead_.front().gradient >= *heave_)) {
        return std::nullopt;
    }
    const double step = ahead_.front().gradient - gradient_;
    const auto sought = std::ranges::find_if(sought_shares, [&](double share) { return share_ < share; });
    const bool is_wide = step > gradient_width + rounding && middle(gradient_, ahead_.front().gradient);
    return is_wide && sought != sought_shares.end() ? std::optional(*sought) : std::nullopt;
}

/// Levels that are known to be undone are not borne before others have come before them.
void RefinedRamp::refine() {
    for (std::optional<double> limit = undone_at(); limit && ahead_.front().share >= *limit; limit = undone_at()) {
        ahead_.push_front({*middle(gradient_, ahead_.front().gradient), false, 0});
    }
}

bool RefinedRamp::take(double share) {
    const std::optional<double> limit = undone_at();
    const bool is_kept = !limit || share < *limit;
    if (!is_kept) {
        ahead_.front().share = share;
    } else {
        const bool reaches = std::ranges::any_of(sought_shares, [&](double s) { return share_ < s && share >= s; });
        gradient_ = ahead_.front().gradient, share_ = share;
        ahead_.pop_front();
        if (reaches) { // levels above were borne to find this one
            std::erase_if(ahead_, [](const Level& level) { return !level.is_given; });
        }
    }
    refine();
    return is_kept;
}

std::size_t RefinedRamp::given_left() const {
    return static_cast<std::size_t>(std::ranges::count_if(ahead_, &Level::is_given));
}

} // namespace suffuse::erosion
