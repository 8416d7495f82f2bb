#pragma once
// Whether what a plan needs fits into a bound of memory, and how many samples may then run side by side.

#include "suffuse/plan/plan.hpp"

#include <functional>

namespace suffuse::plan {

/// Share of the machine's memory that a run may use unless specified otherwise: the rest is the system's and the
/// user's.
inline constexpr double usual_memory_share = 0.8;

/// How many samples of the plan run side by side within `bytes`: at most as many as were planned.
/// @throws IoError where not even one does, with what needs how much and what to do.
int samples_within(const RunPlan& plan, double bytes);

/// The plan that `make` makes for `at_once` samples side by side, or for fewer where these do not fit. @throws as above
RunPlan plan_within(double bytes, int at_once, const std::function<RunPlan(int)>& make);

} // namespace suffuse::plan
