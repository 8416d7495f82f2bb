#pragma once
// Problems on a terminal: no line of a source is shown wider than it is, so that carets stand under what they mean.

#include "suffuse/base/diagnostics.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace suffuse {

/// As render(), for a terminal of so many columns.
std::string render_within(const std::vector<Diagnostic>& list, bool color, std::size_t columns);

} // namespace suffuse
