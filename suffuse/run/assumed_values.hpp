#pragma once
// The values of a case that its author marked with `#~`: choices of our own where the paper gives none.

#include "suffuse/report/page.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace suffuse::run {

/// In the order of the file; keys carry the table that they stand in, and for stages its name:
/// "contact.friction", "study.erosion, stage initial: pressure". What follows the mark is the remark.
/// @param preset in force: what it overrules, and what other presets say, is not listed
std::vector<report::AssumedValue> assumed_values(std::string_view case_text, const std::string& preset);

} // namespace suffuse::run
