#pragma once
// The report of a calibration, from the files in its folder: nothing is computed.

#include <filesystem>
#include <string>

namespace suffuse::job {

/// Writes figures/ and report.html into the folder. @param page_folder where page/build.sh left the page's script
/// @return the report. @throws IoError where the folder holds no answer, or a file is damaged
std::filesystem::path
write_calibration_report(const std::filesystem::path& folder, const std::filesystem::path& page_folder);

} // namespace suffuse::job
