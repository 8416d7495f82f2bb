#pragma once
// Text on a terminal: how wide it is, and how long lines are broken.

#include <cstddef>
#include <string>
#include <string_view>

namespace suffuse::apps {

/// Columns that a UTF-8 text takes on a terminal, colors and wide characters apart.
std::size_t columns_of(std::string_view text);

/// The beginning of `text` that fits into `columns`.
std::string clipped(std::string_view text, std::size_t columns);

/// The text with lines of at most `columns`, broken between words; what follows a break stands below the line's last
/// column. Quoted source and commands keep their lines, and so does a word that is longer than one.
std::string folded(std::string_view text, std::size_t columns);

} // namespace suffuse::apps
