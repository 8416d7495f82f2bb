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

/// "1.4 to 1.9": the least and most of what a swept study came to.
Headline range_headline(const study::StudyOutcome& outcome, Result which, const flow::Fluid& fluid) {
    const study::OutcomePoint *least = nullptr, *most = nullptr;
    for (const study::OutcomePoint& point : outcome.points) {
        if (const Scatter* const value = point.find(which)) {
            least = least == nullptr || value->mean < least->find(which)->mean ? &point : least;
            most = most == nullptr || value->mean > most->find(which)->mean ? &point : most;
        }
    }
    const auto text = [&](const study::OutcomePoint& point) {
        return result_text(which, point.find(which)->mean, fluid);
    };
    const auto where = [&](const study::OutcomePoint& point) {
        const std::string spread = result_spread(which, *point.find(which), fluid);
        std::string values;
        for (std::size_t k = 0; k < outcome.keys.size(); ++k) {
            values += (k == 0 ? "" : ", ") + value_in_words(point.at, k);
        }
        return values + (spread.empty() ? "" : " (" + spread + ")");
    };
    if (!study::depends_on_sweep(outcome, which)) {
        return {
            text(*least) == text(*most) ? text(*least) : text(*least) + " to " + text(*most), result_label(which),
            fmt::format("the same within scatter at all {} points", outcome.points.size())};
    }
    return {
        text(*least) + " to " + text(*most), result_label(which),
        fmt::format("at {} {} and {}", study::key_in_words(outcome.keys.front()), where(*least), where(*most))};
}

/// Of seeds where there are several, else of the one sample.
Headline seeds_headline(Result which, const Scatter& value, std::string detail, const flow::Fluid& fluid) {
    return with_certainty(
        {result_text(which, value.mean, fluid), result_label(which), std::move(detail),
         result_spread(which, value, fluid)},
        static_cast<std::size_t>(value.seeds)
    );
}

Headline
permeability_headline(const study::PermeabilityAfter& permeability, const Scatter& change, const flow::Fluid& fluid) {
    Headline headline = seeds_headline(
        Result::PermeabilityChange, change,
        fmt::format(
            "{} to {}{}", conductivity_text(permeability.before, fluid), permeability.is_too_high ? "at most " : "",
            conductivity_text(permeability.after, fluid)
        ),
        fluid
    );
    if (permeability.is_too_high) {
        headline.lead = "up to";
        headline.caution = "Known to be too high: the packing is too open or too mixed for the pore network.";
    } else if (permeability.known_error) {
        headline.detail += fmt::format("; each known to within {}", percent_text(*permeability.known_error));
    }
    return headline;
}

/// The result over the seeds, or else what the erosion of the one sample says.
Scatter over_seeds(const study::OutcomePoint* outcome, Result which, double of_one) {
    const Scatter* const found = outcome == nullptr ? nullptr : outcome->find(which);
    return found == nullptr ? study::scatter_of({of_one}) : *found;
}

} // namespace

Headline with_certainty(Headline headline, std::size_t samples) {
    if (samples < 2) {
        headline.detail += headline.detail.empty() ? "no replicate" : "; no replicate";
    } else if (headline.spread.empty()) {
        headline.detail +=
            fmt::format("{}the same in {} samples", headline.detail.empty() ? "" : "; ", count_in_words(samples));
    }
    return headline;
}

std::vector<Headline>
erosion_headlines(const ErosionResult& erosion, const flow::Fluid& fluid, const study::OutcomePoint* outcome) {
    std::vector<Headline> headlines;
    if (erosion.passes.empty()) {
        return headlines;
    }
    const auto& passes = erosion.passes;
    const std::string turns =
        fmt::format("in {} {}", count_in_words(passes.size()), passes.size() == 1 ? "pass" : "passes");
    const bool probed = !passes.front().probe.id.empty() && !erosion::is_forced(erosion);
    headlines.push_back(seeds_headline(
        Result::ErodedMass, over_seeds(outcome, Result::ErodedMass, erosion::eroded_percent(erosion) / 100),
        probed ? fmt::format("{} at i = {}", turns, passes.front().probe.gradient) : turns, fluid
    ));
    if (erosion::is_forced(erosion)) {
        headlines.back().label = result_label(Result::RemovedMass);
    }
    if (const auto permeability = study::permeability_after(erosion, fluid.conductance)) {
        headlines.push_back(permeability_headline(
            *permeability, over_seeds(outcome, Result::PermeabilityChange, permeability->change), fluid
        ));
    }
    if (const PassResult* const worst = erosion::pass_of_largest_loss(erosion)) {
        const double loss = *erosion::stress_loss(*worst);
        const Scatter change = over_seeds(outcome, Result::StressChange, -loss);
        Headline headline = seeds_headline(
            Result::StressChange, change,
            is_noise(100 * loss) ? "in all passes" : fmt::format("after pass {}, the largest loss", worst->pass), fluid
        );
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
    for (Headline& headline : headlines) {
        headline.detail += outcome.seeds() < 2 ? "; no replicate" : "";
    }
    if (outcome.study != nullptr) {
        const bool is_one = outcome.seeds() < 2;
        headlines.push_back(
            {fmt::format("{} of {}", outcome.samples(), outcome.study->variants.size()), "Samples run",
             fmt::format(
                 "{} values, {} {} each", outcome.points.size(), count_in_words(outcome.seeds()),
                 is_one ? "sample" : "seeds"
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
        headlines.push_back(with_certainty(std::move(headline), static_cast<std::size_t>(each.at.seeds)));
    }
    return headlines;
}

} // namespace suffuse::answer
