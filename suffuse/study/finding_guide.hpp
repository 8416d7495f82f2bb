#pragma once
// What decides each finding, whatever the run: the short explanation next to the report's table, and of `explain E4`.

#include <string_view>

namespace suffuse::study {

/// A few sentences; empty for an id that is none.
std::string_view background_of(std::string_view id);

} // namespace suffuse::study
