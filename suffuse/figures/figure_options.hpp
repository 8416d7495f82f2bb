#pragma once
// Options of a case for its figures: which to show, which way dilation is drawn, measured points laid over them.

#include "suffuse/figures/figure.hpp"

#include <string>
#include <vector>

namespace suffuse::figures {

/// "figure-9" and "9" are "fig09"; other words stay as they are.
std::string figure_id(const std::string& word);

/// Whether `words` select the figure: "paper" for all of the paper's, "own" for ours, or one by its name.
bool is_requested(const std::vector<std::string>& words, const Figure& figure);

/// Turns the axes of volumetric strain over, so that dilation points upward. Numbers and their sign stay.
void draw_dilation_up(Figure& figure);

/// Measured points: columns with the names and units of the figure's own table; a column `series` of words, where there
/// is one, distinguishes curves of points; a column `panel` says which panel of several they belong to.
using Points = Table;

/// Lays points over every panel whose two columns they have, as open markers, and names `source` in the caption.
/// @return whether there was such a panel.
bool lay_over(Figure& figure, const Points& points, const std::string& source);

} // namespace suffuse::figures
