#include "suffuse/answer/mobility_headlines.hpp"

#include "suffuse/answer/mobility_text.hpp"
#include "suffuse/answer/plain_numbers.hpp"
#include "suffuse/base/factor_of_safety.hpp"
#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::answer {
namespace {

using study::MobilityStory;
using study::Scatter;

/// Half the step of the ramp within which a gradient was found, rounded up: between two levels nobody looked.
double within_step(const MobilityStory& story, double gradient) {
    constexpr double digits = 100, rounding = 1e-9;
    double before = 0;
    for (const erosion::MobilityStep& step : story.one().ramp) {
        if (step.gradient >= gradient) {
            return std::ceil(digits * (step.gradient - before) / 2 - rounding) / digits;
        }
        before = step.gradient;
    }
    return 0;
}

const char* const still_moving = "fines were still moving when the gradient rose";

Headline gradient_headline(const MobilityStory& story, const Scatter& gradient, bool at_most, std::string label) {
    const std::string value =
        is_almost_none(gradient.mean) ? "< 0.01" : (at_most ? "≤ " : "") + fixed(gradient.mean, 2);
    if (gradient.seeds > 1) {
        return with_certainty(
            {value, std::move(label), fmt::format("{} samples", gradient.seeds), spread_text(gradient, 1, 2)}, gradient
        );
    }
    if (at_most) {
        return with_certainty({value, std::move(label), still_moving}, gradient);
    }
    const std::string spread = is_almost_none(gradient.mean) ? "" : "± " + fixed(within_step(story, gradient.mean), 2);
    return {value, std::move(label), "within a step of the ramp; no replicate", spread};
}

/// Where the soil floats at the specified gradient, and few fines move before.
Headline heave_safety_headline(const MobilityStory& story) {
    return with_certainty(
        {heave_factor_text(story), "Factor of safety against heave",
         fmt::format(
             "the water lifts the whole soil before 1 % of the fines move; specified {:.2f}", *story.specified_gradient
         ),
         spread_text(story.heave, 1 / *story.specified_gradient, 2)},
        story.heave
    );
}

Headline safety_headline(const MobilityStory& story) {
    Headline headline{"", fmt::format("Factor of safety before 1 % move {}", distance_text(story)), ""};
    const double specified = *story.specified_gradient;
    const std::string at_most = story.at_most_1 ? "≤ " : "";
    if (!is_met(story.safety, story)) {
        headline.value = "≥ " + least_factor_text(*story.safety_at_least);
        headline.detail = fmt::format(
            "{} before 1 % of the fines move; specified {:.2f}",
            goes_to_heave(story) ? "the soil heaves" : "the ramp ends", specified
        );
        if (const std::size_t samples = story.of_sample.size(); samples < 2) {
            headline = with_certainty(std::move(headline), story.safety);
        } else {
            headline.detail += fmt::format("; the least of {} samples", count_in_words(samples));
        }
        if (story.safety.seeds > 0) {
            headline.detail += fmt::format(
                ", of which {} moves 1 % before", count_in_words(static_cast<std::size_t>(story.safety.seeds))
            );
        }
    } else if (story.safety.seeds > 1) {
        headline.value = at_most + factor_text(story.safety.mean);
        headline.spread = spread_text(story.safety, 1, decimals_of_factor(story.safety.mean));
        headline.detail = fmt::format("{} samples; specified {:.2f}", story.safety.seeds, specified);
        headline = with_certainty(std::move(headline), story.safety);
    } else if (story.at_most_1) {
        headline.value = at_most + factor_text(story.safety.mean);
        headline.detail = still_moving;
        headline = with_certainty(std::move(headline), story.safety);
    } else {
        const double half = within_step(story, story.moves_1.mean) / specified;
        headline.value = factor_text(story.safety.mean);
        headline.detail = fmt::format(
            "{} to {} within a step of the ramp; no replicate", factor_text(std::max(0.0, story.safety.mean - half)),
            factor_text(story.safety.mean + half)
        );
    }
    const bool moves_late = !is_met(story.safety, story) && goes_to_heave(story);
    if (moves_late || (story.heave.seeds > 0 && story.heave.mean < story.moves_1.mean)) { // what fails first decides
        headline.caution =
            fmt::format("The whole soil heaves before, at {} times the specified gradient.", heave_factor_text(story));
    }
    if (do_disagree(story)) {
        headline.caution = fmt::format(
            "Skempton and Brogan's rule gives {}; the reason is below.", factor_text(*safety_by_rule(story))
        );
    }
    return headline;
}

} // namespace

std::vector<Headline> mobility_headlines(const MobilityStory& story) {
    std::vector<Headline> headlines;
    const bool floats = !is_met(story.moved_at_specified, story) && story.lifted_at_specified > 0;
    if (floats && !is_met(story.safety, story)) {
        headlines.push_back(heave_safety_headline(story));
    } else if (story.specified_gradient && (is_met(story.safety, story) || story.safety_at_least)) {
        headlines.push_back(safety_headline(story));
    }
    if (is_met(story.moves_1, story)) {
        headlines.push_back(
            gradient_headline(story, story.moves_1, story.at_most_1, "Gradient that moves 1 % of the fines")
        );
    }
    if (is_met(story.moves_10, story)) {
        headlines.push_back(gradient_headline(story, story.moves_10, story.at_most_10, "Gradient that moves 10 %"));
    }
    if (story.heave.seeds > 0) {
        const bool is_critical = is_upward(story.one());
        Headline heave = {
            fixed(story.heave.mean, 2), is_critical ? "Gradient of heave, i_c" : "Gradient of heave",
            is_critical ? "by the weight of the soil (Terzaghi)" : "of this flow: i_c over the sine of its rise"};
        heave.spread = spread_text(story.heave, 1, 2);
        headlines.push_back(with_certainty(std::move(heave), story.heave));
    }
    return headlines;
}

} // namespace suffuse::answer
