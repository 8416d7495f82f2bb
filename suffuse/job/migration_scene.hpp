#pragma once
// The scene of fines that migrate: the states that their stage kept on the way, with the forces between grains that are
// free to move, so that arches over throats show.

#include "suffuse/dem/world.hpp"
#include "suffuse/record/finished_stage.hpp"
#include "suffuse/report/scene.hpp"

#include <filesystem>
#include <vector>

namespace suffuse::job {

/// The first migration whose states are there; null where there is none.
const record::FinishedStage*
watched_migration(const std::filesystem::path& folder, const std::vector<record::FinishedStage>& stages);

/// Grains, fates and states, with forces in their true size. @param frames one for each of `migration.frames`
report::Scene scene_of_frames(const std::vector<dem::World>& frames, const erosion::MigrationResult& migration);

/// @pre a stage of watched_migration
report::Scene scene_of_migration(const std::filesystem::path& folder, const record::FinishedStage& stage);

} // namespace suffuse::job
