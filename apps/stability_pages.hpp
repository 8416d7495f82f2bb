#pragma once
// The pages of `assess -o`: one for each soil, and one that lays the curves of all over each other.

#include "suffuse/job/assessed_soil.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::apps {

/// A page, its figures and the numbers of `about` in a folder. @return the page.
std::filesystem::path write_soil_page(
    const job::AssessedSoil& soil, const stability::AssessSpec& spec, const nlohmann::json& about,
    const std::filesystem::path& folder, const std::string& command
);

/// The same for all soils together: their curves over each other, their verdicts side by side.
std::filesystem::path write_overlay_page(
    const std::vector<job::AssessedSoil>& soils, const nlohmann::json& matrix, const std::filesystem::path& folder,
    const std::string& command
);

/// The curves alone, of one soil or of all over each other, as the file's ending says: .pdf, .svg or .png.
/// @throws IoError saying what to install
void draw_curves(const std::vector<job::AssessedSoil>& soils, const std::filesystem::path& file);

} // namespace suffuse::apps
