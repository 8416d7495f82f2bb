#include "apps/wording.hpp"

#include <algorithm>

namespace suffuse::apps {
namespace {

constexpr char escape = '\x1b'; ///< begins what sets a color; it takes no column

/// Where the next character begins after that at `at`: past the rest of its UTF-8, or of a color's sequence.
std::size_t after_character(std::string_view text, std::size_t at) {
    if (text[at] == escape) {
        return std::min(text.find('m', at), text.size() - 1) + 1;
    }
    do {
        ++at;
    } while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U);
    return at;
}

/// How a long line goes on: below its last column, or, where that stands far to the right, with the whole column below.
struct Hanging {
    std::size_t indent;          ///< of the lines that follow [columns]
    std::size_t first_break = 0; ///< where the line is broken first [bytes]; 0: where it is full
};

Hanging hang(std::string_view line, std::size_t columns) {
    const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
    constexpr std::string_view help = "= help: ";
    const std::size_t below = line.substr(begin).starts_with(help) ? begin + help.size() : begin > 0 ? begin : 4;
    const std::size_t gap = line.rfind("  ");
    if (gap == std::string_view::npos || gap < begin) {
        return {below};
    }
    const std::size_t before = columns_of(line.substr(0, gap + 2));
    return before <= columns / 2 ? Hanging{before} : Hanging{below, before <= columns ? gap + 1 : 0};
}

/// Quoted source with its caret, and commands to be copied, keep their line whatever the terminal does with it.
bool is_kept_whole(std::string_view line) {
    constexpr std::size_t place_of_bar = 8;
    const bool is_command = line.starts_with("suffuse ") && line.find(": ") == std::string_view::npos;
    return is_command || line.substr(0, place_of_bar).find('|') != std::string_view::npos;
}

std::string folded_line(std::string_view line, std::size_t columns) {
    if (columns_of(line) <= columns || is_kept_whole(line)) {
        return std::string(line);
    }
    const auto [indent, first_break] = hang(line, columns);
    std::string text, rest(line);
    while (columns_of(rest) > columns) {
        const std::size_t first_word = rest.find(' ', rest.find_first_not_of(' '));
        const std::size_t full = clipped(rest, columns).size();
        const std::size_t blank = rest.rfind(' ', text.empty() && first_break > 0 ? first_break : full);
        if (blank == std::string::npos || blank < first_word) {
            break; // a word longer than a line
        }
        text += rest.substr(0, rest.find_last_not_of(' ', blank) + 1) + "\n";
        const std::size_t next = rest.find_first_not_of(' ', blank);
        rest.replace(0, std::min(next, rest.size()), indent, ' ');
    }
    return text + rest;
}

} // namespace

std::size_t columns_of(std::string_view text) {
    std::size_t columns = 0;
    for (std::size_t at = 0; at < text.size(); at = after_character(text, at)) {
        columns += text[at] == escape ? 0 : 1;
    }
    return columns;
}

std::string clipped(std::string_view text, std::size_t columns) {
    std::size_t taken = 0, at = 0;
    for (; at < text.size(); at = after_character(text, at)) {
        if (text[at] != escape && taken++ == columns) {
            break;
        }
    }
    return std::string(text.substr(0, at));
}

std::string folded(std::string_view text, std::size_t columns) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        out += folded_line(text.substr(at, end - at), columns);
        out += end < text.size() ? "\n" : "";
        at = end + 1;
    }
    return out;
}

} // namespace suffuse::apps
