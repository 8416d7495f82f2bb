#pragma once
// The figures of how water spreads over the throats, from what the stages of a run found.

#include "suffuse/figures/figure.hpp"
#include "suffuse/study/erosion_story.hpp"
#include "suffuse/study/mobility_story.hpp"

#include <vector>

namespace suffuse::job {

/// Of the erosion that the report shows: before it, after its first and its last pass; and of the first `flow` stages.
std::vector<figures::Figure>
draw_fluxes(const std::vector<record::FinishedStage>& stages, const study::ErosionStory& story);

/// Ours: what becomes of fines that migrate, of the first stages.
std::vector<figures::Figure> draw_migration(const std::vector<record::FinishedStage>& stages);

/// Ours: what gradients move of fines that have weight.
std::vector<figures::Figure> draw_mobility(const std::vector<study::MobilityStory>& stories);

} // namespace suffuse::job
