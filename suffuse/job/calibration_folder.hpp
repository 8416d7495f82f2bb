#pragma once
// The folder of a calibration: a copy of its case, and its rounds, each the folder of a run.

#include "suffuse/job/calibrate.hpp"

#include <filesystem>
#include <vector>

namespace suffuse::job {

/// A copy of the case.
inline constexpr const char* calibration_case_file = "calibrate.toml";

/// Whether a calibration began in this folder.
bool is_calibration(const std::filesystem::path& folder);

/// Those that began, in their order, the held-out tests last: folders of runs.
std::vector<std::filesystem::path> rounds_of(const std::filesystem::path& folder);

/// Copies the case into the folder of its calibration. @throws UsageError where it has changed since that began
void keep_calibration_case(const std::filesystem::path& case_file, const std::filesystem::path& folder);

/// Whether nothing is left to compute: samples that have failed would fail again.
bool is_round_done(const CalibrationRound& round);

} // namespace suffuse::job
