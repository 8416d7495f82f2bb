#pragma once
// Text for a terminal that may hold words of others: names of files, sheets and runs.

#include <cstddef>
#include <string>
#include <string_view>

namespace suffuse::apps {

/// The text with control characters, and those that turn the direction of writing, shown as \u{202e}. Ends of lines and
/// tabs stay, and colors where they are `colored`.
std::string printable(std::string_view text, bool colored);

/// The text with lines of at most `most` bytes; what is left out of each is counted at its end.
std::string with_short_lines(std::string_view text, std::size_t most);

} // namespace suffuse::apps
