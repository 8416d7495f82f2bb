#pragma once
// What a run says at its end: how it went, where the report is, what the paper's findings came to, how far off the plan
// was, how to go on.

#include "suffuse/job/run_case.hpp"

#include "apps/console.hpp"
#include <filesystem>
#include <string>

namespace suffuse::apps {

struct EndedRun {
    std::filesystem::path folder;
    std::string sample;         ///< that was run alone; empty: all
    std::ptrdiff_t samples = 0; ///< of the case
    double seconds = 0;         ///< wall time [s]
    bool was_done = false;      ///< before it was called: nothing was left to compute
};

/// Report, warnings, flaws and findings, after a headline.
void print_results(const job::RunReport& report, const std::string& headline, const Console& console);

int exit_code_of(const job::RunReport& report);

/// All of it. @return the exit code
int report_end(const EndedRun& ended, const job::RunReport& report, const Console& console);

} // namespace suffuse::apps
