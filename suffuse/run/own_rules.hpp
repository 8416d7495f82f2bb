#pragma once
// Runs with detachment rules of the caller's own: which stages were requested with one is kept next to the run, so that
// no stage is ever taken for, or gone on with as, one of another rule.

#include "suffuse/casefile/case.hpp"
#include "suffuse/run/run_options.hpp"

namespace suffuse::run {

/// What results contain of a rule: `name` and `source`, null where that is not known. Rules that are alike in both
/// count as one.
nlohmann::json own_rule_numbers(const erosion::OwnRule& rule);

/// Keeps the rules of this call in own_rules.json next to those of earlier ones.
/// @throws UsageError for a rule of no stage that does "erode", for a stage that lacks the rule that it was requested
/// with, and for a finished one that had another, or none. Nothing is changed then.
void take_own_rules(const casefile::Case& what, const RunOptions& options);

} // namespace suffuse::run
