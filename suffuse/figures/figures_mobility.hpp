#pragma once
// Figures of fines that have weight: how many of them a gradient moves, and which sizes. Tables and axes are in mm and
// %.

#include "suffuse/figures/figure.hpp"
#include "suffuse/figures/page_table.hpp"
#include "suffuse/study/mobility_story.hpp"

#include <optional>
#include <vector>

namespace suffuse::figures {

/// Share of the fines' mass that moves, and that leaves, against the gradient; what other answers say as vertical
/// lines.
std::optional<Figure> mobility_curves(const std::vector<study::MobilityStory>& stories);

/// By size, the gradient that first moves the grains of each class.
std::optional<Figure> mobile_sizes(const study::MobilityStory* story);

/// A row a soil and flow.
std::optional<PageTable> mobility_table(const std::vector<study::MobilityStory>& stories);

} // namespace suffuse::figures
