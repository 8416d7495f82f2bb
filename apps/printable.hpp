#pragma once
// Text for a terminal that may hold words of others: names of files, sheets and runs.

#include <string>
#include <string_view>

namespace suffuse::apps {

/// The text with control characters, and those that turn the direction of writing, shown as \u{202e}. Ends of lines and
/// tabs stay, and colors where they are `colored`.
std::string printable(std::string_view text, bool colored);

} // namespace suffuse::apps
