#pragma once
// Many soils side by side: a row for each, a column for each criterion, and which is the worst.

#include "suffuse/job/assessed_soil.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace suffuse::job {

/// The soil that most of the counted criteria call unstable; of several such the one with the least (H/F)min.
std::size_t find_worst(const std::vector<AssessedSoil>& soils);

/// A line for each soil with verdict and number of each counted criterion and critical gradient, then the worst by name
/// and what the letters stand for, what the filter does to each, and what the gradients are of.
std::string
matrix_text(const std::vector<AssessedSoil>& soils, const std::optional<stability::Seepage>& seepage = std::nullopt);

/// The same for programs: names, verdicts, numbers, the worst soil of all and of each criterion.
nlohmann::json matrix_json(const std::vector<AssessedSoil>& soils);

} // namespace suffuse::job
