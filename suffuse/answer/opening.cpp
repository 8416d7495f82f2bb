#include "suffuse/answer/opening.hpp"

#include "suffuse/answer/basis.hpp"
#include "suffuse/answer/filter_words.hpp"
#include "suffuse/answer/heave_words.hpp"
#include "suffuse/answer/migration_words.hpp"
#include "suffuse/answer/mobility_headlines.hpp"
#include "suffuse/answer/mobility_remarks.hpp"
#include "suffuse/answer/plain_numbers.hpp"
#include "suffuse/answer/strength_words.hpp"
#include "suffuse/answer/surrogate_words.hpp"
#include "suffuse/answer/verdict.hpp"
#include "suffuse/base/grouped.hpp"
#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace suffuse::answer {
namespace {

using study::RunResults;
using study::StudyOutcome;

constexpr std::size_t most_cards = 6, most_doubts = 3;

void add(std::vector<Headline> headlines, std::vector<Headline>& to) {
    std::ranges::move(headlines, std::back_inserter(to));
}

std::vector<Headline> cards_of(const RunResults& results, const std::vector<study::Finding>& findings) {
    const flow::Fluid& fluid = results.what->fluid;
    const StudyOutcome* const outcome = reported_outcome(results);
    const study::OutcomePoint* const point = reported_point(results);
    const Question question = question_of(results);
    std::vector<Headline> cards;
    if (question == Question::Fines) {
        add(fines_headlines(results.fines->thresholds), cards);
    }
    if (question == Question::Filter) {
        add(filter_headlines(filter_stages(results.stages)), cards);
    } else if (question == Question::Fines || question == Question::Sweep) {
        add(sweep_headlines(*outcome, fluid), cards);
    } else {
        if (const study::MobilityStory* const main = study::main_mobility(results.mobility)) {
            add(mobility_headlines(*main), cards);
        }
        add(erosion_headlines(results.story.erosion, fluid, point), cards);
        add(migration_headlines(migration_stages(results.stages)), cards);
        if (auto headline = strength_headline(results.strength)) {
            cards.push_back(std::move(*headline));
        }
        if (point != nullptr && results.story.erosion.passes.empty() && question != Question::Migration) {
            add(state_headlines(*point, fluid), cards);
        }
    }
    std::optional<Headline> of_findings = findings_headline(findings);
    cards.resize(std::min(cards.size(), most_cards - (of_findings ? 1 : 0)));
    if (of_findings) {
        cards.push_back(std::move(*of_findings));
    }
    return cards;
}

/// "9,459 fine and 541 coarse grains with weight"; of several samples how many grains each has.
std::string grains_of(const RunResults& results) {
    std::int64_t least = 0, most = 0;
    for (const record::FinishedStage& stage : results.stages) {
        const auto grains = stage.numbers.at("grains").get<std::int64_t>();
        const bool is_first = stage.stage->parent < 0; // before anything was taken out
        if (is_first) {
            least = least == 0 ? grains : std::min(least, grains);
            most = std::max(most, grains);
        }
    }
    if (most == 0) {
        return "";
    }
    const bool has_mobility_question =
        !results.mobility.empty() || !results.story.erosion.passes.empty() || !results.story.probes.empty();
    const char* const weight = !has_mobility_question     ? ""
                               : results.mobility.empty() ? " without weight"
                                                          : " with weight";
    return fmt::format("{}{} grains{}", least == most ? "" : grouped(least) + " to ", grouped(most), weight);
}

/// The call that would give every point three seeds.
std::string call_for_replicates(const casefile::Study& study) {
    return fmt::format("`--set study.{}.replicates=3`", study.name);
}

/// Of how many samples the numbers of the cards are.
std::string what_numbers_are(const std::vector<Headline>& cards) {
    const auto is_mean = [](const Headline& card) { return card.samples > 1; };
    return std::ranges::none_of(cards, is_mean) ? "Each number is of one sample."
           : std::ranges::any_of(cards, [](const Headline& card) { return card.samples == 1; })
               ? "Numbers with ± are means and one standard deviation; those without a replicate are of one sample."
               : "Numbers are means, ± one standard deviation.";
}

void describe_confidence(const RunResults& results, Opening& opening) {
    const StudyOutcome* const outcome = reported_outcome(results);
    if (outcome == nullptr) {
        opening.confidence = "No result yet";
        return;
    }
    const std::size_t seeds = outcome->seeds(), points = outcome->points.size();
    const std::string grains = grains_of(results);
    const bool is_sweep = points > 1;
    if (seeds < 2) {
        opening.confidence = is_sweep ? "One sample each" : "One sample";
        opening.about_confidence = fmt::format(
            "{}{}. The scatter between samples was not measured. To measure it, add {}.",
            is_sweep ? fmt::format("{} samples, ", points) : "", grains, call_for_replicates(*outcome->study)
        );
        return;
    }
    opening.confidence =
        is_sweep ? as_sentence(seeds_in_words(*outcome)) + " each" : as_sentence(count_in_words(seeds)) + " samples";
    opening.about_confidence =
        is_sweep
            ? fmt::format(
                  "{} samples, {}. Lines: means. Bands and bars: one standard deviation.", outcome->samples(), grains
              )
            : fmt::format("{} each. {}", as_sentence(grains), what_numbers_are(opening.cards));
}

/// Of the story; else, as nothing but the simulation estimates a level flow, of another flow through the same sample.
std::string estimates_for(const std::vector<study::MobilityStory>& stories, const study::MobilityStory& story) {
    std::string estimates = estimates_of(story);
    for (const study::MobilityStory& other : stories) {
        if (estimates.empty() && other.first->variant == story.first->variant) {
            estimates = estimates_of(other);
        }
    }
    return estimates;
}

std::vector<std::string> pictures_for(Question question) {
    switch (question) {
    case Question::Fines:
        return {"fig03", "fig04", "own-sweep"};
    case Question::Filter:
        return {"own-filter-cut", "own-filter-profile"};
    case Question::Sweep:
        return {"own-sweep"};
    case Question::Weight:
        return {"own-mobility", "own-strength", "own-mobile-sizes"};
    case Question::Erosion:
        return {"own-strength", "own-permeability", "fig13"};
    case Question::Migration:
        return {"own-migration", "own-migration-time"};
    case Question::Probe:
        return {"fig09", "own-rules"};
    case Question::Removal:
        return {"own-strength", "own-triaxial"};
    case Question::State:
        return {"own-triaxial", "own-stress-probes", "own-flux-shares", "own-throat-flux"};
    }
    return {};
}

} // namespace

Opening open_answer(const RunResults& results, const std::vector<study::Finding>& findings) {
    Opening opening;
    const Question question = question_of(results);
    opening.verdict = verdict_of_run(results);
    opening.cards = cards_of(results, findings);
    describe_confidence(results, opening);
    const study::MobilityStory* const main = study::main_mobility(results.mobility);
    const bool has_one_answer = main != nullptr && question == Question::Weight;
    if (const auto* const story = has_one_answer ? main : nearest_surrogate(results.mobility)) {
        opening.estimates = estimates_for(results.mobility, *story);
        opening.doubts = doubts_about(*story);
        if (auto text = disagreement(*story)) {
            opening.disagreement.push_back(std::move(*text));
        }
    }
    if (question == Question::Filter) {
        opening.doubts = filter_doubts(filter_stages(results.stages));
    }
    if (question == Question::Migration) {
        opening.doubts = migration_doubts(migration_stages(results.stages));
    }
    if (auto heave = doubt_of_heave(results)) {
        opening.doubts.insert(opening.doubts.begin(), std::move(*heave));
        opening.doubts.resize(std::min(opening.doubts.size(), most_doubts));
    }
    opening.pictures = pictures_for(question);
    opening.shows_grains =
        question == Question::Erosion || question == Question::Removal || question == Question::State;
    return opening;
}

} // namespace suffuse::answer
