#pragma once
// What stages with water tell in numbers: the objects of their stage.json.

#include "suffuse/erosion/loop.hpp"
#include "suffuse/flow/known_error.hpp"

#include <nlohmann/json.hpp>

namespace suffuse::run {

nlohmann::json probe_numbers(const erosion::ProbeResult& probe);

/// Which flow a number is of, and what is known of it.
nlohmann::json source_numbers(const flow::FlowSource& source);

/// The row of a pass of an erosion, in `passes`.
nlohmann::json pass_numbers(const erosion::PassResult& pass);

} // namespace suffuse::run
