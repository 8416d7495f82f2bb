#include "suffuse/base/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse {

namespace {

/// Words of cases are ASCII; std::tolower asks for the locale at every letter.
constexpr char lowered(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

constexpr bool same_letter(char a, char b) {
    return lowered(a) == lowered(b);
}

/// Without the dashes of a flag.
std::size_t letters_of(std::string_view word) {
    return word.size() - std::min(word.find_first_not_of('-'), word.size());
}

/// The one known word that `word` is the beginning of.
std::optional<std::string> completed(std::string_view word, const std::vector<std::string>& known) {
    constexpr std::size_t least_letters = 3;
    const auto begins = [&](const std::string& candidate) {
        return candidate.size() >= word.size() && std::equal(word.begin(), word.end(), candidate.begin(), same_letter);
    };
    if (letters_of(word) < least_letters || std::ranges::count_if(known, begins) != 1) {
        return std::nullopt;
    }
    return *std::ranges::find_if(known, begins);
}

} // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) {
        row[j] = j;
    }
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before_last.swap(last);
        last.swap(row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = same_letter(a[i - 1], b[j - 1]);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
            const bool swapped = i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) && same_letter(a[i - 2], b[j - 1]);
            if (swapped) {
                row[j] = std::min(row[j], before_last[j - 2] + 1);
            }
        }
    }
    return row[b.size()];
}

std::optional<std::string>
nearest_word(std::string_view word, const std::vector<std::string>& known, std::size_t limit) {
    std::optional<std::string> nearest;
    std::size_t least = limit + 1;
    for (const std::string& candidate : known) {
        const std::size_t length_gap =
            std::max(word.size(), candidate.size()) - std::min(word.size(), candidate.size());
        if (length_gap > limit) {
            continue;
        }
        const std::size_t distance = edit_distance(word, candidate);
        // A word of two letters is two edits from every other word of two letters.
        if (distance < least && 2 * distance <= letters_of(word)) {
            least = distance;
            nearest = candidate;
        }
    }
    return nearest ? nearest : completed(word, known);
}

std::string shown(const std::string& word) {
    constexpr std::size_t most = 200;
    std::string text = word.substr(0, most);
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?'
    );
    return word.size() > most ? text + "..." : text;
}

std::string near_hint(const std::string& word, const std::vector<std::string>& known) {
    const auto nearest = nearest_word(word, known);
    return nearest ? fmt::format("; a similar one exists: {}", *nearest) : "";
}

} // namespace suffuse
