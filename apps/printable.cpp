#include "apps/printable.hpp"

#include "suffuse/base/read_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace suffuse::apps {
namespace {

/// Of one character of UTF-8, as character_size measures it.
char32_t code_of(std::string_view character) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(character[k]); };
    char32_t code = character.size() == 1 ? byte(0) : byte(0) & (0x7FU >> character.size());
    for (std::size_t k = 1; k < character.size(); ++k) {
        code = code << 6U | (byte(k) & 0x3FU);
    }
    return code;
}

bool is_shown_escaped(char32_t code) {
    const bool is_control = (code < 0x20 && code != '\n' && code != '\t') || (code >= 0x7F && code < 0xA0);
    const bool turns_direction = code == 0x61C || code == 0x200E || code == 0x200F ||
                                 (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
    return is_control || turns_direction;
}

/// Bytes of a color at the beginning of the text, as in "\x1b[1;31m"; 0 where there is none.
std::size_t size_of_color(std::string_view text) {
    constexpr std::string_view start = "\x1b[";
    if (!text.starts_with(start)) {
        return 0;
    }
    const std::size_t end = text.find_first_not_of("0123456789;", start.size());
    return end != std::string_view::npos && text[end] == 'm' ? end + 1 : 0;
}

} // namespace

std::string printable(std::string_view text, bool colored) {
    std::string shown;
    for (std::size_t at = 0; at < text.size();) {
        if (const std::size_t color = colored ? size_of_color(text.substr(at)) : 0; color > 0) {
            shown += text.substr(at, color);
            at += color;
            continue;
        }
        const std::size_t size = character_size(text, at); // 0: no UTF-8, as names of files may be
        const std::string_view character = text.substr(at, std::max<std::size_t>(1, size));
        const char32_t code = size == 0 ? U'?' : code_of(character);
        shown += is_shown_escaped(code) ? fmt::format("\\u{{{:x}}}", static_cast<std::uint32_t>(code))
                                        : std::string(character);
        at += character.size();
    }
    return shown;
}

} // namespace suffuse::apps
