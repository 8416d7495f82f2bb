#pragma once
// Measured points that a case lays over its figures: a CSV file whose header names the figure's own columns.

#include "suffuse/figures/figure_options.hpp"

#include <filesystem>

namespace suffuse::job {

/// Columns "name [unit]"; empty fields are missing values; a column `series` holds words.
/// @throws IoError where the file cannot be read, CaseError with the place of what is no number.
figures::Points read_points(const std::filesystem::path& path);

} // namespace suffuse::job
