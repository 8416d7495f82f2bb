#pragma once
// What the cases of own soils have in common.

#include "suffuse/casefile/wide_checks.hpp"

#include "apps/own_soil.hpp"
#include <optional>
#include <string>
#include <string_view>

namespace suffuse::apps {

/// [grain], [contact] and [fluid]: contacts stiff enough for grains of this ratio of sizes under a pressure [Pa].
/// @param largest_overlap of the finest grains between the coarsest, over their radius
std::string
material_text(double largest_over_finest, double pressure, double largest_overlap = casefile::good_squeezed);

extern const std::string_view gravity_text;

/// "\"z\"                       # upward", as wide as the values around it.
std::string direction_text(const std::optional<FlowWay>& flow);

/// "# as specified:", "#~ yours:".
std::string_view site_mark(const std::optional<double>& given);

/// The key `sizes` of a soil; nothing where nothing is left out.
std::string sizes_line(const grains::Grading& modeled, const std::string& left_out);

} // namespace suffuse::apps
