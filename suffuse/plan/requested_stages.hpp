#pragma once
// --until and --sample: which stages of a case are asked for.

#include "suffuse/plan/plan.hpp"

#include <string>

namespace suffuse::plan {

/// @throws UsageError where the case has no stage of the name; an empty one asks for all.
void check_until(const casefile::Case& what, const std::string& until);

/// Prices at nothing what comes after the stage asked for as the last, samples without it, and other samples than
/// `only`. Empty: all are asked for.
void price_requested_alone(
    RunPlan& plan, const casefile::Case& what, const std::string& until, const std::string& only = {}
);

/// Takes out of the plan what price_requested_alone prices at nothing.
void keep_requested_alone(
    RunPlan& plan, const casefile::Case& what, const std::string& until, const std::string& only = {}
);

} // namespace suffuse::plan
