#pragma once
// The samples of a case, as many side by side as there are threads, each stage's numbers and state on disk as soon as
// it is done. A sample that fails is kept as failed and does not stop the others.

#include "suffuse/casefile/case.hpp"
#include "suffuse/run/overview.hpp"
#include "suffuse/run/run_options.hpp"

namespace suffuse::run {

/// Runs the samples that are requested, and those that `refine` adds to them. Stages that the folder already holds are
/// taken as they are. Results do not depend on how many run side by side.
/// @return false where it was stopped, or its time is over
bool run_samples(const casefile::Case& what, const RunOptions& options, Overview& overview);

} // namespace suffuse::run
