#include "suffuse/base/readable.hpp"

#include <algorithm>

namespace suffuse {
namespace {

constexpr std::size_t most_quoted = 200, most_of_line = 2000; // [bytes]

bool starts_character(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
}

/// The beginning and the end of a long text: of a path, the end says most.
std::string cut(std::string_view text, std::size_t most) {
    if (text.size() <= most) {
        return std::string(text);
    }
    std::size_t kept = most * 3 / 4, rest = text.size() - most / 4;
    while (kept > 0 && !starts_character(text[kept])) {
        --kept;
    }
    while (rest < text.size() && !starts_character(text[rest])) {
        ++rest;
    }
    return std::string(text.substr(0, kept)).append("…").append(text.substr(rest));
}

/// A mark within a quotation stands next to more of it, or behind a backslash.
bool closes(std::string_view line, std::size_t mark) {
    const char next = mark + 1 < line.size() ? line[mark + 1] : ' ';
    const bool is_within = (next >= '0' && next <= '9') || (next >= 'A' && next <= 'Z') || (next >= 'a' && next <= 'z');
    return !is_within && line[mark - 1] != '\\';
}

/// Behind the text that begins here: a quotation to its mark, a word to the next blank or mark.
std::size_t end_of_part(std::string_view line, std::size_t begin) {
    if (line[begin] != '"') {
        return std::min(line.find_first_of(" \"", begin + 1), line.size());
    }
    std::size_t end = begin;
    do {
        end = line.find('"', end + 1);
    } while (end != std::string_view::npos && !closes(line, end));
    return end == std::string_view::npos ? line.size() : end + 1;
}

std::string readable_line(std::string_view line) {
    std::string shorter;
    for (std::size_t at = 0; at < line.size();) {
        const std::size_t end = end_of_part(line, at);
        shorter += cut(line.substr(at, end - at), most_quoted);
        at = end;
    }
    return cut(shorter, most_of_line);
}

} // namespace

std::string readable(std::string_view message) {
    std::string shorter;
    for (;;) {
        const std::size_t end = std::min(message.find('\n'), message.size());
        shorter += readable_line(message.substr(0, end));
        if (end == message.size()) {
            return shorter;
        }
        shorter += '\n';
        message.remove_prefix(end + 1);
    }
}

} // namespace suffuse
