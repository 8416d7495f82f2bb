#pragma once
// What the report draws from a stage besides its numbers, as results.cbor keeps it.

#include "suffuse/record/finished_stage.hpp"

#include <filesystem>

namespace suffuse::record {

/// Writes results.cbor; nothing where there is nothing to keep.
void save_findings(const std::filesystem::path& folder, const StageFindings& findings);

/// Of the stage in `folder`; nothing where its verb leaves none.
/// @throws IoError where the file is not as a stage leaves it
StageFindings read_findings(const std::filesystem::path& folder);

/// Every finished stage of the run, in the order of the case; they point into `what`.
/// @throws IoError where one does not go on from what the stage before it ended with
std::vector<FinishedStage> read_stages(const casefile::Case& what, const std::filesystem::path& folder);

} // namespace suffuse::record
