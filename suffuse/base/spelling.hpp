#pragma once
// Letters and words: which known word a misspelt one was meant to be.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse {

/// Whatever the locale.
constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Least number of letters inserted, dropped, replaced, or swapped with their neighbor, that turns `a` into `b`
/// (optimal string alignment); capitals count as their small letters.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The first of the known words nearest to `word`, if it is within `limit` edits and keeps at least half of the word;
/// else the only one that begins with it.
std::optional<std::string>
nearest_word(std::string_view word, const std::vector<std::string>& known, std::size_t limit = 2);

/// A word of the user's for a message: without control characters, and not endless.
std::string shown(const std::string& word);

/// ", did you mean ...": empty where nothing is near.
std::string near_hint(const std::string& word, const std::vector<std::string>& known);

} // namespace suffuse
