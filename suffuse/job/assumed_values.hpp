#pragma once
// The values of a case that its author marked with `#~`: choices of our own where the paper gives none.

#include "suffuse/report/page.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace suffuse::job {

/// In the order of the file; keys carry the table that they stand in, and for stages its name:
/// "contact.friction", "study.erosion, stage initial: pressure". What follows the mark is the remark.
/// @param preset in force: what it overrules, and what other presets say, is not listed
/// @param overrides "study.erosion.particles=4000", as typed: what they overrule is not listed either
/// @param studies those that were run, others are not listed; empty: all
std::vector<report::AssumedValue> assumed_values(
    std::string_view case_text, const std::string& preset, const std::vector<std::string>& overrides = {},
    const std::vector<std::string>& studies = {}
);

} // namespace suffuse::job
