#include "suffuse/study/study_outcome.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/student.hpp"
#include "suffuse/study/mobility_story.hpp"
#include "suffuse/study/sample_results.hpp"
#include "suffuse/study/trace_curves.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace suffuse::study {
namespace {

using Stages = std::vector<record::FinishedStage>;

bool has_result(const Stages& stages, const casefile::Variant& sample) {
    return !results_of_sample(stages, sample).value.empty();
}

/// Without the samples that failed before they had any.
OutcomePoint with_results(const OutcomePoint& point, const Stages& stages) {
    OutcomePoint kept{point.at, {}, {}, {}, {}};
    kept.at.seed.clear();
    for (std::size_t k = 0; k < point.samples.size(); ++k) {
        if (has_result(stages, *point.samples[k])) {
            kept.samples.push_back(point.samples[k]);
            kept.at.seed.push_back(point.at.seed[k]);
        }
    }
    return kept;
}

void leave_out_what_has_none(std::vector<OutcomePoint>& points, const Stages& stages) {
    std::vector<OutcomePoint> kept;
    kept.reserve(points.size());
    for (const OutcomePoint& point : points) {
        kept.push_back(with_results(point, stages));
    }
    std::erase_if(kept, [](const OutcomePoint& point) { return point.samples.empty(); });
    if (!kept.empty()) {
        points = std::move(kept);
    }
}

OutcomePoint summed_up(OutcomePoint point, const Stages& stages, flow::Conductance conductance) {
    std::vector<SampleResults> of_sample;
    for (const casefile::Variant* sample : point.samples) {
        of_sample.push_back(results_of_sample(stages, *sample));
        point.at_most.insert(of_sample.back().at_most.begin(), of_sample.back().at_most.end());
        if (const auto span = span_of(erosions_of_sample(stages, *sample), conductance)) {
            point.erosion = point.erosion ? joined(*point.erosion, *span) : *span;
        }
    }
    for (int k = 0; k < results; ++k) {
        std::vector<double> values;
        for (const SampleResults& numbers : of_sample) {
            const auto found = numbers.value.find(static_cast<Result>(k));
            values.push_back(found == numbers.value.end() ? std::nan("") : found->second);
        }
        if (Scatter scatter = scatter_of(std::move(values)); scatter.seeds > 0) {
            point.result[static_cast<Result>(k)] = std::move(scatter);
        }
    }
    return point;
}

} // namespace

ResultScale scale_of(Result which) {
    constexpr double percent = 100, kilo = 1e-3, pico = 1e12, per_mille = 1e-3;
    switch (which) {
    case Result::Safety:
        return {"Factor of safety against first movement", "", 1, 0.05};
    case Result::FirstMovement:
        return {"Gradient that moves 1 % of the fines", "", 1, 0.005};
    case Result::ErodedMass:
        return {"Mass carried out", "%", percent, per_mille};
    case Result::RemovedMass:
        return {"Mass taken out", "%", percent, per_mille};
    case Result::PermeabilityChange:
        return {"Permeability after the loss", "× before", 1, 0.01};
    case Result::StressChange:
        return {"Mean stress at constant volume", "% of change", percent, per_mille};
    case Result::RemovalStrain:
        return {"Volume that the loss costs", "%", percent, per_mille};
    case Result::Strength:
        return {"Peak strength", "kPa", kilo, 500};
    case Result::Permeability:
        return {"Permeability", "10⁻¹² m²", pico, 0};
    case Result::VoidRatio:
        return {"Void ratio at rest", "", 1, per_mille};
    }
    throw Bug("a result without a scale");
}

const Scatter* OutcomePoint::find(Result which) const {
    const auto found = result.find(which);
    return found == result.end() ? nullptr : &found->second;
}

std::size_t StudyOutcome::samples() const {
    std::size_t count = 0;
    for (const OutcomePoint& point : points) {
        count += point.samples.size();
    }
    return count;
}

std::size_t StudyOutcome::seeds() const {
    std::size_t most = 0;
    for (const OutcomePoint& point : points) {
        most = std::max(most, point.samples.size());
    }
    return most;
}

std::size_t StudyOutcome::fewest_seeds() const {
    std::size_t fewest = seeds();
    for (const OutcomePoint& point : points) {
        fewest = std::min(fewest, point.samples.size());
    }
    return fewest;
}

bool StudyOutcome::has(Result which) const {
    const auto count =
        std::ranges::count_if(points, [&](const OutcomePoint& point) { return point.find(which) != nullptr; });
    return count > 0 && 2 * count >= std::ssize(points);
}

std::vector<StudyOutcome> gather_outcomes(const casefile::Case& what, const Stages& stages) {
    std::vector<StudyOutcome> outcomes;
    for (const casefile::Study& study : what.studies) {
        StudyOutcome outcome{.study = &study};
        std::vector<std::string> probes;
        for (const casefile::Sweep& sweep : study.sweep) {
            outcome.keys.push_back(sweep.key);
        }
        for (const record::FinishedStage& stage : stages) {
            if (stage.study != &study) {
                continue;
            }
            if (mobility_of(stage) != nullptr && std::ranges::count(probes, stage.stage->name) == 0) {
                probes.push_back(stage.stage->name);
            }
            SweepPoint at = point_of(study, *stage.variant);
            auto point = std::ranges::find_if(outcome.points, [&](const OutcomePoint& other) {
                return other.at.written == at.written;
            });
            if (point == outcome.points.end()) {
                point = outcome.points.insert(outcome.points.end(), {std::move(at), {}, {}});
            }
            if (std::ranges::count(point->samples, stage.variant) == 0) {
                point->samples.push_back(stage.variant);
                point->at.seed.push_back(stage.variant->seed);
            }
        }
        leave_out_what_has_none(outcome.points, stages);
        for (OutcomePoint& point : outcome.points) {
            point = summed_up(std::move(point), stages, what.fluid.conductance);
        }
        std::ranges::stable_sort(outcome.points, comes_before, &OutcomePoint::at);
        std::set<std::vector<std::string>> specified;
        for (const casefile::Variant& variant : study.variants) {
            specified.insert(sweep_values(study, variant));
        }
        outcome.specified = specified.size();
        outcome.first_probe = probes.size() > 1 ? probes.front() : "";
        if (!outcome.points.empty()) {
            outcomes.push_back(std::move(outcome));
        }
    }
    return outcomes;
}

const StudyOutcome* main_outcome(const std::vector<StudyOutcome>& outcomes) {
    const auto main = std::ranges::max_element(outcomes, {}, [](const StudyOutcome& outcome) {
        return std::pair(outcome.samples(), outcome.points.size());
    });
    return main == outcomes.end() ? nullptr : &*main;
}

namespace {

/// By seed, what the second point has more than the first.
std::vector<double> differences_by_seed(const OutcomePoint& first, const OutcomePoint& second, Result which) {
    std::map<std::uint64_t, double> of_seed;
    for (std::size_t k = 0; k < first.at.seed.size(); ++k) {
        of_seed[first.at.seed[k]] = first.find(which)->of_seed[k];
    }
    std::vector<double> differences;
    for (std::size_t k = 0; k < second.at.seed.size(); ++k) {
        if (const auto pair = of_seed.find(second.at.seed[k]); pair != of_seed.end()) {
            differences.push_back(second.find(which)->of_seed[k] - pair->second);
        }
    }
    return differences;
}

/// How far the means of two points can be apart by chance.
double apart_by_chance(const OutcomePoint& first, const OutcomePoint& second, Result which, double largest_deviation) {
    constexpr double deviations = 2; // of single samples
    const Scatter difference = scatter_of(differences_by_seed(first, second, which));
    if (difference.seeds < 2) {
        return deviations * largest_deviation;
    }
    const auto pairs = static_cast<std::size_t>(difference.seeds);
    return student_90(pairs - 1) * difference.standard_deviation / std::sqrt(difference.seeds);
}

} // namespace

SweepEffect effect_of_sweep(const StudyOutcome& outcome, Result which) {
    constexpr double notable = 0.05;
    SweepEffect effect;
    double largest_deviation = 0, size = 0;
    const auto mean = [&](const OutcomePoint* point) { return point->find(which)->mean; };
    for (const OutcomePoint& point : outcome.points) {
        const Scatter* const value = point.find(which);
        if (value == nullptr) {
            continue;
        }
        const bool is_first = effect.points++ == 0;
        effect.first = is_first ? &point : effect.first;
        effect.last = &point;
        effect.least = is_first || value->mean < mean(effect.least) ? &point : effect.least;
        effect.most = is_first || value->mean > mean(effect.most) ? &point : effect.most;
        effect.fewest_samples = is_first ? value->seeds : std::min(effect.fewest_samples, value->seeds);
        effect.most_samples = std::max(effect.most_samples, value->seeds);
        largest_deviation = std::max(largest_deviation, value->standard_deviation);
        size = std::max(size, std::abs(value->mean));
    }
    if (effect.points > 0) {
        const double apart = mean(effect.most) - mean(effect.least);
        const double scatter = apart_by_chance(*effect.least, *effect.most, which, largest_deviation);
        effect.difference = apart > std::max({scatter, notable * size, scale_of(which).least}) ? Difference::Clear
                            : effect.has_scatter() && apart <= scatter ? Difference::WithinScatter
                                                                       : Difference::Small;
    }
    return effect;
}

bool depends_on_sweep(const StudyOutcome& outcome, Result which) {
    return effect_of_sweep(outcome, which).difference == Difference::Clear;
}

std::string keys_in_words(const StudyOutcome& outcome) {
    std::string words;
    for (const std::string& key : outcome.keys) {
        words += (words.empty() ? "" : &key == &outcome.keys.back() ? " and " : ", ") + key_in_words(key, outcome.keys);
    }
    return words;
}

std::optional<Result> main_result(const StudyOutcome& outcome) {
    std::optional<Result> first;
    for (int k = 0; k < results; ++k) {
        const auto which = static_cast<Result>(k);
        if (!outcome.has(which)) {
            continue;
        }
        if (outcome.points.size() < 2 || depends_on_sweep(outcome, which)) {
            return which;
        }
        first = first ? first : which;
    }
    return first;
}

} // namespace suffuse::study
