#pragma once
// Erosion stages that follow each other as one erosion: passes count on, masses and strains are of the first
// state.

#include "suffuse/erosion/result.hpp"

#include <vector>

namespace suffuse::study {

/// None is null; the strain between two stages, of an unloading say, is part of the path.
erosion::ErosionResult join_passes(const std::vector<const erosion::ErosionResult*>& stages);

} // namespace suffuse::study
