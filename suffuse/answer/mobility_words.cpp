#include "suffuse/answer/mobility_words.hpp"

#include "suffuse/answer/mobility_remarks.hpp"
#include "suffuse/answer/mobility_text.hpp"
#include "suffuse/answer/plain_numbers.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/casefile/stage_traits.hpp"
#include "suffuse/study/factor_of_safety.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::answer {
namespace {

using study::MobilityStory;
using study::Scatter;

constexpr double much_sifting = 0.1; // of the fines' mass: then the gradient that moves a tenth says little

std::string samples_text(const MobilityStory& story) {
    return story.of_sample.size() == 1 ? "one sample" : fmt::format("{} samples", story.of_sample.size());
}

/// "i = 0.30", "i = 0.30 or less", "i < 0.01". @param name "i = " where it is not said yet
std::string reached_text(const Scatter& gradient, bool at_most, const char* name) {
    return is_almost_none(gradient.mean) ? "i < 0.01" : name + gradient_text(gradient) + (at_most ? " or less" : "");
}

/// " in 2 of 3 samples" where others do not reach it.
std::string met_by(const Scatter& gradient, const MobilityStory& story) {
    return static_cast<std::size_t>(gradient.seeds) == story.of_sample.size()
               ? ""
               : fmt::format(" in {} of {} samples", gradient.seeds, story.of_sample.size());
}

/// "moves 1 % of the fines at i = 0.30, a tenth at 0.51".
std::string what_moves(const MobilityStory& story) {
    const bool heaves_first = story.heave.seeds > 0 && story.moves_1.mean >= story.heave.mean;
    if (!is_met(story.moves_1, story) || heaves_first) {
        return fmt::format("moves less than 1 % of the fines {}", heaves_first ? "below heave" : end_text(story));
    }
    return fmt::format(
               "moves 1 % of the fines at {}{}, ", reached_text(story.moves_1, story.at_most_1, "i = "),
               met_by(story.moves_1, story)
           ) +
           (is_met(story.moves_10, story) ? fmt::format(
                                                "a tenth at {}{}", reached_text(story.moves_10, story.at_most_10, ""),
                                                met_by(story.moves_10, story)
                                            )
                                          : fmt::format("less than a tenth {}", end_text(story)));
}

/// "; the soil heaves at 1.05".
std::string heave_text(const MobilityStory& story, const std::string& gradient) {
    if (story.heave.seeds == 0) {
        return "; it cannot lift the soil";
    }
    const bool is_first = !is_met(story.moves_1, story) && goes_to_heave(story);
    return fmt::format("; the soil heaves at {}{}", gradient, is_first ? " first" : "");
}

/// "factor of safety 1.5 before 1 % move half a diameter": the number, and what it rests on.
std::string safety_text(const MobilityStory& story) {
    if (!is_met(story.safety, story) && !story.safety_at_least) {
        return "no factor of safety, as motion had not ended when the gradient rose";
    }
    const std::string factor = is_met(story.safety, story)
                                   ? (story.at_most_1 ? "at most " : "") + factor_text(story.safety)
                                   : "at least " + least_factor_text(*story.safety_at_least);
    return fmt::format("factor of safety {} before 1 % move {}", factor, distance_text(story));
}

/// What the specified gradient does.
struct AtSpecified {
    std::string effect; ///< "At the specified 0.20 it moves 0.2 %"
    std::string factor; ///< of safety; may be empty
};

/// "it moves 0.2 %". A lower bound of nearly nothing bounds nothing.
std::string moved_at_specified_text(const MobilityStory& story) {
    const double share = story.moved_at_specified.mean;
    const std::string where = met_by(story.moved_at_specified, story);
    if (!story.moved_at_specified_at_least) {
        return fmt::format("it moves {}{}", moved_text(share), where);
    }
    return is_almost_nothing(share) ? fmt::format("it moved {}{} before the gradient rose", moved_text(share), where)
                                    : fmt::format("it moves at least {}{}", moved_text(share), where);
}

AtSpecified at_specified(const MobilityStory& story) {
    const std::string specified = fmt::format("{:.2f}", *story.specified_gradient);
    if (is_met(story.moved_at_specified, story)) {
        return {fmt::format("At the specified {} {}", specified, moved_at_specified_text(story)), safety_text(story)};
    }
    if (const std::size_t lifted = story.lifted_at_specified, all = story.of_sample.size(); lifted > 0) {
        return {
            fmt::format(
                "At the specified {} the water lifts the whole soil{}", specified,
                lifted == all ? "" : fmt::format(" in {} of {} samples", lifted, all)
            ),
            is_met(story.safety, story) ? safety_text(story)
                                        : fmt::format("factor of safety {} against heave", heave_factor_text(story))};
    }
    return {fmt::format("The specified {} is beyond the ramp", specified), ""};
}

/// "moves 1 % of the fines at i = 0.30, a tenth at 0.51": means alone.
std::string what_moves_in_short(const MobilityStory& story) {
    MobilityStory means = story;
    means.moves_1.standard_deviation = means.moves_10.standard_deviation = 0;
    return what_moves(means);
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
    const auto [effect, factor] = at_specified(story);
    return fmt::format("{} {} ({}{}{}).", text, effect, factor, factor.empty() ? "" : "; ", samples_text(story));
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
    MobilityStory means = story;
    means.safety.standard_deviation = 0;
    const auto [effect, factor] = at_specified(means);
    lines.push_back(fmt::format("{}{}{}.", effect, factor.empty() ? "" : ": ", factor));
    return lines;
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
