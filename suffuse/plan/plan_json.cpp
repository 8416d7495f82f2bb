#include "suffuse/plan/plan.hpp"

namespace suffuse::plan {
namespace {

nlohmann::json range_json(const Range& range) {
    return {range.least, range.most};
}

nlohmann::json stage_json(const StageEstimate& stage) {
    nlohmann::json json = {
        {"study", stage.study},
        {"stage", stage.stage},
        {"verb", stage.verb},
        {"grains", stage.grains},
        {"steps", range_json(stage.steps)},
        {"seconds", range_json(stage.seconds)},
        {"memory", stage.memory},
        {"disk", stage.disk},
        {"basis", stage.basis},
        {"kind", stage.kind},
        {"by_tables", {{"steps", stage.tables_steps}, {"seconds", stage.tables_seconds}}},
        {"done", stage.is_done},
        {"cached", stage.is_cached},
    };
    if (stage.fines_content) {
        json["fines_content"] = *stage.fines_content;
        json["coarse_grains"] = stage.coarse;
        json["sized_by"] = stage.sized_by.empty() ? "particles" : stage.sized_by;
    }
    return json;
}

} // namespace

void to_json(nlohmann::json& json, const RunPlan& plan) {
    nlohmann::json stages = nlohmann::json::array();
    for (const StageEstimate& stage : plan.stages) {
        stages.push_back(stage_json(stage));
    }
    json = {
        {"studies", plan.studies},
        {"stages", stages},
        {"refined", {{"samples", range_json(plan.refined.samples)}, {"seconds", range_json(plan.refined.seconds)}}},
        {"steps", range_json(plan.steps)},
        {"seconds", range_json(plan.seconds)},
        {"memory", plan.memory},
        {"disk", plan.disk},
        {"threads", plan.speed.threads},
        {"samples_at_once", plan.speed.at_once},
        {"particle_steps_per_second", plan.speed.particle_steps_per_second},
        {"reference_steps_per_second", plan.speed.reference_speed()},
    };
}

} // namespace suffuse::plan
