#pragma once
// --until and --sample: which stages of a case are requested.

#include "suffuse/plan/plan.hpp"

#include <string>

namespace suffuse::plan {

/// @throws UsageError where the case has no stage of the name; an empty one requests all.
void check_until(const casefile::Case& what, const std::string& until);

/// Prices at nothing what comes after the requested last stage, samples without it, and other samples than
/// `only`. Empty: all are requested.
void price_requested_alone(
    RunPlan& plan, const casefile::Case& what, const std::string& until, const std::string& only = {}
);

/// Takes out of the plan what price_requested_alone prices at nothing.
void keep_requested_alone(
    RunPlan& plan, const casefile::Case& what, const std::string& until, const std::string& only = {}
);

} // namespace suffuse::plan
