#pragma once
// The unfinished samples of a run as tasks of an engine: tasks.txt, and the scripts that the engine reads.

#include "apps/console.hpp"
#include "apps/options.hpp"
#include "apps/shared_options.hpp"
#include <string>

namespace suffuse::apps {

struct EmitOptions {
    std::string engine; ///< as --emit has it
    std::string output;
    int threads = 0;        ///< of each task
    std::string time_limit; ///< of each task, with its unit
    std::string task_time;  ///< that samples are packed to, with its unit
    std::string partition, account;
    CaseChanges changes;
    CacheOptions cache;

    /// @return --emit
    Option add_to(Options& options, const Option& subject);
    /// @throws UsageError for options that the engine has no use for.
    void check() const;
};

/// @param subject a case, or the folder of a run. @return the exit code
int emit_tasks(const std::string& subject, const EmitOptions& options, const Console& console);

} // namespace suffuse::apps
