#pragma once
// What stage.json has of a migration, and what the user must know to read it.

#include "suffuse/erosion/migration.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace suffuse::run {

nlohmann::json migration_numbers(const erosion::Migration& migration);

/// Holds that were cut, fines that did not come to rest, contacts that were too soft.
std::vector<std::string> migration_remarks(const erosion::Migration& migration, const erosion::MigrateSpec& spec);

} // namespace suffuse::run
