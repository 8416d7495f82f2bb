#pragma once
// eroded.csv: a row a removed grain.

#include "suffuse/erosion/result.hpp"

#include <filesystem>

namespace suffuse::run {

/// @throws IoError where it cannot be written.
void write_eroded(const std::filesystem::path& folder, const erosion::ErosionResult& result);

} // namespace suffuse::run
