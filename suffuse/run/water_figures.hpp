#pragma once
// The figures of how water spreads over the throats, from what the stages of a run found.

#include "suffuse/report/figure.hpp"
#include "suffuse/run/erosion_story.hpp"

#include <vector>

namespace suffuse::run {

/// Of the erosion that the report tells: before it, after its first and its last pass; and of the first `flow` stages.
std::vector<report::Figure> draw_fluxes(const std::vector<FinishedStage>& stages, const ErosionStory& story);

} // namespace suffuse::run
