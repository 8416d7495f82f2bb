#pragma once
// What stages that take grains out, with water or without, record of a pass.

#include "suffuse/erosion/loop.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <map>

namespace suffuse::run {

/// Number of contacts -> number of removed grains that had so many.
nlohmann::json histogram_of(const std::map<int, std::int64_t>& coordination);

/// The row of a pass that every such stage has in `passes` of its stage.json.
nlohmann::json pass_record(const erosion::PassResult& pass);

/// eroded.csv: a row a removed grain. @throws IoError where it cannot be written.
void write_eroded(const std::filesystem::path& folder, const erosion::ErosionResult& result);

} // namespace suffuse::run
