#include "suffuse/study/probed_states.hpp"

#include "suffuse/record/result_json.hpp"
#include "suffuse/study/trace_curves.hpp"

#include <algorithm>

namespace suffuse::study {
namespace {

constexpr std::size_t most_states = 6; ///< as many as there are colors

bool is_probed(const record::FinishedStage& stage) {
    return std::holds_alternative<triaxial::StressProbeSpec>(stage.stage->spec);
}

/// "STUDY, VALUE OF THE SWEEP, STAGE": as much of it as distinguishes states.
std::string name_of(const record::FinishedStage& stage, const std::vector<record::FinishedStage>& all) {
    const bool is_only_study = std::ranges::all_of(all, [&](const record::FinishedStage& o) {
        return !is_probed(o) || o.study == stage.study;
    });
    std::string name = is_only_study ? "" : stage.study->name + ", ";
    const std::string values = values_name(*stage.study, *stage.variant);
    return name + values + (values.empty() ? "" : ", ") + stage.stage->name;
}

/// Adds one sample's answers to the mean of `state`, in which there are already `state.samples`.
void add(const std::vector<triaxial::StressProbe>& probes, int axis, ProbedState& state) {
    const double had = state.samples, share = 1 / (had + 1);
    const auto average = [&](double& mean, double value) { mean = share * (had * mean + value); };
    const auto lateral = [&](const Vec3& v) { return 0.5 * (v[(axis + 1) % 3] + v[(axis + 2) % 3]); };
    state.directions.resize(probes.size());
    for (std::size_t k = 0; k < probes.size(); ++k) {
        ProbedDirection& direction = state.directions[k];
        direction.angle = probes[k].angle;
        average(direction.normalized_work, probes[k].normalized);
        average(direction.axial_stress, probes[k].stress[axis]);
        average(direction.lateral_stress, lateral(probes[k].stress));
        average(direction.axial_strain, probes[k].strain[axis]);
        average(direction.lateral_strain, lateral(probes[k].strain));
        direction.unstable += probes[k].is_unstable() ? 1 : 0;
    }
    ++state.samples;
}

} // namespace

std::vector<ProbedState> gather_probed_states(const std::vector<record::FinishedStage>& stages) {
    std::vector<ProbedState> states;
    for (const record::FinishedStage& stage : stages) {
        if (!is_probed(stage)) {
            continue;
        }
        const std::string name = name_of(stage, stages);
        auto state = std::ranges::find(states, name, &ProbedState::name);
        if (state == states.end()) {
            if (states.size() == most_states) {
                continue;
            }
            states.push_back({name, {}, 0});
            state = std::prev(states.end());
        }
        const int axis = std::get<triaxial::StressProbeSpec>(stage.stage->spec).axis;
        add(stage.numbers.at("stress_probes").get<std::vector<triaxial::StressProbe>>(), axis, *state);
    }
    return states;
}

} // namespace suffuse::study
