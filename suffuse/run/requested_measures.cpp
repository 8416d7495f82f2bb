#include "suffuse/run/requested_measures.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/cell/strain.hpp"
#include "suffuse/erosion/passage.hpp"
#include "suffuse/flow/seepage.hpp"
#include "suffuse/grains/gradation.hpp"
#include "suffuse/record/result_json.hpp"

#include <fmt/format.h>

#include <functional>
#include <map>

namespace suffuse::run {
namespace {

using nlohmann::json;

json pick(const json& from, const std::vector<const char*>& names) {
    json picked = json::object();
    for (const char* const name : names) {
        picked[name] = from.value(name, json(nullptr));
    }
    return picked;
}

/// The same of each pass.
json pick_of_passes(const json& numbers, const std::vector<const char*>& names) {
    json list = json::array();
    for (const json& pass : numbers.at("passes")) {
        list.push_back(pick(pass, names));
    }
    return {{"passes", list}};
}

json permeability(const StageWork& work) {
    flow::FlowSpec spec;
    spec.tensor = true;
    const flow::Seepage seepage = flow::solve_seepage(
        work.world.cell, work.world.grains.position, work.world.grains.radius, spec, work.what.fluid
    );
    const Mat3& tensor = *seepage.tensor;
    return {{"mean", (tensor(0, 0) + tensor(1, 1) + tensor(2, 2)) / 3}, {"tensor", tensor}};
}

json constrictions(const StageWork& work) {
    const erosion::Constrictions found = erosion::measure_coarse_skeleton(work.world, {0, 0, 1}, false).constrictions;
    return {{"mean", found.mean}, {"median", found.median}, {"d35", found.d35}, {"count", found.diameter.size()}};
}

json grading(const StageWork& work) {
    const grains::Gradation all = grains::measure_gradation(work.world.grains);
    const auto size = [&](double share) { return grains::size_at(all, share); };
    return {
        {"d10", size(0.1)},
        {"d30", size(0.3)},
        {"d50", size(0.5)},
        {"d60", size(0.6)},
        {"smallest", size(0)},
        {"largest", size(1)},
        {"uniformity", size(0.6) / size(0.1)}};
}

/// Logarithmic, from the stage's start to its end, compression positive.
json volumetric_strain(const StageWork& work) {
    return {{"volumetric_strain", cell::volumetric_strain(work.world.reference_h, work.world.cell.h)}};
}

json flow_of(const json& numbers) {
    return numbers.contains("passes") ? pick_of_passes(numbers, {"permeability_before", "permeability_after"})
                                      : pick(numbers, {"gradient", "permeability", "mean_velocity", "force_sum"});
}

/// Of each pass of an erosion; of a removal all together.
json eroded(const json& numbers) {
    return numbers.contains("coordination_histogram") ? pick(numbers, {"removed", "coordination_histogram"})
                                                      : pick_of_passes(numbers, {"removed", "coordination_histogram"});
}

json measure(const std::string& group, const StageWork& work, const json& numbers) {
    static const std::map<std::string, std::vector<const char*>> choices = {
        {"void-ratios", {"void_ratio", "intergranular_void_ratio", "equivalent_void_ratio"}},
        {"active-fines", {"fines_content", "active_fines_fraction", "fines_stress_share"}},
        {"contact-classes", {"contacts", "contact_share", "coordination_by_class"}},
        {"strong-contacts", {"strong_contact_share", "force_distribution"}},
        {"stress-strain", {"strain_rate", "response"}},
        {"stress", {"stress", "mean_stress", "deviator_stress"}},
        {"coordination", {"coordination", "mechanical_coordination", "backbone_coordination", "rattlers"}},
        {"porosity", {"porosity"}},
        {"skempton-b", {"skempton_b"}},
    };
    static const std::map<std::string, std::function<json(const StageWork&)>> done = {
        {"permeability", permeability},
        {"constrictions", constrictions},
        {"grading", grading},
        {"volumetric-strain", volumetric_strain},
    };
    if (const auto names = choices.find(group); names != choices.end()) {
        return pick(numbers, names->second);
    }
    if (const auto act = done.find(group); act != done.end()) {
        return act->second(work);
    }
    return group == "flow" ? flow_of(numbers) : eroded(numbers);
}

} // namespace

json requested_measures(StageWork& work, const json& numbers) {
    json measured = json::object();
    for (const std::string& group : work.stage.measure) {
        const auto cannot = [&](const Error& error) {
            measured[group] = nullptr;
            work.warnings.push_back(fmt::format("{}: {} cannot be measured: {}", work.place(), group, error.what()));
        };
        try { // hours of steps are not lost for a state that has no water's way
            measured[group] = measure(group, work, numbers);
        } catch (const GeometryError& error) {
            cannot(error);
        } catch (const SolverError& error) {
            cannot(error);
        }
    }
    return measured;
}

} // namespace suffuse::run
