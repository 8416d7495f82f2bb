#pragma once
// What the report draws from a stage beside its numbers, as results.cbor keeps it.

#include "suffuse/run/stage_work.hpp"

#include <filesystem>

namespace suffuse::run {

/// Of the stage in `folder`; nothing where its verb leaves none.
/// @throws IoError where the file is not as a stage leaves it
StageFindings read_findings(const std::filesystem::path& folder);

} // namespace suffuse::run
