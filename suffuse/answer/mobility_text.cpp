#include "suffuse/answer/mobility_text.hpp"

#include "suffuse/answer/plain_numbers.hpp"
#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::answer {
namespace {

using study::MobilityStory;
using study::Scatter;

} // namespace

std::string gradient_text(const Scatter& gradient) {
    return gradient.standard_deviation > 0 ? fmt::format("{:.2f} ± {:.2f}", gradient.mean, gradient.standard_deviation)
                                           : fmt::format("{:.2f}", gradient.mean);
}

std::string moved_text(double share) {
    const double percent = 100 * share;
    return percent < 0.05 ? "less than 0.1 %" : short_number(percent, 2) + " %";
}

std::string sifting_text(const MobilityStory& story) {
    const auto share = [](const erosion::MobilityResult* sample) { return sample->sifting_mass_share; };
    return (story.of_sample.size() > 1 ? "up to " : "") +
           moved_text(share(*std::ranges::max_element(story.of_sample, {}, share)));
}

std::string distance_text(const MobilityStory& story) {
    return story.moved == 0.5 ? "half a diameter" : short_number(story.moved, 2) + " diameters";
}

std::string bound_text(double least) {
    constexpr double rounding = 1e-9;
    return fixed(std::floor(10 * least + rounding) / 10, 1);
}

bool is_met(const Scatter& gradient, const MobilityStory& story) {
    return 2 * static_cast<std::size_t>(gradient.seeds) > story.of_sample.size();
}

double end_of_ramp(const MobilityStory& story) {
    return story.one().ramp.back().gradient;
}

bool goes_to_heave(const MobilityStory& story) {
    return story.heave.seeds > 0 && end_of_ramp(story) >= story.heave.mean;
}

bool is_almost_none(double gradient) {
    return gradient < 0.005;
}

std::optional<double> safety_by_rule(const MobilityStory& story) {
    if (!story.specified_gradient || !(*story.specified_gradient > 0) || story.skempton_brogan.seeds == 0) {
        return std::nullopt;
    }
    return story.skempton_brogan.mean / *story.specified_gradient;
}

bool do_disagree(const MobilityStory& story) {
    const std::optional<double> by_rule = safety_by_rule(story);
    if (!by_rule || !(is_met(story.safety, story) || story.safety_at_least)) {
        return false;
    }
    const double moved = is_met(story.safety, story) ? story.safety.mean : *story.safety_at_least;
    return (moved >= 1) != (*by_rule >= 1);
}

} // namespace suffuse::answer
