#include "suffuse/study/sample_results.hpp"

#include "suffuse/casefile/stage_traits.hpp"
#include "suffuse/erosion/mobility_result.hpp"
#include "suffuse/study/erosion_story.hpp"
#include "suffuse/study/mobility_story.hpp"
#include "suffuse/study/strength_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::study {
namespace {

using Stages = std::vector<record::FinishedStage>;
using Results = std::map<Result, double>;

void add_mobility(const record::FinishedStage& stage, SampleResults& to) {
    const erosion::MobilityResult* const mobility = mobility_of(stage);
    if (mobility == nullptr || !to.probe.empty()) {
        return;
    }
    to.probe = stage.stage->name;
    const auto add = [&](Result which, double value) {
        to.value.emplace(which, value);
        if (erosion::is_upper_bound(*mobility, 0.01)) {
            to.at_most.insert(which);
        }
    };
    if (mobility->moves_1) {
        add(Result::FirstMovement, *mobility->moves_1);
    }
    const auto safety = specified_gradient(stage) ? erosion::factor_of_safety(*mobility) : std::nullopt;
    if (safety && safety->factor) {
        add(Result::Safety, *safety->factor);
    }
}

void add_erosion(const Stages& stages, const casefile::Variant& sample, Results& to) {
    const erosion::ErosionResult erosion = passes_of(erosions_of_sample(stages, sample));
    const std::optional<ErosionSpan> span = span_of({&erosion});
    if (!span) {
        return;
    }
    to.emplace(span->is_by_force() ? Result::RemovedMass : Result::ErodedMass, erosion::eroded_percent(erosion) / 100);
    if (const erosion::PassResult* const worst = erosion::pass_of_largest_loss(erosion)) {
        to.emplace(Result::StressChange, -*erosion::stress_loss(*worst));
    }
    if (const auto change = erosion::permeability_change(erosion); change && !erosion.passes.back().failed) {
        to.emplace(Result::PermeabilityChange, *change);
    }
}

bool follows(const record::FinishedStage& stage, const record::FinishedStage& earlier) {
    const std::vector<casefile::Stage>& all = stage.variant->stages;
    int row = stage.stage->parent;
    while (row >= 0 && &all[static_cast<std::size_t>(row)] != earlier.stage) {
        row = all[static_cast<std::size_t>(row)].parent;
    }
    return row >= 0;
}

/// Of fines of one soil that travel with the water, in a stage and those that follow it, where no erosion by rules has
/// eroded the sample. What leaves after water has brought fines is not known to be the soil's own.
void add_migrations(const Stages& stages, const casefile::Variant& sample, Results& to) {
    const record::FinishedStage *first = nullptr, *last = nullptr;
    double lost = 0;
    for (const record::FinishedStage& stage : stages) {
        const auto& migration = stage.findings.migration;
        if (stage.variant == &sample && migration && migration->filter.filter_d15 == 0 &&
            (last == nullptr || (follows(stage, *last) && last->numbers.at("fed_mass_share") == 0))) {
            first = first == nullptr ? &stage : first;
            last = &stage;
            lost += (1 - lost) * stage.numbers.at("eroded_share_of_solids").get<double>();
        }
    }
    if (last != nullptr && erosions_of_sample(stages, sample).empty()) {
        to.emplace(Result::ErodedMass, lost);
        to.emplace(
            Result::PermeabilityChange, last->numbers.at("permeability_after").get<double>() /
                                            first->numbers.at("permeability_before").get<double>()
        );
    }
}

void add_removal(const record::FinishedStage& stage, Results& to) {
    const nlohmann::json& n = stage.numbers;
    if (std::holds_alternative<erosion::RemoveSpec>(stage.stage->spec) && n.contains("passes") && n.at("removed") > 0) {
        to.emplace(Result::RemovedMass, n.at("removed_mass_share").get<double>());
        if (!n.value("failed", false)) { // else how far it went is ours: `max_strain`
            to.emplace(Result::RemovalStrain, n.at("volumetric_strain").get<double>());
        }
    }
}

void add_test(const record::FinishedStage& stage, Results& to) {
    const triaxial::TriaxialSpec* test = test_of_strength(*stage.stage);
    if (test != nullptr && test->path != triaxial::Path::ConstantDeviator && stage.numbers.contains("response")) {
        to.emplace(Result::Strength, stage.numbers.at("response").at("peak_deviator").get<double>());
    }
}

void add_flow(const record::FinishedStage& stage, Results& to) {
    if (!std::holds_alternative<flow::FlowSpec>(stage.stage->spec)) {
        return;
    }
    const nlohmann::json along =
        stage.numbers.value("permeability_along", stage.numbers.value("permeability", nlohmann::json()));
    if (along.is_number()) {
        to.emplace(Result::Permeability, along.get<double>());
    }
}

/// The last state that was brought to rest before any test of the sample.
void add_state(const record::FinishedStage& stage, bool& is_prepared, Results& to) {
    const casefile::StageTraits& traits = casefile::traits_of(*stage.stage);
    const bool prepares = traits.origin == casefile::Origin::File || (traits.ends_balanced && !traits.loses_grains);
    const bool has_stress = stage.numbers.at("mean_stress").is_number() && stage.numbers.at("mean_stress") > 0;
    if (prepares && !is_prepared && has_stress && stage.numbers.at("void_ratio").is_number()) {
        to[Result::VoidRatio] = stage.numbers.at("void_ratio").get<double>();
    }
    is_prepared = is_prepared || !(prepares || traits.makes_sample());
}

} // namespace

std::optional<PermeabilityAfter>
permeability_after(const erosion::ErosionResult& erosion, flow::Conductance conductance) {
    const std::optional<double> change = erosion::permeability_change(erosion);
    if (!change || erosion.passes.back().failed) { // of a skeleton that goes on collapsing
        return std::nullopt;
    }
    const erosion::PassResult& last = erosion.passes.back();
    const erosion::PassResult& first = erosion.passes.front();
    PermeabilityAfter found{.before = first.permeability_before, .after = last.permeability_after, .change = *change};
    const std::optional<double> before = first.probe.flow.known_error.permeability;
    const std::optional<double> after = last.flow_after.known_error.permeability;
    found.known_error = before && after ? std::optional(std::max(*before, *after)) : std::nullopt;
    found.before_is_too_high = is_too_high(first.probe.flow, first.porosity_before, conductance);
    found.after_is_too_high = is_too_high(last.flow_after, last.porosity_after, conductance);
    return found;
}

Erosions erosions_of_sample(const Stages& stages, const casefile::Variant& sample) {
    return find_chain(stages, find_eroded(stages, [&](const record::FinishedStage& stage) {
                          return stage.variant == &sample;
                      }));
}

SampleResults results_of_sample(const Stages& stages, const casefile::Variant& sample) {
    SampleResults found;
    Results& value = found.value;
    bool is_prepared = false;
    for (const record::FinishedStage& stage : stages) {
        if (stage.variant == &sample) {
            add_state(stage, is_prepared, value);
            add_mobility(stage, found);
            add_removal(stage, value);
            add_test(stage, value);
            add_flow(stage, value);
        }
    }
    add_erosion(stages, sample, value);
    add_migrations(stages, sample, value);
    return found;
}

} // namespace suffuse::study
