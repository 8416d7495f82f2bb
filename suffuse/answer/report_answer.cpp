// What a run found, in sentences with its numbers.
#include "suffuse/answer/report_answer.hpp"

#include "suffuse/answer/answer_tests.hpp"
#include "suffuse/answer/erosion_table.hpp"
#include "suffuse/answer/pass_words.hpp"
#include "suffuse/answer/strength_words.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/erosion/detachment.hpp"
#include "suffuse/figures/stress_probes.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/study/erosion_span.hpp"
#include "suffuse/study/findings_reason.hpp"
#include "suffuse/study/probed_states.hpp"
#include "suffuse/study/trace_curves.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace suffuse::answer {
namespace {

using nlohmann::json;

/// By the specified rule.
std::int64_t count_detachable(const erosion::ProbeResult& probe, const erosion::DetachSpec& rule) {
    return std::ranges::count(erosion::verdicts(rule, probe), std::uint8_t{1});
}

/// Whether gradients that differ ten times and more detach the same fines, to a fiftieth.
bool is_independent_of_gradient(const std::vector<erosion::ProbeResult>& probes, const erosion::DetachSpec& rule) {
    constexpr double wide = 10, alike = 0.02;
    double least_gradient = std::numeric_limits<double>::infinity(), most_gradient = 0;
    double fewest = least_gradient, most = 0;
    for (const erosion::ProbeResult& probe : probes) {
        if (probe.gradient <= 0) {
            continue;
        }
        const auto count = static_cast<double>(count_detachable(probe, rule));
        least_gradient = std::min(least_gradient, probe.gradient),
        most_gradient = std::max(most_gradient, probe.gradient);
        fewest = std::min(fewest, count), most = std::max(most, count);
    }
    return most > 0 && most_gradient >= wide * least_gradient && most - fewest <= alike * most;
}

std::string answer_to_probes(const std::vector<erosion::ProbeResult>& probes, const erosion::DetachSpec& rule) {
    std::string text = fmt::format("Of {} fines ", grouped(std::ssize(probes.front().id)));
    for (std::size_t k = 0; k < probes.size(); ++k) {
        const std::int64_t yes = count_detachable(probes[k], rule);
        text += fmt::format(
            "{}{} at the gradient i = {:g}",
            k == 0                   ? ""
            : k + 1 == probes.size() ? " and "
                                     : ", ",
            yes == 0 ? "none" : grouped(yes), probes[k].gradient
        );
    }
    text += rule.by == erosion::DetachBy::Displacement ? " are detachable, by their displacement." : " are detachable.";
    if (is_independent_of_gradient(probes, rule)) {
        text +=
            " The number does not depend measurably on the gradient, so these fines carry no load: without gravity any "
            "water moves them, and none of these gradients is critical.";
    }
    return text;
}

/// "571", "1,261 to 1,271".
std::string range_of(const std::vector<std::int64_t>& counts) {
    const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
    return *least == *most ? grouped(*least) : grouped(*least) + " to " + grouped(*most);
}

/// What a removal did to the samples of all seeds. @param numbers of their stages
std::string answer_to_removal(const std::string& name, const std::vector<const json*>& numbers) {
    std::vector<std::int64_t> grains, passes;
    std::vector<double> mass, strain;
    std::size_t failed = 0;
    for (const json* n : numbers) {
        grains.push_back(n->at("removed")), passes.push_back(std::ssize(n->at("passes")));
        mass.push_back(n->at("removed_mass_share")), strain.push_back(n->at("volumetric_strain"));
        failed += n->at("failed").get<bool>() ? 1 : 0;
    }
    const std::size_t samples = numbers.size();
    const study::Scatter share = study::scatter_of(mass), by = study::scatter_of(strain);
    const std::string many = samples == 1 ? "" : fmt::format(" ({} samples)", samples);
    return fmt::format(
        "{}{}: {} taken out in {} {}, {} % of the mass; under the stresses held before the skeleton strained by {} % "
        "in "
        "volume{}.",
        name, many, grains == std::vector<std::int64_t>(samples, 1) ? fines_text(1) : range_of(grains) + " fines",
        range_of(passes), passes == std::vector<std::int64_t>(samples, 1) ? "pass" : "passes",
        study::with_scatter(share, 100), is_noise(100 * by.mean) ? "less than 0.01" : study::with_scatter(by, 100),
        failed == 0    ? ""
        : samples == 1 ? ", and failed"
                       : fmt::format(", and failed in {} of them", failed)
    );
}

/// Of stages that take fines out without water, as long as these are few.
std::vector<std::string> answers_to_removals(const std::vector<record::FinishedStage>& stages) {
    constexpr std::size_t most = 4;
    std::vector<std::pair<std::string, std::vector<const json*>>> removals; // by the name that all seeds share
    for (const record::FinishedStage& stage : stages) {
        const bool took_some = std::holds_alternative<erosion::RemoveSpec>(stage.stage->spec) &&
                               stage.numbers.contains("passes") && stage.numbers.at("removed") > 0;
        if (!took_some) {
            continue;
        }
        const std::string name = study::in_words(stage);
        auto removal = std::ranges::find(removals, name, &decltype(removals)::value_type::first);
        if (removal == removals.end()) {
            removal = removals.insert(removal, {name, {}});
        }
        removal->second.push_back(&stage.numbers);
    }
    std::vector<std::string> sentences;
    sentences.reserve(removals.size());
    for (const auto& [name, numbers] : removals) {
        sentences.push_back(answer_to_removal(name, numbers));
    }
    return sentences.size() <= most ? sentences : std::vector<std::string>{};
}

std::string describe_question(const study::ErosionStory& story, bool has_strength) {
    const std::size_t passes = story.erosion.passes.size();
    const std::string& soil = story.eroded->variant->soil_name;
    const study::ErosionSpan span = *study::span_of({&story.erosion});
    const bool is_one = span.least_gradient == span.most_gradient;
    const std::string which =
        span.is_by_force()
            ? fmt::format(
                  "how removing fines of the soil “{}” by force, in {} {}, changes", soil, passes,
                  passes == 1 ? "pass" : "passes"
              )
            : fmt::format(
                  "which fines of the soil “{}” {} i = {} {}, and how {} {} of their removal {}", soil,
                  is_one ? "a gradient of" : "gradients of", span.gradients(), is_one ? "detaches" : "detach", passes,
                  passes == 1 ? "pass" : "passes", passes == 1 ? "changes" : "change"
              );
    return fmt::format(
        "Question: {} stress, volume{} permeability{}.", which, has_strength ? "," : " and",
        has_strength ? " and strength" : ""
    );
}

/// How much of the soil the sample stands for, where its curve was cut.
std::optional<std::string> describe_part(const study::ErosionStory& story) {
    if (story.eroded == nullptr || !story.eroded->variant->soil || !story.eroded->variant->soil->measured) {
        return std::nullopt;
    }
    const grains::Grading& part = *story.eroded->variant->soil->whole;
    const grains::Grading& measured = *story.eroded->variant->soil->measured;
    const double finest = part.diameter.front(), coarsest = part.diameter.back();
    const double below = grains::passing(measured, finest), up_to = grains::passing(measured, coarsest);
    return fmt::format(
        "Only its grains from {} to {} mm are in the sample, {} % of its mass: {} % are finer, {} % coarser. All that "
        "follows is of that part.",
        short_number(1e3 * finest), short_number(1e3 * coarsest), short_number(100 * (up_to - below)),
        short_number(100 * below), short_number(100 * (1 - up_to))
    );
}

/// The stage whose end an erosion starts from.
const casefile::Stage& start_of(const record::FinishedStage& erosion) {
    return erosion.variant->stages[static_cast<std::size_t>(std::max(0, erosion.stage->parent))];
}

/// The state that the erosion starts from; nothing without an erosion.
std::optional<std::string>
describe_start(const study::ErosionStory& story, const std::vector<record::FinishedStage>& stages) {
    if (story.eroded == nullptr) {
        return std::nullopt;
    }
    const std::string& start = start_of(*story.eroded).name;
    const auto found = std::ranges::find_if(stages, [&](const record::FinishedStage& stage) {
        return stage.variant == story.eroded->variant && stage.stage->name == start;
    });
    if (found == stages.end()) {
        return std::nullopt;
    }
    const json& n = found->numbers;
    return fmt::format(
        "{} grains carry {:.4g} kPa at void ratio {:.3f} (porosity {:.3f}, {:.2f} contacts a grain, {} rattlers).",
        grouped(n.at("grains").get<std::int64_t>()), n.at("mean_stress").get<double>() / 1e3,
        n.at("void_ratio").get<double>(), n.at("porosity").get<double>(), n.at("coordination").get<double>(),
        grouped(n.at("rattlers").get<std::int64_t>())
    );
}

/// Whether one sample was eroded from so many states, or in so many ways, that one stands for all.
bool are_too_many(const study::ErosionStory& story) {
    constexpr std::size_t most_reported = 3;
    return story.others.size() >= most_reported;
}

/// Where several samples were eroded: which one the answer describes, and how far apart they lie.
std::optional<std::string>
describe_range(const study::ErosionStory& story, const std::vector<record::FinishedStage>& stages) {
    std::vector<double> percent;
    for (const record::FinishedStage& stage : stages) {
        if (stage.findings.erosion && !stage.findings.erosion->passes.empty()) {
            percent.push_back(erosion::eroded_percent(*stage.findings.erosion));
        }
    }
    if (story.eroded == nullptr || percent.size() < 2 ||
        (percent.size() == story.others.size() + 1 && !are_too_many(story))) {
        return std::nullopt; // all of one sample, and reported one after the other
    }
    const auto [least, most] = std::minmax_element(percent.begin(), percent.end());
    return fmt::format(
        "{} erosions removed {:.2f} to {:.2f} % of the mass (table “All erosions”); the following describes {}.",
        percent.size(), *least, *most, study::in_words_of_sample(*story.eroded)
    );
}

/// "“first”, then “second”: " where stages follow each other; nothing where one stage is all that eroded.
std::string name_chain(const study::ErosionStory& story) {
    if (story.others.empty() && story.chain.size() == 1) {
        return {};
    }
    std::vector<std::string> names;
    for (const record::FinishedStage* stage : story.chain) {
        names.push_back(fmt::format("“{}”", stage->stage->name));
    }
    return fmt::format("{}: ", fmt::join(names, ", then "));
}

} // namespace

std::vector<std::string> answer_of_erosion(const study::RunResults& results) {
    const study::ErosionStory& story = results.story;
    const std::vector<record::FinishedStage>& stages = results.stages;
    const std::vector<study::StrengthChange>& strength = results.strength;
    std::vector<std::string> sentences;
    if (!story.erosion.passes.empty() && !story.erosion.passes.front().probe.id.empty()) {
        sentences.push_back(describe_question(story, !strength.empty()));
    }
    if (auto part = describe_part(story)) {
        sentences.push_back(std::move(*part));
    }
    if (auto range = describe_range(story, stages)) {
        sentences.push_back(std::move(*range));
    }
    if (auto start = describe_start(story, stages)) {
        sentences.push_back(std::move(*start));
    }
    if (!story.probes.empty()) {
        sentences.push_back(answer_to_probes(story.probes, story.probed_by));
    }
    if (!story.erosion.passes.empty()) {
        sentences.push_back(name_chain(story) + answer_to_erosion(story.erosion));
        for (const erosion::PassResult& pass : story.erosion.passes) {
            if (std::string noise = study::describe_noise(&pass); !noise.empty()) {
                sentences.push_back(std::move(noise));
            }
        }
        if (std::string idle = describe_idle(story.erosion); !idle.empty() &&
                                                             !story.erosion.passes.front().probe.id.empty() &&
                                                             !study::span_of({&story.erosion})->has_forced) {
            sentences.push_back(std::move(idle));
        }
    }
    if (!are_too_many(story)) {
        for (const record::FinishedStage* other : story.others) {
            sentences.push_back(fmt::format(
                "“{}”, from the state “{}”: {}", other->stage->name, start_of(*other).name,
                answer_to_erosion(*other->findings.erosion)
            ));
        }
    }
    for (std::string& sentence : answers_to_removals(stages)) {
        sentences.push_back(std::move(sentence));
    }
    for (std::string& sentence : strength_sentences(strength)) {
        sentences.push_back(std::move(sentence));
    }
    for (std::string& sentence : describe_tests(stages, strength)) {
        sentences.push_back(std::move(sentence));
    }
    for (const study::ProbedState& state : results.probed_states) {
        sentences.push_back(figures::describe_stability(state));
    }
    return sentences;
}

} // namespace suffuse::answer
