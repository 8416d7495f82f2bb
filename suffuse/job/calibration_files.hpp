#pragma once
// What a calibration leaves: calibration.json, posterior.csv, and contact.toml, the block for a case.

#include "suffuse/job/calibrate.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace suffuse::job {

/// The answer, and all that its report needs but the posterior.
inline constexpr const char* calibration_file = "calibration.json";
inline constexpr const char* posterior_file = "posterior.csv";

/// Keys and units: docs/formats.md.
nlohmann::json calibration_json(const casefile::CalibrationCase& what, const CalibrationResult& result);

/// A row a sample of the posterior, a column an unknown, in SI.
std::string posterior_csv(const CalibrationResult& result);

/// [contact] with the likeliest values, and where they come from.
std::string contact_block(const casefile::CalibrationCase& what, const CalibrationResult& result);

/// In the unit that the range was written in, with four digits.
std::string shown_value(const casefile::CalibrateUnknown& unknown, double value);

/// Of the values of one part of a target: root mean square of model - laboratory, over the largest value of the
/// laboratory.
double relative_misfit(const TargetFit& fit, std::size_t part);

void write_calibration(
    const std::filesystem::path& folder, const casefile::CalibrationCase& what, const CalibrationResult& result
);

/// "volumetric strain of the same tests": what would narrow an interval. Empty for none.
std::string_view words_of(Remedy remedy);

} // namespace suffuse::job
