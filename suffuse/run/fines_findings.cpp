#include "suffuse/run/fines_findings.hpp"

#include "suffuse/report/words.hpp"
#include "suffuse/run/fines_sweep.hpp"

#include <fmt/format.h>

namespace suffuse::run {
namespace {

using nlohmann::json;

std::optional<double> peak_of(const FinishedStage& stage) {
    return stage.numbers.contains("response")
               ? std::optional(stage.numbers.at("response").at("peak_deviator").get<double>())
               : std::nullopt;
}

/// Drained compression to an end, from the state that a stage left.
std::optional<double> peak_from(const std::vector<FinishedStage>& stages, const casefile::Variant* variant, int row) {
    for (const FinishedStage& stage : stages) {
        if (stage.variant != variant || stage.stage->parent != row) {
            continue;
        }
        const auto* spec = std::get_if<triaxial::TriaxialSpec>(&stage.stage->spec);
        if (spec != nullptr && spec->path == triaxial::Path::Drained && !spec->deviator_stress && !spec->stress_ratio) {
            return peak_of(stage);
        }
    }
    return std::nullopt;
}

/// Peak strength with all fines: from the state before the removal, or from one that this came from.
std::optional<double> peak_before(
    const std::vector<FinishedStage>& stages, const casefile::Variant* variant, const casefile::Stage& removal
) {
    for (int row = removal.parent; row >= 0; row = variant->stages[static_cast<std::size_t>(row)].parent) {
        if (const std::optional<double> peak = peak_from(stages, variant, row)) {
            return peak;
        }
    }
    return std::nullopt;
}

report::Removal describe_removal(const std::vector<FinishedStage>& stages, const FinishedStage& stage) {
    const json& n = stage.numbers;
    report::Removal removal;
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

std::optional<FinesResults> gather_fines(const casefile::Case& what, const std::vector<FinishedStage>& stages) {
    FinesResults found;
    const std::optional<FinesSweep> sweep = find_fines_sweep(what, stages);
    if (sweep && sweep->traced.keys.size() == 1 && sweep->study->sweep.front().values.size() > 2) {
        found.study = sweep->study->name;
        found.loose_stage = sweep->loose;
        found.dense_stage = sweep->dense;
        found.loose = sweep_points(*sweep, sweep->loose);
        found.dense = sweep_points(*sweep, sweep->dense);
        found.thresholds = report::find_thresholds(found.loose, found.dense.points.empty() ? nullptr : &found.dense);
    }
    for (const FinishedStage& stage : stages) {
        const auto* spec = std::get_if<erosion::RemoveSpec>(&stage.stage->spec);
        if (spec != nullptr && spec->takes_all_fines_at_once()) {
            found.removals.push_back(describe_removal(stages, stage));
        }
    }
    return found.loose.points.empty() && found.removals.empty() ? std::nullopt : std::optional(std::move(found));
}

std::vector<report::Finding> judge_fines_of(const std::optional<FinesResults>& results) {
    if (!results) {
        return {};
    }
    return report::judge_fines(
        results->loose.points.empty() ? nullptr : &results->loose,
        results->dense.points.empty() ? nullptr : &results->dense, results->removals
    );
}

json thresholds_json(const std::optional<FinesResults>& results) {
    json list = json::array();
    if (!results) {
        return list;
    }
    for (const report::ContentThreshold& threshold : results->thresholds) {
        list.push_back(
            {{"study", results->study},
             {"name", threshold.name},
             {"from", threshold.from},
             {"of_seed", threshold.at.of_seed},
             {"mean", threshold.at.mean},
             {"standard_deviation", threshold.at.seeds > 1 ? json(threshold.at.standard_deviation) : json()}}
        );
    }
    return list;
}

std::string thresholds_sentence(const std::optional<FinesResults>& results) {
    if (!results || results->thresholds.empty()) {
        return "";
    }
    const auto content = [](const report::Scatter& at) {
        const std::string scatter = at.seeds > 1 ? fmt::format(" ± {:.1f}", 100 * at.standard_deviation) : "";
        return fmt::format("{:.{}f}{} %", 100 * at.mean, at.seeds > 1 ? 1 : 0, scatter) + report::seeds_that_have(at);
    };
    const auto lies = [&](const report::ContentThreshold& lowest) {
        return lowest.at.seeds > 0 ? "lies at FC = " + content(lowest.at) : "cannot be placed by these fines contents";
    };
    const auto begins = [&](const report::ContentThreshold& onset) {
        return onset.at.seeds > 0 ? "begin to rise at " + content(onset.at) : "show no onset";
    };
    const auto& list = results->thresholds;
    std::string text = fmt::format(
        "Through {} fines contents, by a parabola at its lowest points, the least void ratio of the loose state {}",
        results->loose.points.size(), lies(list.front())
    );
    if (!results->dense.points.empty()) {
        text += fmt::format(", that of the dense one {}", lies(list.at(list.size() - 3)));
    }
    return text + fmt::format(
                      "; active fines {}, strong contacts between coarse and fine grains {}.",
                      begins(list.at(list.size() - 2)), begins(list.back())
                  );
}

std::optional<report::PageTable> thresholds_table(const std::optional<FinesResults>& results) {
    if (!results || results->thresholds.empty()) {
        return std::nullopt;
    }
    report::PageTable table;
    table.section = "Fines and structure";
    table.title = "Thresholds of the fines content";
    table.note =
        "FC_threshold: vertex of the parabola through the lowest point of the curve and its neighbors. FC_active: "
        "break of two straight lines through the rising part of the curve; none where a quarter of the rise is made "
        "before it, or where the curve has too few points to one side, or too far ones, to tell its place. Deviations "
        "are those of the seeds; how far the points of the sweep lie apart comes on top.";
    table.header = {"threshold", "read from", "fines content [%]", "deviation [%]", "seeds"};
    table.numeric = {false, false, true, true, true};
    for (const report::ContentThreshold& threshold : results->thresholds) {
        const report::Scatter& at = threshold.at;
        table.rows.push_back(
            {threshold.name, threshold.from, at.seeds > 0 ? fmt::format("{:.1f}", 100 * at.mean) : "none",
             at.seeds > 1 ? fmt::format("{:.1f}", 100 * at.standard_deviation) : "", fmt::format("{}", at.seeds)}
        );
    }
    return table;
}

} // namespace suffuse::run
