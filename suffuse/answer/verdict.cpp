#include "suffuse/answer/verdict.hpp"

#include "suffuse/answer/filter_words.hpp"
#include "suffuse/answer/headlines.hpp"
#include "suffuse/answer/migration_words.hpp"
#include "suffuse/answer/mobility_words.hpp"
#include "suffuse/answer/plain_numbers.hpp"
#include "suffuse/answer/surrogate_words.hpp"
#include "suffuse/base/grouped.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/erosion/detachment.hpp"
#include "suffuse/study/sample_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::answer {
namespace {

using study::OutcomePoint;
using study::Result;
using study::RunResults;
using study::Scatter;
using study::StudyOutcome;

constexpr std::size_t most_lines = 3;

bool has_thresholds(const RunResults& results) {
    return results.fines && !fines_headlines(results.fines->thresholds).empty();
}

/// "The void ratio is lowest at 37 % fines."
std::vector<std::string> describe_fines(const RunResults& results) {
    std::vector<std::string> lines;
    using enum study::ThresholdKind;
    for (const auto& [kind, words] :
         {std::pair{LowestLoose, "The void ratio is lowest at {} fines."},
          std::pair{ActiveFines, "From {} on the fines begin to carry load."},
          std::pair{LowestDense, "The densest packing has the least void ratio at {} fines."}}) {
        const study::ContentThreshold* const found = study::find_threshold(results.fines->thresholds, kind);
        if (found != nullptr && 2 * found->at.seeds > std::ssize(found->at.of_seed)) {
            lines.push_back(fmt::format(fmt::runtime(words), fixed(100 * found->at.mean, 0) + " %"));
        }
    }
    return lines;
}

/// "the mass carried out", "the peak strength": within a sentence.
std::string in_a_sentence(Result which) {
    std::string words = result_label(which);
    words[0] = static_cast<char>(words[0] - 'A' + 'a');
    return "the " + words;
}

bool has_numbers(const StudyOutcome& outcome) {
    return outcome.keys.size() == 1 && std::ranges::none_of(outcome.points, [](const OutcomePoint& point) {
               return std::isnan(point.at.value.front());
           });
}

/// "From gradient 0.05 to 0.5 the mass carried out rises from 3 to 14 %."
std::string describe_result(const StudyOutcome& outcome, Result which, const flow::Fluid& fluid) {
    const study::SweepEffect effect = study::effect_of_sweep(outcome, which);
    const auto& [difference, first, last, least, most, points, fewest_samples, most_samples] = effect;
    const auto text = [&](const OutcomePoint* point) { return mean_text(*point, which, fluid, "at most "); };
    const std::string key = study::keys_in_words(outcome);
    const std::string of = points == outcome.all_points() ? "" : " (" + points_in_words(outcome, effect) + ")";
    const bool is_one_key = outcome.keys.size() == 1;
    if (difference != study::Difference::Clear) {
        const std::string what = is_one_key ? as_sentence("the " + key) : "What is swept";
        return difference == study::Difference::WithinScatter
                   ? fmt::format(
                         "{} makes no measurable difference to {}: {} to {}{}.", what, in_a_sentence(which),
                         text(least), text(most), of
                     )
                   : fmt::format(
                         "{} changes {} little: {} to {}{}{}.", what, in_a_sentence(which), text(least), text(most), of,
                         effect.has_scatter() ? "" : ", one sample each"
                     );
    }
    const bool runs_through =
        has_numbers(outcome) && ((least == first && most == last) || (least == last && most == first));
    if (runs_through) {
        return fmt::format(
            "From {} {} to {} {} {} from {} to {}{}.", key, value_in_words(first->at, 0), value_in_words(last->at, 0),
            in_a_sentence(which), most == last ? "rises" : "falls", text(first), text(last), of
        );
    }
    return fmt::format(
        "{} is least at {} ({}) and most at {} ({}){}.", as_sentence(in_a_sentence(which)),
        point_in_words(outcome, *least), text(least),
        is_one_key ? value_in_words(most->at, 0) : point_in_words(outcome, *most), text(most), of
    );
}

std::vector<std::string> describe_sweep(const StudyOutcome& outcome, const flow::Fluid& fluid) {
    std::vector<std::string> lines;
    const std::optional<Result> main = study::main_result(outcome);
    if (!main) {
        return {"No sample has a result yet."};
    }
    lines.push_back(describe_result(outcome, *main, fluid));
    constexpr std::size_t most_reported = 2; // each sentence is long, and the cards contain the rest
    for (int k = 0; k < study::results && lines.size() < most_reported; ++k) {
        const auto which = static_cast<Result>(k);
        if (which != *main && outcome.has(which) && study::depends_on_sweep(outcome, which)) {
            lines.push_back(describe_result(outcome, which, fluid));
        }
    }
    return lines;
}

/// Of the erosions of the point's samples, or of the one that the run tells of.
study::ErosionSpan span_at(const RunResults& results, const OutcomePoint* point) {
    return point != nullptr && point->erosion
               ? *point->erosion
               : study::span_of({&results.story.erosion}, results.what->fluid.conductance)
                     .value_or(study::ErosionSpan{});
}

std::string describe_eroded(const RunResults& results, const OutcomePoint* point) {
    const study::ErosionSpan span = span_at(results, point);
    double share = erosion::eroded_percent(results.story.erosion) / 100;
    const Result which = span.is_by_force() ? Result::RemovedMass : Result::ErodedMass;
    if (const Scatter* const all = point == nullptr ? nullptr : point->find(which)) {
        share = all->mean;
    }
    const std::string passes = passes_in_words(span), mass = percent_text(share);
    if (span.is_by_force()) {
        return fmt::format("Fines taken out by force are {} of the mass, {}.", mass, passes);
    }
    if (!(share > 0)) {
        return fmt::format("Water at i = {} carries out none of the fines.", span.gradients());
    }
    return fmt::format(
        "Water at i = {} {} {} of the mass, {}.", span.gradients(),
        span.has_forced ? "and removal by force take out" : "carries out", mass, passes
    );
}

/// What is known of a change of permeability whose ends are known to be too high.
const char* bound_in_words(const study::ErosionSpan& span) {
    return span.before_is_too_high && span.after_is_too_high ? "about "
           : span.before_is_too_high                         ? "at least "
           : span.after_is_too_high                          ? "at most "
                                                             : "";
}

/// @param bound "at most " of a change that is known to be too large
std::string describe_permeability(double change, const std::string& bound) {
    if (std::abs(change - 1) < erosion::least_permeability_change) {
        return "The permeability does not change.";
    }
    if (change < 1) {
        return fmt::format("The permeability falls to {}{} of its initial value.", bound, percent_text(change));
    }
    return change < 1.1 ? fmt::format("The permeability rises by {}{}.", bound, percent_text(change - 1))
                        : fmt::format(
                              "The permeability rises to {}{} times its initial value.", bound,
                              fixed(change, std::min(2, decimals_for(change, 2)))
                          );
}

std::optional<std::string> describe_permeability(const RunResults& results, const OutcomePoint* point) {
    const auto found = study::permeability_after(results.story.erosion, results.what->fluid.conductance);
    const Scatter* const all = point == nullptr ? nullptr : point->find(Result::PermeabilityChange);
    if (!found && all == nullptr) {
        return std::nullopt;
    }
    return describe_permeability(all != nullptr ? all->mean : found->change, bound_in_words(span_at(results, point)));
}

std::optional<std::string> describe_change_of_strength(const std::vector<study::StrengthChange>& changes) {
    constexpr std::size_t most_reported = 3; // of more, none stands for all
    const auto reported = std::ranges::find_if(changes, [](const study::StrengthChange& change) {
        return change.borne().change.seeds > 0;
    });
    if (reported == changes.end()) {
        return std::nullopt;
    }
    if (changes.size() > most_reported) {
        const auto weaker =
            std::ranges::count_if(changes, [](const study::StrengthChange& c) { return c.is_weaker() == true; });
        return fmt::format("{} of {} tests after the loss find the soil weaker.", weaker, changes.size());
    }
    const std::string what = reported->holds_deviator() ? "pore pressure that it bears" : "peak strength";
    const study::BeforeAfter& borne = reported->borne();
    if (!reported->is_weaker()) {
        return fmt::format(
            "The {} changes no more than samples {}differ.", what, borne.change.seeds > 1 ? "" : "usually "
        );
    }
    return fmt::format(
        "The {} {} by {}, from {} to {} kPa.", what, *reported->is_weaker() ? "falls" : "rises",
        percent_text(std::abs(borne.change.mean)), fixed(borne.before.mean / 1e3, 0), fixed(borne.after.mean / 1e3, 0)
    );
}

std::vector<std::string> describe_erosion(const RunResults& results, const OutcomePoint* point) {
    std::vector<std::string> lines = {describe_eroded(results, point)};
    if (const auto& passes = results.story.erosion.passes; !passes.empty() && passes.back().failed) {
        lines.push_back(
            fmt::format("After pass {} the skeleton does not carry its stresses any more.", passes.back().pass)
        );
    }
    for (std::optional<std::string> line :
         {describe_permeability(results, point), describe_change_of_strength(results.strength)}) {
        if (line) {
            lines.push_back(std::move(*line));
        }
    }
    return lines;
}

std::vector<std::string> describe_migration(const RunResults& results) {
    const FinishedStages stages = migration_stages(results.stages);
    std::vector<std::string> lines = migration_verdict(stages);
    if (stages.size() == 1) {
        lines.push_back(describe_permeability(permeability_change(*stages.front()), ""));
    }
    if (auto line = describe_change_of_strength(results.strength)) {
        lines.push_back(std::move(*line));
    }
    return lines;
}

std::vector<std::string> describe_probe(const RunResults& results, std::size_t samples) {
    const erosion::ProbeResult* most = &results.story.probes.front();
    for (const erosion::ProbeResult& probe : results.story.probes) {
        most = probe.gradient > most->gradient ? &probe : most;
    }
    const auto count = std::ranges::count(erosion::verdicts(results.story.probed_by, *most), std::uint8_t{1});
    return {
        fmt::format(
            "Water at i = {:g} detaches {} of {} fines{}.", most->gradient, count == 0 ? "none" : grouped(count),
            grouped(std::ssize(most->id)),
            samples > 1 ? fmt::format(" in the first of {} samples", count_in_words(samples)) : ""
        ),
        "Grains have no weight here: this gradient is not a critical one."};
}

std::vector<std::string>
describe_removal(const OutcomePoint& point, const std::vector<study::StrengthChange>& strength) {
    const Scatter* const strain = point.find(Result::RemovalStrain);
    std::vector<std::string> lines = {fmt::format(
        "Fines of {} of the mass are taken out without water.", percent_text(point.find(Result::RemovedMass)->mean)
    )};
    lines.push_back(
        strain == nullptr ? std::string("The skeleton collapses: it strains beyond `max_strain`.")
        : std::abs(strain->mean) < 5e-4
            ? "The soil keeps its volume."
            : fmt::format(
                  "The soil {} by {}.", strain->mean > 0 ? "contracts" : "dilates", percent_text(std::abs(strain->mean))
              )
    );
    if (auto line = describe_change_of_strength(strength)) {
        lines.push_back(std::move(*line));
    }
    return lines;
}

std::vector<std::string> describe_state_of(const OutcomePoint& point, const flow::Fluid& fluid) {
    std::vector<std::string> lines;
    if (const Scatter* const strength = point.find(Result::Strength)) {
        lines.push_back(fmt::format("The soil bears a deviator stress of {} kPa.", fixed(strength->mean / 1e3, 0)));
    }
    if (const Scatter* const permeability = point.find(Result::Permeability)) {
        lines.push_back(
            fmt::format("Under a gradient of one, water seeps at {}.", conductivity_text(permeability->mean, fluid))
        );
    }
    if (const Scatter* const ratio = point.find(Result::VoidRatio)) {
        lines.push_back(fmt::format("The grains rest at void ratio {}.", fixed(ratio->mean, 3)));
    }
    if (lines.empty()) {
        lines.emplace_back("The run has no result yet; its states are under Quality.");
    }
    return lines;
}

} // namespace

const StudyOutcome* reported_outcome(const RunResults& results) {
    const casefile::Study* study = nullptr;
    if (results.fines_sweep && has_thresholds(results)) {
        study = results.fines_sweep->study;
    } else if (const study::MobilityStory* const main = study::main_mobility(results.mobility)) {
        study = main->first->study;
    } else if (results.story.eroded != nullptr) {
        study = results.story.eroded->study;
    }
    const auto found = std::ranges::find(results.outcomes, study, &StudyOutcome::study);
    return found == results.outcomes.end() ? study::main_outcome(results.outcomes) : &*found;
}

const OutcomePoint* reported_point(const RunResults& results) {
    const StudyOutcome* const outcome = reported_outcome(results);
    if (outcome == nullptr || outcome->points.empty()) {
        return nullptr;
    }
    if (results.story.eroded != nullptr) {
        const auto found = std::ranges::find_if(outcome->points, [&](const OutcomePoint& point) {
            return std::ranges::count(point.samples, results.story.eroded->variant) > 0;
        });
        return found == outcome->points.end() ? &outcome->points.front() : &*found;
    }
    return &outcome->points.front();
}

Question question_of(const RunResults& results) {
    const StudyOutcome* const outcome = reported_outcome(results);
    const OutcomePoint* const point = reported_point(results);
    if (has_thresholds(results)) {
        return Question::Fines;
    }
    if (!filter_stages(results.stages).empty()) {
        return Question::Filter;
    }
    if (outcome != nullptr && outcome->points.size() > 1) {
        return Question::Sweep;
    }
    if (study::main_mobility(results.mobility) != nullptr) {
        return Question::Weight;
    }
    if (!results.story.erosion.passes.empty()) {
        return Question::Erosion;
    }
    if (!migration_stages(results.stages).empty()) {
        return Question::Migration;
    }
    if (!results.story.probes.empty()) {
        return Question::Probe;
    }
    return point != nullptr && point->find(Result::RemovedMass) != nullptr ? Question::Removal : Question::State;
}

std::vector<std::string> verdict_of_run(const RunResults& results) {
    const OutcomePoint* const point = reported_point(results);
    std::vector<std::string> lines;
    switch (question_of(results)) {
    case Question::Fines:
        lines = describe_fines(results);
        break;
    case Question::Filter:
        lines = filter_verdict(filter_stages(results.stages));
        break;
    case Question::Sweep:
        lines = verdict_by_ratio(results.mobility);
        lines = lines.empty() ? describe_sweep(*reported_outcome(results), results.what->fluid) : lines;
        break;
    case Question::Weight:
        lines = short_verdict(*study::main_mobility(results.mobility));
        break;
    case Question::Erosion:
        lines = describe_erosion(results, point);
        break;
    case Question::Migration:
        lines = describe_migration(results);
        break;
    case Question::Probe:
        lines = describe_probe(results, point == nullptr ? 1 : point->samples.size());
        break;
    case Question::Removal:
        lines = describe_removal(*point, results.strength);
        break;
    case Question::State:
        lines = point == nullptr ? std::vector<std::string>{"No stage is finished yet."}
                                 : describe_state_of(*point, results.what->fluid);
        break;
    }
    const StudyOutcome* const outcome = reported_outcome(results);
    if (point != nullptr && outcome->points.size() < outcome->all_points() && outcome->points.size() == 1) {
        lines.insert(
            lines.begin(), fmt::format(
                               "One of {} points of the sweep has a result: {}.", outcome->all_points(),
                               point_in_words(*outcome, *point)
                           )
        );
    }
    lines.resize(std::min(lines.size(), most_lines));
    return lines;
}

} // namespace suffuse::answer
