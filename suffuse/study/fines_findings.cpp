#include "suffuse/study/fines_findings.hpp"

#include "suffuse/grains/grading.hpp"

namespace suffuse::study {
namespace {

using nlohmann::json;

std::optional<double> peak_of(const record::FinishedStage& stage) {
    return stage.numbers.contains("response")
               ? std::optional(stage.numbers.at("response").at("peak_deviator").get<double>())
               : std::nullopt;
}

/// Drained compression to an end, from the state that a stage left.
std::optional<double>
peak_from(const std::vector<record::FinishedStage>& stages, const casefile::Variant* variant, int row) {
    for (const record::FinishedStage& stage : stages) {
        if (stage.variant != variant || stage.stage->parent != row) {
            continue;
        }
        const auto* spec = std::get_if<triaxial::TriaxialSpec>(&stage.stage->spec);
        if (spec != nullptr && spec->path == triaxial::Path::Drained && !spec->stops_at_stress()) {
            return peak_of(stage);
        }
    }
    return std::nullopt;
}

/// Peak strength with all fines: from the state before the removal, or from one that this came from.
std::optional<double> peak_before(
    const std::vector<record::FinishedStage>& stages, const casefile::Variant* variant, const casefile::Stage& removal
) {
    for (int row = removal.parent; row >= 0; row = variant->stages[static_cast<std::size_t>(row)].parent) {
        if (const std::optional<double> peak = peak_from(stages, variant, row)) {
            return peak;
        }
    }
    return std::nullopt;
}

/// D50 of the coarse grains over that of the fines; nothing for a soil of one grading.
std::optional<double> size_ratio_of(const casefile::Study& study) {
    for (const casefile::Variant& variant : study.variants) {
        if (variant.soil && variant.soil->coarse && variant.soil->fines) {
            return grains::size_at(*variant.soil->coarse, 0.5) / grains::size_at(*variant.soil->fines, 0.5);
        }
    }
    return std::nullopt;
}

Removal describe_removal(const std::vector<record::FinishedStage>& stages, const record::FinishedStage& stage) {
    const json& n = stage.numbers;
    Removal removal;
    removal.fines_content = stage.variant->soil && stage.variant->soil->fines
                                ? stage.variant->soil->fines_content
                                : n.at("removed_mass_share").get<double>();
    removal.seed = stage.variant->seed;
    removal.stress_ratio = n.at("stress_ratio_before");
    removal.removed_share = n.at("removed_mass_share");
    removal.strain = n.at("largest_strain");
    removal.stress_loss = n.at("stress_loss");
    removal.failed = n.at("failed");
    const int row = static_cast<int>(stage.stage - stage.variant->stages.data());
    removal.peak_after = peak_from(stages, stage.variant, row);
    removal.peak_before = peak_before(stages, stage.variant, *stage.stage);
    return removal;
}

} // namespace

std::optional<FinesResults>
gather_fines(const std::optional<FinesSweep>& sweep, const std::vector<record::FinishedStage>& stages) {
    FinesResults found;
    if (sweep && sweep->traced.keys.size() == 1 && sweep->study->sweep.front().values.size() > 2) {
        found.study = sweep->study->name;
        found.size_ratio = size_ratio_of(*sweep->study);
        found.loose_stage = sweep->loose;
        found.dense_stage = sweep->dense;
        found.loose = loose_points(*sweep);
        found.dense = sweep_points(*sweep, sweep->dense);
        found.thresholds = find_thresholds(found.loose, found.dense.points.empty() ? nullptr : &found.dense);
    }
    for (const record::FinishedStage& stage : stages) {
        const auto* spec = std::get_if<erosion::RemoveSpec>(&stage.stage->spec);
        if (spec != nullptr && spec->takes_all_fines_at_once()) {
            found.removals.push_back(describe_removal(stages, stage));
        }
    }
    return found.loose.points.empty() && found.removals.empty() ? std::nullopt : std::optional(std::move(found));
}

std::vector<Finding> judge_fines_of(const std::optional<FinesResults>& results) {
    if (!results) {
        return {};
    }
    return judge_fines(
        results->loose.points.empty() ? nullptr : &results->loose,
        results->dense.points.empty() ? nullptr : &results->dense, results->removals, results->size_ratio
    );
}

void mark_thresholds(const std::vector<ContentThreshold>& thresholds, FinesStudy& study) {
    const auto add = [](std::vector<Threshold>& to, const char* name, const Scatter& at) {
        to.push_back({name, at.mean, at.mean - at.standard_deviation, at.mean + at.standard_deviation});
    };
    for (const ContentThreshold& each : thresholds) {
        if (each.at.seeds == 0) {
            continue;
        }
        switch (each.kind) {
        case ThresholdKind::LowestLoose:
            add(study.density, "FC_threshold of e", each.at);
            break;
        case ThresholdKind::LowestDense:
            add(study.density, "FC_threshold of e_min", each.at);
            break;
        case ThresholdKind::ActiveFines:
            add(study.activity, "FC_active by b", each.at);
            break;
        case ThresholdKind::StrongContacts:
            add(study.activity, "FC_active by strong LS", each.at);
            break;
        case ThresholdKind::LowestBetween:
            break; // none of the figures' own curves
        }
    }
}

json thresholds_json(const std::optional<FinesResults>& results) {
    json list = json::array();
    if (!results) {
        return list;
    }
    for (const ContentThreshold& threshold : results->thresholds) {
        list.push_back(
            {{"study", results->study},
             {"name", threshold.name()},
             {"from", threshold.from()},
             {"of_seed", threshold.at.of_seed},
             {"mean", threshold.at.mean},
             {"standard_deviation", threshold.at.seeds > 1 ? json(threshold.at.standard_deviation) : json()}}
        );
    }
    return list;
}

} // namespace suffuse::study
