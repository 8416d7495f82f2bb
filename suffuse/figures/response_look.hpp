#pragma once
// What the figures of triaxial tests have in common: their table, and how their curves look.

#include "suffuse/figures/responses.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace suffuse::figures {

/// The tests that have a curve.
std::vector<study::ResponseCurve> with_rows(std::vector<study::ResponseCurve> tests);

/// @param most rows of a curve, thinned for drawing
Table response_table(const std::vector<study::ResponseCurve>& tests, std::size_t most);

/// Color and dashes by test; tests over a fines content have its color.
void color_by_test(const std::vector<study::ResponseCurve>& tests, nlohmann::json& encoding);

/// For each test the color of its fines content; empty where that is not known.
std::vector<std::string> content_colors(const std::vector<study::ResponseCurve>& tests);

/// Names that stand in one row of a chart of the usual width.
int legend_columns(const nlohmann::json& names);

/// Whether no test has a deviator stress below zero, but for a hundredth of the highest.
bool starts_at_zero(const std::vector<study::ResponseCurve>& tests);

} // namespace suffuse::figures
