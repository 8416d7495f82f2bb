#pragma once
// Whether a calibration is what it was when it ended: its own files by SHA256SUMS in its folder, each round as the run
// that it is.

#include "suffuse/record/checksums.hpp"

#include <filesystem>

namespace suffuse::job {

/// Signs the answer, its report and the checksums of the rounds. @throws IoError
void write_calibration_sums(const std::filesystem::path& folder);

/// Samples that failed lack stages, and count as whole: they are data. Files are named from the calibration's folder.
/// @throws IoError where the calibration has not ended, or the checksums cannot be read
record::Verification verify_calibration(const std::filesystem::path& folder);

} // namespace suffuse::job
