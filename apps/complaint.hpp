#pragma once
// An error that nothing below can answer for: its words and its exit code.

#include <nlohmann/json.hpp>

#include "apps/console.hpp"

namespace suffuse::apps {

/// What an error is to programs, and the exit code that it has.
struct ReportedError {
    int code;
    nlohmann::json json; ///< kind, exit_code, message, problems
};

/// Prints the exception in flight in words; its JSON is the caller's.
ReportedError report_current_error(const Console& console);

/// Prints the exception in flight. @return the exit code that it has
int complain_about_current(const Console& console);

} // namespace suffuse::apps
