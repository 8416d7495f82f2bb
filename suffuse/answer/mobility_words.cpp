#include "suffuse/answer/mobility_words.hpp"

#include "suffuse/answer/plain_numbers.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/casefile/stage_traits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::answer {
namespace {

using study::MobilityStory;
using study::Scatter;

constexpr double as_good_as_equal = 1.3; // of two gradients: nearer than samples of one soil are
constexpr double much_sifting = 0.1;     // of the fines' mass: then the gradient that moves a tenth says little

std::string gradient_text(const Scatter& gradient) {
    return gradient.standard_deviation > 0 ? fmt::format("{:.2f} ± {:.2f}", gradient.mean, gradient.standard_deviation)
                                           : fmt::format("{:.2f}", gradient.mean);
}

std::string samples_text(const MobilityStory& story) {
    return story.of_sample.size() == 1 ? "one sample" : fmt::format("{} samples", story.of_sample.size());
}

/// Whether more than half of the samples have it.
bool is_met(const Scatter& gradient, const MobilityStory& story) {
    return 2 * static_cast<std::size_t>(gradient.seeds) > story.of_sample.size();
}

double end_of_ramp(const MobilityStory& story) {
    return story.one().ramp.back().gradient;
}

/// Whether the ramp goes as far as the gradient that lifts the whole soil.
bool goes_to_heave(const MobilityStory& story) {
    return story.heave.seeds > 0 && end_of_ramp(story) >= story.heave.mean;
}

/// Ramps know a gradient to 0.01.
bool is_almost_none(double gradient) {
    return gradient < 0.005;
}

/// "i = 0.30", "i = 0.30 or less", "i < 0.01". @param name "i = " where it is not said yet
std::string reached_text(const Scatter& gradient, bool at_most, const char* name) {
    return is_almost_none(gradient.mean) ? "i < 0.01" : name + gradient_text(gradient) + (at_most ? " or less" : "");
}

std::string moved_text(double share) {
    const double percent = 100 * share;
    return percent < 0.05 ? "less than 0.1 %" : short_number(percent, 2) + " %";
}

/// " in 2 of 3 samples" where others do not reach it.
std::string met_by(const Scatter& gradient, const MobilityStory& story) {
    return static_cast<std::size_t>(gradient.seeds) == story.of_sample.size()
               ? ""
               : fmt::format(" in {} of {} samples", gradient.seeds, story.of_sample.size());
}

/// Largest over the samples: "12 %", "up to 12 %".
std::string sifting_text(const MobilityStory& story) {
    const auto share = [](const erosion::MobilityResult* sample) { return sample->sifting_mass_share; };
    return (story.of_sample.size() > 1 ? "up to " : "") +
           moved_text(share(*std::ranges::max_element(story.of_sample, {}, share)));
}

/// "moves 1 % of the fines at i = 0.30, a tenth at 0.51".
std::string what_moves(const MobilityStory& story) {
    const bool heaves_first = story.heave.seeds > 0 && story.moves_1.mean >= story.heave.mean;
    const std::string end = goes_to_heave(story) ? "below heave" : fmt::format("up to i = {:.2f}", end_of_ramp(story));
    if (!is_met(story.moves_1, story) || heaves_first) {
        return fmt::format("moves less than 1 % of the fines {}", heaves_first ? "below heave" : end);
    }
    return fmt::format(
               "moves 1 % of the fines at {}{}, ", reached_text(story.moves_1, story.at_most_1, "i = "),
               met_by(story.moves_1, story)
           ) +
           (is_met(story.moves_10, story) ? fmt::format(
                                                "a tenth at {}{}", reached_text(story.moves_10, story.at_most_10, ""),
                                                met_by(story.moves_10, story)
                                            )
                                          : fmt::format("less than a tenth {}", end));
}

/// "; the soil heaves at 1.05".
std::string heave_text(const MobilityStory& story, const std::string& gradient) {
    if (story.heave.seeds == 0) {
        return "; it cannot lift the soil";
    }
    const bool is_first = !is_met(story.moves_1, story) && goes_to_heave(story);
    return fmt::format("; the soil heaves at {}{}", gradient, is_first ? " first" : "");
}

/// "moves 0.2 %".
std::string moved_at_specified_text(const MobilityStory& story) {
    return fmt::format(
        "moves {}{}", story.moved_at_specified_at_least ? "at least " : "", moved_text(story.moved_at_specified.mean)
    );
}

/// "half a diameter": what a grain moves along the flow before it counts.
std::string distance_text(const MobilityStory& story) {
    return story.moved == 0.5 ? "half a diameter" : short_number(story.moved, 2) + " diameters";
}

/// A lower bound, which rounding does not raise.
std::string bound_text(double least) {
    constexpr double rounding = 1e-9;
    return fixed(std::floor(10 * least + rounding) / 10, 1);
}

/// "factor of safety 1.5 before 1 % move half a diameter": the number, and what it rests on.
std::string safety_text(const MobilityStory& story) {
    const std::string factor = !is_met(story.safety, story)
                                   ? "at least " + bound_text(story.safety_at_least.value_or(0))
                               : story.safety.standard_deviation > 0
                                   ? fmt::format("{:.1f} ± {:.1f}", story.safety.mean, story.safety.standard_deviation)
                                   : fmt::format("{:.1f}", story.safety.mean);
    return fmt::format("factor of safety {} before 1 % move {}", factor, distance_text(story));
}

/// Of the shares that move at the specified gradient, others than the one that counts.
std::string compare_measures(const MobilityStory& story) {
    const std::vector<erosion::MobilityStep>& ramp = story.one().ramp;
    const auto step = std::ranges::find_if(ramp, [&](const erosion::MobilityStep& level) {
        return level.gradient >= story.specified_gradient.value_or(level.gradient) &&
               level.displaced_mass_share >= 0.01;
    });
    return step == ramp.end()
               ? ""
               : fmt::format(
                     "The result depends on the definition of movement: at i = {:.2f}, {} of the mass moved {} along "
                     "the flow, {} half a diameter in any direction, {} a tenth of one along it.",
                     step->gradient, moved_text(step->mobile_mass_share), distance_text(story),
                     moved_text(step->displaced_mass_share), moved_text(step->lifted_mass_share)
                 );
}

/// "moves 1 % of the fines at i = 0.30, a tenth at 0.51": means alone.
std::string what_moves_in_short(const MobilityStory& story) {
    MobilityStory means = story;
    means.moves_1.standard_deviation = means.moves_10.standard_deviation = 0;
    return what_moves(means);
}

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

/// What Skempton and Brogan's rule makes of the specified gradient; nothing where it does not apply.
std::optional<double> safety_by_rule(const MobilityStory& story) {
    if (!story.specified_gradient || !(*story.specified_gradient > 0) || story.skempton_brogan.seeds == 0) {
        return std::nullopt;
    }
    return story.skempton_brogan.mean / *story.specified_gradient;
}

/// Whether rule and motion call the specified gradient safe alike.
bool do_disagree(const MobilityStory& story) {
    const std::optional<double> by_rule = safety_by_rule(story);
    if (!by_rule || !(is_met(story.safety, story) || story.safety_at_least)) {
        return false;
    }
    const double moved = is_met(story.safety, story) ? story.safety.mean : *story.safety_at_least;
    return (moved >= 1) != (*by_rule >= 1);
}

Headline gradient_headline(const MobilityStory& story, const Scatter& gradient, bool at_most, std::string label) {
    const std::string value =
        is_almost_none(gradient.mean) ? "< 0.01" : (at_most ? "≤ " : "") + fixed(gradient.mean, 2);
    if (gradient.seeds > 1) {
        return with_certainty(
            {value, std::move(label), fmt::format("{} samples", gradient.seeds), spread_text(gradient, 1, 2)}, gradient
        );
    }
    const std::string spread = is_almost_none(gradient.mean) ? "" : "± " + fixed(within_step(story, gradient.mean), 2);
    return {value, std::move(label), "within a step of the ramp; no replicate", spread};
}

Headline safety_headline(const MobilityStory& story) {
    Headline headline{"", fmt::format("Factor of safety before 1 % move {}", distance_text(story)), ""};
    const double specified = *story.specified_gradient;
    if (!is_met(story.safety, story)) {
        headline.value = "≥ " + bound_text(*story.safety_at_least);
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
        headline.value = fixed(story.safety.mean, 1);
        headline.spread = spread_text(story.safety, 1, 1);
        headline.detail = fmt::format("{} samples; specified {:.2f}", story.safety.seeds, specified);
        headline = with_certainty(std::move(headline), story.safety);
    } else {
        const double half = within_step(story, story.moves_1.mean) / specified;
        headline.value = fixed(story.safety.mean, 1);
        headline.detail = fmt::format(
            "{} to {} within a step of the ramp; no replicate", fixed(story.safety.mean - half, 1),
            fixed(story.safety.mean + half, 1)
        );
    }
    const bool moves_late = !is_met(story.safety, story) && goes_to_heave(story);
    if (moves_late || (story.heave.seeds > 0 && story.heave.mean < story.moves_1.mean)) { // what fails first decides
        headline.caution = fmt::format(
            "The whole soil heaves before, at {} times the specified gradient.", fixed(story.heave.mean / specified, 1)
        );
    }
    if (do_disagree(story)) {
        headline.caution =
            fmt::format("Skempton and Brogan's rule gives {}; the reason is below.", fixed(*safety_by_rule(story), 1));
    }
    return headline;
}

/// Why the stress that fines carry gives another gradient than what moves them.
std::string compare_with_alpha(const MobilityStory& story) {
    if (story.skempton_brogan.seeds == 0) {
        return "";
    }
    const std::string by_alpha = fmt::format(
        "Skempton and Brogan's α i_c is {}, with the α = {:.2f} of {}", gradient_text(story.skempton_brogan),
        story.alpha_fines.mean, story.of_sample.size() == 1 ? "this sample" : "these samples"
    );
    if (!is_met(story.moves_1, story)) {
        return by_alpha + ".";
    }
    const double ratio = story.moves_1.mean / story.skempton_brogan.mean;
    if (ratio > as_good_as_equal) {
        return by_alpha +
               ". This is below the gradient that moves 1 % here: even fines that carry little stress sit in "
               "pockets of the skeleton, and the water has to lift them out.";
    }
    if (ratio < 1 / as_good_as_equal) {
        return by_alpha + ". This is above the gradient that moves 1 % here: α is a mean, and the first fines to move "
                          "carry nothing.";
    }
    return by_alpha + ". This is near the gradient that moves 1 % here.";
}

std::string compare_with_heave_of_fines(const MobilityStory& story) {
    if (story.fines_heave.seeds == 0) {
        return "";
    }
    return fmt::format(
        "The seepage force on all fines outweighs them at {} (FC i_c/s, s = {:.2f}: the share of the force that acts "
        "on them).",
        gradient_text(story.fines_heave), story.one().drag_share
    );
}

/// Of the grains that move, those that the skeleton's constrictions hold back.
std::string compare_with_passage(const MobilityStory& story) {
    const erosion::MobilityStep& last = story.one().ramp.back();
    if (!last.leaving_mass_share || *last.leaving_mass_share > 0.9 * last.mobile_mass_share ||
        last.mobile_mass_share < 0.01) {
        return "";
    }
    return fmt::format(
        "Of the fines that move at i = {:.2f}, {:.0f} % by mass are wider than the mean constriction of the skeleton "
        "and do not leave.",
        last.gradient, 100 * (1 - *last.leaving_mass_share / last.mobile_mass_share)
    );
}

} // namespace

std::string flow_in_words(const erosion::MobilityResult& mobility) {
    constexpr double along = 0.9999; // within a degree
    const double rise = -dot(mobility.down, mobility.direction);
    return rise > along ? "Upward" : rise < -along ? "Downward" : std::abs(rise) < 1 - along ? "Level" : "Oblique";
}

std::string subject_of(const MobilityStory& story) {
    std::string flow = flow_in_words(story.one()) + " flow";
    if (story.surrogate() == nullptr) {
        return flow;
    }
    flow[0] = static_cast<char>(flow[0] - 'A' + 'a');
    return "By a surrogate, " + flow;
}

std::string verdict(const MobilityStory& story) {
    std::string text = fmt::format("{} {}", subject_of(story), what_moves(story));
    text += heave_text(story, gradient_text(story.heave)) + ".";
    if (!story.specified_gradient) {
        return fmt::format("{} ({}).", text.substr(0, text.size() - 1), samples_text(story));
    }
    if (story.moved_at_specified.seeds == 0) {
        return fmt::format(
            "{} The specified {:.2f} is beyond the ramp ({}).", text, *story.specified_gradient, samples_text(story)
        );
    }
    return fmt::format(
        "{} At the specified {:.2f} it {} ({}; {}).", text, *story.specified_gradient, moved_at_specified_text(story),
        safety_text(story), samples_text(story)
    );
}

std::vector<std::string> remarks_on(const MobilityStory& story) {
    std::vector<std::string> remarks;
    for (std::string remark :
         {compare_measures(story), compare_with_alpha(story), compare_with_heave_of_fines(story),
          compare_with_passage(story)}) {
        if (!remark.empty()) {
            remarks.push_back(std::move(remark));
        }
    }
    if (story.sifts) {
        remarks.push_back(fmt::format(
            "{} of the fines' mass sift through the skeleton under their own weight, without flow: the soil segregates "
            "during placement.",
            as_sentence(sifting_text(story))
        ));
    }
    return remarks;
}

std::vector<std::string> answer_of_mobility(const std::vector<MobilityStory>& stories) {
    constexpr std::size_t most_reported = 6;
    std::vector<std::string> sentences;
    const MobilityStory* const main = study::main_mobility(stories);
    if (main == nullptr) {
        return sentences;
    }
    const auto named = [&](const MobilityStory& story, const std::string& text) {
        return stories.size() == 1 ? text : fmt::format("{}: {}", as_sentence(story.name), text);
    };
    sentences.push_back(named(*main, verdict(*main)));
    for (std::string& remark : remarks_on(*main)) {
        sentences.push_back(std::move(remark));
    }
    if (stories.size() <= most_reported) {
        for (const MobilityStory& story : stories) {
            if (&story != main) {
                sentences.push_back(named(story, verdict(story)));
            }
        }
    } else {
        sentences.push_back(fmt::format("{} more are in the table “Gradients that move fines”.", stories.size() - 1));
    }
    return sentences;
}

std::vector<std::string> short_verdict(const MobilityStory& story) {
    std::vector<std::string> lines = {fmt::format("{} {}", subject_of(story), what_moves_in_short(story))};
    lines.front() += heave_text(story, fmt::format("{:.2f}", story.heave.mean)) + ".";
    const auto sifts_much = [](const erosion::MobilityResult* m) { return m->sifting_mass_share > much_sifting; };
    if (std::ranges::any_of(story.of_sample, sifts_much)) {
        lines.push_back(fmt::format(
            "{} of the fines fall through the skeleton without any flow: for them no gradient is critical.",
            as_sentence(sifting_text(story))
        ));
    }
    if (!story.specified_gradient) {
        return lines;
    }
    if (story.moved_at_specified.seeds == 0) {
        lines.push_back(fmt::format("The specified {:.2f} is beyond the ramp.", *story.specified_gradient));
        return lines;
    }
    MobilityStory means = story;
    means.safety.standard_deviation = 0;
    lines.push_back(fmt::format(
        "At the specified {:.2f} it {}: {}.", *story.specified_gradient, moved_at_specified_text(story),
        safety_text(means)
    ));
    return lines;
}

std::optional<std::string> disagreement(const MobilityStory& story) {
    if (!do_disagree(story)) {
        return std::nullopt;
    }
    const bool rule_warns = *safety_by_rule(story) < 1;
    return fmt::format(
        "Skempton and Brogan's α i_c = {:.2f} is {} the specified {:.2f} and calls it {}. {}",
        story.skempton_brogan.mean, rule_warns ? "below" : "above", *story.specified_gradient,
        rule_warns ? "unstable" : "stable",
        rule_warns ? "The rule considers the mean stress that the fines carry. The ramp also includes the coarse "
                     "grains that cage them."
                   : "The rule uses a mean over all fines. The ramp finds the first fines that carry nothing."
    );
}

std::vector<Headline> mobility_headlines(const MobilityStory& story) {
    std::vector<Headline> headlines;
    if (story.specified_gradient && (is_met(story.safety, story) || story.safety_at_least)) {
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
        Headline heave = {fixed(story.heave.mean, 2), "Gradient of heave, i_c", "by the weight of the soil (Terzaghi)"};
        heave.spread = spread_text(story.heave, 1, 2);
        headlines.push_back(with_certainty(std::move(heave), story.heave));
    }
    return headlines;
}

std::optional<std::string> what_weight_would_change(const std::vector<record::FinishedStage>& stages) {
    const bool probes_mobility = std::ranges::any_of(stages, [](const record::FinishedStage& stage) {
        return casefile::traits_of(*stage.stage).probes_fines();
    });
    const bool weighs = std::ranges::any_of(stages, [](const record::FinishedStage& stage) {
        return stage.numbers.value("model", std::string("weightless")) != "weightless";
    });
    if (!probes_mobility || weighs) {
        return std::nullopt;
    }
    return "Grains have no weight in this case, as in the paper: with [gravity] loose fines stay in their pockets "
           "until a gradient lifts them, and the run finds that gradient.";
}

} // namespace suffuse::answer
