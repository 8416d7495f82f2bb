#pragma once
// Samples that failed: which, why, and what to do.

#include "suffuse/job/run_case.hpp"

#include "apps/console.hpp"
#include <filesystem>
#include <vector>

namespace suffuse::apps {

/// The exit code of the failures where all are of one kind, and of a failure while running otherwise.
int code_of(const std::vector<record::FailedSample>& failures);

/// @param samples of the whole run
void print_failures(
    const std::vector<record::FailedSample>& failures, std::int64_t samples, const std::filesystem::path& folder,
    const Console& console
);

} // namespace suffuse::apps
