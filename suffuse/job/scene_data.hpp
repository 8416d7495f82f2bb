#pragma once
// From the states that a run left on disk to the scene of its report: before and after each erosion pass, or, without
// an erosion, the stages that lead to the last one.

#include "suffuse/dem/world.hpp"
#include "suffuse/record/finished_stage.hpp"
#include "suffuse/report/scene.hpp"
#include "suffuse/study/erosion_story.hpp"

#include <filesystem>
#include <vector>

namespace suffuse::job {

/// A scene without states where there is nothing to show. Of a story with an erosion its passes are shown.
report::Scene describe_scene(
    const std::filesystem::path& folder, const std::vector<record::FinishedStage>& stages,
    const study::ErosionStory& story
);

/// One state by itself.
report::Scene scene_of_world(const dem::World& world, const std::string& label);

} // namespace suffuse::job
