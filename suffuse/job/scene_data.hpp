#pragma once
// From the states that a run left on disk to the scene of its report: before and after each erosion pass, or, without
// an erosion, the stages that lead to the last one.

#include "suffuse/record/finished_stage.hpp"
#include "suffuse/report/scene.hpp"

#include <filesystem>
#include <vector>

namespace suffuse::job {

/// A scene without states where there is nothing to show. `eroded` is the stage whose passes are shown, or null.
report::Scene describe_scene(
    const std::filesystem::path& folder, const std::vector<record::FinishedStage>& stages,
    const record::FinishedStage* eroded
);

} // namespace suffuse::job
