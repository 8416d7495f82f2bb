#include "suffuse/answer/headlines.hpp"

#include "suffuse/answer/plain_numbers.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/study/passes.hpp"
#include "suffuse/study/sample_results.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::answer {

namespace {

using erosion::ErosionResult;
using erosion::PassResult;
using study::Result;
using study::Scatter;

/// "at gradient 1 (± 1.4) and 3 (± 3)": where a result is least, and where it is most.
std::string ends_in_words(
    const study::StudyOutcome& outcome, const study::SweepEffect& effect, Result which, const flow::Fluid& fluid
) {
    const auto with_spread = [&](const std::string& where, const study::OutcomePoint& point) {
        const std::string spread = result_spread(which, *point.find(which), fluid);
        return where + (spread.empty() ? "" : " (" + spread + ")");
    };
    const bool is_one_key = outcome.keys.size() == 1;
    return fmt::format(
        "at {} and {}", with_spread(point_in_words(outcome, *effect.least), *effect.least),
        with_spread(
            is_one_key ? value_in_words(effect.most->at, 0) : point_in_words(outcome, *effect.most), *effect.most
        )
    );
}

/// "1.4 to 1.9": the least and most of what a swept study came to.
Headline range_headline(const study::StudyOutcome& outcome, Result which, const flow::Fluid& fluid) {
    const study::SweepEffect effect = study::effect_of_sweep(outcome, which);
    const std::string least = mean_text(*effect.least, which, fluid), most = mean_text(*effect.most, which, fluid);
    const std::string points = points_in_words(outcome, effect);
    const bool is_clear = effect.difference == study::Difference::Clear;
    Headline headline{is_clear || least != most ? least + " to " + most : least, result_label(which), ""};
    headline.samples = effect.most_samples;
    if (is_clear) {
        headline.detail =
            ends_in_words(outcome, effect, which, fluid) + (effect.points < outcome.all_points() ? "; " + points : "");
    } else {
        headline.detail = fmt::format(
            "{} at {}", effect.difference == study::Difference::Small ? "nearly the same" : "the same within scatter",
            points
        );
    }
    if (!effect.has_scatter()) {
        headline.detail += "; no replicate";
    }
    if ((which == Result::FirstMovement || which == Result::Safety) && !outcome.first_probe.empty()) {
        headline.detail += fmt::format("; stage “{}”", outcome.first_probe);
    }
    const auto is_doubtful = [&](const study::OutcomePoint& point) {
        return point.erosion && (point.erosion->before_is_too_high || point.erosion->after_is_too_high);
    };
    if (which == Result::PermeabilityChange && std::ranges::any_of(outcome.points, is_doubtful)) {
        headline.caution = "Permeabilities of some points are known to be too high.";
    }
    return headline;
}

/// Of seeds where there are several, else of the one sample.
Headline seeds_headline(Result which, const Scatter& value, std::string detail, const flow::Fluid& fluid) {
    return with_certainty(
        {result_text(which, value.mean, fluid), result_label(which), std::move(detail),
         result_spread(which, value, fluid)},
        value
    );
}

Headline permeability_headline(
    const study::PermeabilityAfter& permeability, const study::ErosionSpan& span, const Scatter& change,
    const flow::Fluid& fluid
) {
    const bool before = span.before_is_too_high, after = span.after_is_too_high;
    Headline headline = seeds_headline(
        Result::PermeabilityChange, change,
        fmt::format(
            "{}{} to {}{}{}", before ? "at most " : "", conductivity_text(permeability.before, fluid),
            after ? "at most " : "", conductivity_text(permeability.after, fluid),
            change.seeds > 1 ? " in the first sample" : ""
        ),
        fluid
    );
    const char* const why = "the packing is too open or too mixed for the pore network";
    if (before && after) {
        headline.caution = fmt::format("Both permeabilities are known to be too high: {}.", why);
    } else if (before) {
        headline.lead = "at least";
        headline.caution = fmt::format("Known to be too low: before erosion {}.", why);
    } else if (after) {
        headline.lead = "up to";
        headline.caution = fmt::format("Known to be too high: {}.", why);
    } else if (permeability.known_error) {
        headline.detail += fmt::format("; each known to within {}", percent_text(*permeability.known_error));
    }
    return headline;
}

/// "after pass 2, the largest loss"; of several samples each may have its own pass.
std::string loss_in_words(const PassResult& worst, double loss, int samples) {
    if (is_noise(100 * loss)) {
        return "in all passes";
    }
    const char* const what = loss > 0 ? "the largest loss" : "the smallest gain";
    return samples > 1 ? fmt::format("{} of a pass", what) : fmt::format("after pass {}, {}", worst.pass, what);
}

/// The result over the seeds, or else what the erosion of the one sample says.
Scatter over_seeds(const study::OutcomePoint* outcome, Result which, double of_one) {
    const Scatter* const found = outcome == nullptr ? nullptr : outcome->find(which);
    return found == nullptr ? study::scatter_of({of_one}) : *found;
}

} // namespace

Headline with_certainty(Headline headline, const Scatter& value) {
    const char* const before = headline.detail.empty() ? "" : "; ";
    headline.samples = std::max(1, value.seeds);
    if (value.seeds < 2) {
        headline.detail += fmt::format("{}no replicate", before);
    } else if (headline.spread.empty()) {
        headline.detail += fmt::format(
            "{}the same{} in {} samples", before, study::agree(value) ? "" : " to the digits shown",
            count_in_words(static_cast<std::size_t>(value.seeds))
        );
    }
    return headline;
}

std::string passes_in_words(const study::ErosionSpan& span) {
    const auto count = [](int passes) { return count_in_words(static_cast<std::size_t>(passes)); };
    return span.fewest_passes == span.most_passes
               ? fmt::format("in {} {}", count(span.most_passes), span.most_passes == 1 ? "pass" : "passes")
               : fmt::format("in {} to {} passes", count(span.fewest_passes), count(span.most_passes));
}

std::string point_in_words(const study::StudyOutcome& outcome, const study::OutcomePoint& point) {
    std::string words;
    for (std::size_t k = 0; k < outcome.keys.size(); ++k) {
        words += (k == 0 ? "" : ", ") + study::key_in_words(outcome.keys[k], outcome.keys) + " " +
                 value_in_words(point.at, k);
    }
    return words;
}

std::string seeds_in_words(const study::StudyOutcome& outcome) {
    const std::size_t fewest = outcome.fewest_seeds(), most = outcome.seeds();
    return (fewest == most ? "" : count_in_words(fewest) + " to ") + count_in_words(most) +
           (most == 1 ? " sample" : " seeds");
}

std::string points_in_words(const study::StudyOutcome& outcome, const study::SweepEffect& effect) {
    return effect.points == outcome.all_points() ? fmt::format("all {} points", effect.points)
                                                 : fmt::format("{} of {} points", effect.points, outcome.all_points());
}

std::vector<Headline>
erosion_headlines(const ErosionResult& erosion, const flow::Fluid& fluid, const study::OutcomePoint* outcome) {
    std::vector<Headline> headlines;
    const std::optional<study::ErosionSpan> of_one = study::span_of({&erosion}, fluid.conductance);
    if (!of_one) {
        return headlines;
    }
    const study::ErosionSpan& span = outcome != nullptr && outcome->erosion ? *outcome->erosion : *of_one;
    const Result mass = span.is_by_force() ? Result::RemovedMass : Result::ErodedMass;
    const std::string passes = passes_in_words(span);
    const bool probed = !erosion.passes.front().probe.id.empty() && span.least_gradient;
    headlines.push_back(seeds_headline(
        mass, over_seeds(outcome, mass, erosion::eroded_percent(erosion) / 100),
        probed ? fmt::format("{} at i = {}", passes, span.gradients()) : passes, fluid
    ));
    if (span.has_forced && !span.is_by_force()) {
        headlines.back().label = "Mass that left";
    }
    if (const auto permeability = study::permeability_after(erosion, fluid.conductance)) {
        headlines.push_back(permeability_headline(
            *permeability, span, over_seeds(outcome, Result::PermeabilityChange, permeability->change), fluid
        ));
    }
    if (const PassResult* const worst = erosion::pass_of_largest_loss(erosion)) {
        const double loss = *erosion::stress_loss(*worst);
        const Scatter change = over_seeds(outcome, Result::StressChange, -loss);
        Headline headline =
            seeds_headline(Result::StressChange, change, loss_in_words(*worst, -change.mean, change.seeds), fluid);
        headline.value = is_none(Result::StressChange, change.mean) ? "unchanged" : headline.value;
        headlines.push_back(std::move(headline));
    }
    return headlines;
}

std::vector<Headline> sweep_headlines(const study::StudyOutcome& outcome, const flow::Fluid& fluid) {
    std::vector<Headline> headlines;
    const std::optional<Result> main = study::main_result(outcome);
    if (!main) {
        return headlines;
    }
    const auto add_headline = [&](Result which) {
        const auto is_something = [&](const study::OutcomePoint& point) {
            const Scatter* const value = point.find(which);
            return value != nullptr && !is_none(which, value->mean);
        };
        if (std::ranges::any_of(outcome.points, is_something)) {
            headlines.push_back(range_headline(outcome, which, fluid));
        }
    };
    add_headline(*main);
    for (int k = 0; k < study::results; ++k) {
        if (const auto which = static_cast<Result>(k); which != *main && outcome.has(which)) {
            add_headline(which);
        }
    }
    if (outcome.study != nullptr) {
        headlines.push_back(
            {fmt::format("{} of {}", outcome.samples(), outcome.study->variants.size()), "Samples run",
             fmt::format(
                 "{} of {} points, {} each", outcome.points.size(), outcome.all_points(), seeds_in_words(outcome)
             )}
        );
    }
    return headlines;
}

std::vector<Headline> state_headlines(const study::OutcomePoint& outcome, const flow::Fluid& fluid) {
    std::vector<Headline> headlines;
    for (const Result which :
         {Result::RemovedMass, Result::RemovalStrain, Result::Strength, Result::Permeability, Result::VoidRatio}) {
        if (const Scatter* const value = outcome.find(which)) {
            const std::string detail = which == Result::Permeability ? permeability_text(value->mean) : "";
            headlines.push_back(seeds_headline(which, *value, detail, fluid));
        }
    }
    return headlines;
}

std::optional<Headline> findings_headline(const std::vector<study::Finding>& findings) {
    if (findings.empty()) {
        return std::nullopt;
    }
    const auto met = std::ranges::count(findings, study::Standing::Met, study::standing_of);
    const std::string all = study::count_standings(findings);
    const std::size_t more = all.find_first_of(",;");
    return Headline{
        fmt::format("{} of {}", met, findings.size()), "Findings of the paper met",
        more == std::string::npos ? "" : all.substr(more + 2)};
}

std::vector<Headline> fines_headlines(const std::vector<study::ContentThreshold>& thresholds) {
    using enum study::ThresholdKind;
    const auto label = [](study::ThresholdKind kind) {
        return kind == LowestLoose   ? "Void ratio is lowest at"
               : kind == LowestDense ? "Densest void ratio is lowest at"
               : kind == ActiveFines ? "Fines begin to carry load at"
                                     : "Strong coarse-fine contacts begin at";
    };
    std::vector<Headline> headlines;
    for (const study::ContentThreshold& each : thresholds) {
        // Found in a minority of the seeds, it is no threshold of the soil but of their noise.
        const bool most_have_it = 2 * each.at.seeds > std::ssize(each.at.of_seed);
        if (!most_have_it || each.kind == LowestBetween) {
            continue;
        }
        Headline headline{
            fixed(100 * each.at.mean, 0) + " %", label(each.kind),
            "fines content" + std::string(each.is_lowest() ? ", by a parabola" : "") + study::seeds_that_have(each.at),
            spread_text(each.at, 100, 0)};
        headlines.push_back(with_certainty(std::move(headline), each.at));
    }
    return headlines;
}

} // namespace suffuse::answer
