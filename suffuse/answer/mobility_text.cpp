#include "suffuse/answer/mobility_text.hpp"

#include "suffuse/answer/plain_numbers.hpp"
#include "suffuse/base/factor_of_safety.hpp"
#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::answer {
namespace {

using study::MobilityStory;
using study::Scatter;

} // namespace

std::string gradient_text(const Scatter& gradient) {
    return gradient.standard_deviation > 0 ? fmt::format("{:.2f} ± {:.2f}", gradient.mean, gradient.standard_deviation)
                                           : fmt::format("{:.2f}", gradient.mean);
}

bool is_almost_nothing(double share) {
    return share < 0.0005;
}

std::string moved_text(double share) {
    return is_almost_nothing(share) ? "less than 0.1 %" : short_number(100 * share, 2) + " %";
}

std::string sifting_text(const MobilityStory& story) {
    const auto share = [](const erosion::MobilityResult* sample) { return sample->sifting_mass_share; };
    return (story.of_sample.size() > 1 ? "up to " : "") +
           moved_text(share(*std::ranges::max_element(story.of_sample, {}, share)));
}

std::string distance_text(const MobilityStory& story) {
    return story.moved == 0.5 ? "half a diameter" : short_number(story.moved, 2) + " diameters";
}

double end_of_ramp(const MobilityStory& story) {
    return story.one().ramp.back().gradient;
}

bool goes_to_heave(const MobilityStory& story) {
    return story.heave.seeds > 0 && end_of_ramp(story) >= story.heave.mean;
}

std::string end_text(const MobilityStory& story) {
    return goes_to_heave(story) ? "below heave" : fmt::format("up to i = {:.2f}", end_of_ramp(story));
}

std::string heave_factor_text(const MobilityStory& story) {
    return factor_text(story.heave.mean / *story.specified_gradient);
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
    if (!by_rule) {
        return false;
    }
    const bool moves = is_met(story.safety, story), is_known = moves && !story.at_most_1;
    const bool is_safe = is_known ? story.safety.mean >= 1 : !moves && story.safety_at_least.value_or(0) >= 1;
    const bool is_unsafe = moves && story.safety.mean < 1;
    return *by_rule >= 1 ? is_unsafe : is_safe;
}

} // namespace suffuse::answer
