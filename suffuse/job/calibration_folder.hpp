#pragma once
// The folder of a calibration: a copy of its case, and its rounds, each the folder of a run.

#include "suffuse/job/calibrate.hpp"

#include <filesystem>
#include <vector>

namespace suffuse::job {

/// A copy of the case.
inline constexpr const char* calibration_case_file = "calibrate.toml";
/// Its settings with --set, and checksums of the data that it reads: what its answer is of.
inline constexpr const char* calibration_inputs_file = "calibration_inputs.json";

/// Whether a calibration began in this folder.
bool is_calibration(const std::filesystem::path& folder);

/// Those that began, in their order, the held-out tests last: folders of runs.
std::vector<std::filesystem::path> rounds_of(const std::filesystem::path& folder);

/// Copies the case into the folder of its calibration, with what identifies its settings and data. A folder where these
/// are others keeps all its files. @throws UsageError where the case file has changed since the calibration began
/// @throws CaseError where its settings or data have, or where an earlier version did not record them
void keep_calibration_case(
    const std::string& case_file, const casefile::CalibrationCase& what, const std::filesystem::path& folder
);

/// Whether nothing is left to compute: samples that have failed would fail again.
bool is_round_done(const CalibrationRound& round);

} // namespace suffuse::job
