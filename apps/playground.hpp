#pragma once
// The page of `assess --page`, in which curves and sliders can be moved.

#include "suffuse/job/assessed_soil.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <vector>

namespace suffuse::apps {

/// @param seepage what its sliders begin with, and the way of the water
/// @param about soil_json of each
void write_playground(
    const std::filesystem::path& file, const std::vector<job::AssessedSoil>& soils,
    const std::optional<stability::Seepage>& seepage, const nlohmann::json& about
);

} // namespace suffuse::apps
