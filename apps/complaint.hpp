#pragma once
// An error that nothing below can answer for: its words and its exit code.

#include "apps/console.hpp"

namespace suffuse::apps {

/// Prints the exception in flight. @return the exit code that it has
int complain_about_current(const Console& console);

} // namespace suffuse::apps
