#pragma once
// What stages with water write in stage.json.

#include "suffuse/erosion/loop.hpp"
#include "suffuse/erosion/mobility_result.hpp"

#include <nlohmann/json.hpp>

namespace suffuse::run {

/// Of a stage, or a pass, whose fines have weight.
nlohmann::json mobility_numbers(const erosion::MobilityResult& mobility);

/// A pass of an erosion, in `passes`.
nlohmann::json pass_numbers(const erosion::PassResult& pass);

} // namespace suffuse::run
