#pragma once
// From the states that a run left on disk to the scene of its report: before and after each erosion pass, or, without
// an erosion, the stages that lead to the last one.

#include "suffuse/report/scene.hpp"
#include "suffuse/run/finished_stage.hpp"

#include <filesystem>
#include <vector>

namespace suffuse::run {

/// A scene without states where there is nothing to show. `eroded` is the stage whose passes are shown, or null.
report::Scene describe_scene(
    const std::filesystem::path& folder, const std::vector<FinishedStage>& stages, const FinishedStage* eroded
);

/// Where an `erode` stage leaves the state after a pass that is not its last.
std::filesystem::path pass_file(const std::filesystem::path& stage_folder, int pass);

} // namespace suffuse::run
