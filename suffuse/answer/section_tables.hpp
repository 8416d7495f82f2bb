#pragma once
// The tables at the head of the report's sections on removal and on water.

#include "suffuse/figures/page_table.hpp"
#include "suffuse/flow/fluid.hpp"
#include "suffuse/study/erosion_story.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace suffuse::answer {

/// Permeability of every state whose flow was solved, and conductivity for the fluid, next to Kozeny and Carman's for
/// spheres of the sample's Sauter diameter, k = n^3 d^2/(180 (1 - n)^2) [Carman 1937]; nothing where there was no flow.
std::optional<figures::PageTable> tabulate_water(
    const std::filesystem::path& folder, const std::vector<record::FinishedStage>& stages,
    const study::ErosionStory& story, const flow::Fluid& fluid
);

/// Fines taken out without water in part or in passes, a row a pass, or a row a stage where these are many; nothing
/// without such a stage. What takes all fines at once is in report::removal_table.
std::optional<figures::PageTable> tabulate_removals(const std::vector<record::FinishedStage>& stages);

/// k by Kozeny and Carman [m2] of spheres with these radii [m] at a porosity [-].
double kozeny_carman(const std::vector<double>& radius, double porosity);

} // namespace suffuse::answer
