#pragma once
// What stages whose fines have weight record: mobility.csv, and the gradient of each grain.

#include "suffuse/erosion/mobility_result.hpp"
#include "suffuse/run/stage_work.hpp"

#include <filesystem>
#include <span>
#include <vector>

namespace suffuse::run {

/// "with weight", "weightless": in stage.json of every stage that probes fines.
const char* model_name(bool weighs);

/// mobility.csv: a row a step of the ramp. Several ramps are distinguished by a column `pass`.
void write_mobility(const std::filesystem::path& folder, std::span<const erosion::MobilityResult* const> ramps);

/// The gradient at which each grain of the world was mobile; not a number for those that were not, or are no fines.
std::vector<double> mobile_gradients(const dem::World& world, const erosion::MobilityResult& mobility);

/// Says what the user must know to read it. @param when empty, or "pass 2: "
void note_mobility(StageWork& work, const std::string& when, const erosion::MobilityResult& mobility);

} // namespace suffuse::run
