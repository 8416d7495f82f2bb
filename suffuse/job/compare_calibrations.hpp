#pragma once
// Two calibrations side by side: their cases, parameters, intervals and misfits.

#include "suffuse/record/compare_runs.hpp"

#include <filesystem>

namespace suffuse::job {

/// Parameters in the unit of the first one's case. Intervals that do not overlap are among the circumstances.
/// @param tolerance relative, below which two numbers count as the same [-]
/// @throws IoError where a folder holds no answer
record::Comparison
compare_calibrations(const std::filesystem::path& first, const std::filesystem::path& second, double tolerance);

} // namespace suffuse::job
