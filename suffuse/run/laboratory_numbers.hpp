#pragma once
// What stage.json has of the laboratory tests that are no plain compression.

#include "suffuse/triaxial/run_path.hpp"

#include <nlohmann/json.hpp>

#include <vector>

namespace suffuse::run {

/// Of an oedometer, of isotropic compression, of simple shear or of cycles: numbers and rows; empty for other tests.
nlohmann::json laboratory_numbers(const triaxial::TriaxialSpec& spec, const std::vector<triaxial::PathRow>& curve);

} // namespace suffuse::run
