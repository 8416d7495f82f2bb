#pragma once
// The criteria of internal stability and the rules for filters, one row each: id, name, what is measured, limit,
// source, and what it measures, in words. The criteria themselves, `suffuse explain CRITERION` and the page of `assess
// --page` take them from here.

#include "suffuse/stability/criterion.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::stability {

/// A criterion as it is defined, without a soil: id, name, measure, sense, fixed limit, source, whether it is verified.
/// @throws Bug where there is no row of this id.
Criterion define(std::string_view id);

/// One screen on a criterion by its id, "kenney-lau-1986"; on each that a word of ids means, "kezdi", "kenney-lau", or
/// that reads the specified number, "alpha", "h/f"; nothing where there is none.
std::optional<std::string> explain_criterion(std::string_view word);

/// Ids of all criteria of internal stability, in the order of the assessment, those of gradients last.
std::vector<std::string> criterion_ids();

} // namespace suffuse::stability
