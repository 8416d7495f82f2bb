#pragma once
// A run that has ended needs nothing, as long as every file is as it was then: it is left alone.

#include "suffuse/casefile/case.hpp"
#include "suffuse/job/run_case.hpp"

#include <optional>

namespace suffuse::job {

/// What the run reported when it ended, where its folder holds all that is requested, and its stages are known to be
/// whole (finished_stages.hpp). Nothing where something is missing, changed, or still to be computed.
std::optional<RunReport> find_ended(const casefile::Case& what, const run::RunOptions& options);

} // namespace suffuse::job
