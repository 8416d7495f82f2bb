#include "suffuse/gradings/sheet_text.hpp"

#include "suffuse/base/read_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace suffuse::gradings {

namespace {

struct Kind {
    std::string_view begin; ///< the first bytes of such a file
    const char* name;
    const char* advice;
};

constexpr const char* save_as_csv = "open it there and save the sheet as CSV: File, Save As, CSV UTF-8";

constexpr std::array kinds{
    Kind{"PK\x03\x04", "a workbook (.xlsx or .ods) or another packed file", save_as_csv},
    Kind{"\xD0\xCF\x11\xE0", "a workbook of the old kind (.xls)", save_as_csv},
    Kind{"%PDF", "a PDF page", "type its table into a CSV file: a line for each sieve, its size and percent passing"},
};

/// What Windows-1252 has from 0x80 to 0x9F; 0 where it has nothing.
constexpr std::array<unsigned, 32> high_signs{0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                              0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0,      0x017D, 0,
                                              0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                              0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

/// The code point of a byte of Windows-1252; 0 where it has none.
unsigned code_of(unsigned char byte) {
    return byte >= 0x80 && byte < 0xA0 ? high_signs[byte - 0x80U] : byte;
}

void append_utf8(std::string& text, unsigned code) {
    constexpr std::array firsts{0x00U, 0xC0U, 0xE0U, 0xF0U};
    const unsigned more = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x10000 ? 2 : 3; // bytes behind the first
    text += static_cast<char>(firsts[more] | (code >> (6 * more)));
    for (unsigned k = more; k-- > 0;) {
        text += static_cast<char>(0x80U | ((code >> (6 * k)) & 0x3FU));
    }
}

bool is_utf16(std::string_view bytes) {
    return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
}

/// UTF-16 in the order of its mark, as spreadsheets save "Unicode text". Empty where a sign is cut off.
std::optional<std::string> decode_utf16(std::string_view bytes) {
    const std::size_t high = bytes.starts_with("\xFE\xFF") ? 0 : 1; // which byte of a unit
    const auto byte = [&](std::size_t k) { return k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U; };
    const auto unit = [&](std::size_t at) { return (byte(at + high) << 8U) | byte(at + 1 - high); };
    std::string text;
    for (std::size_t at = 2; at < bytes.size(); at += 2) {
        unsigned code = unit(at);
        if (code >= 0xD800 && code < 0xE000) { // the first of a pair
            at += 2;
            const unsigned low = unit(at);
            if (code >= 0xDC00 || low < 0xDC00 || low >= 0xE000) {
                return std::nullopt;
            }
            code = 0x10000U + ((code - 0xD800U) << 10U) + (low - 0xDC00U);
        }
        append_utf8(text, code);
    }
    return bytes.size() % 2 == 0 ? std::optional(text) : std::nullopt;
}

bool is_utf8(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t size = character_size(text, at);
        if (size == 0) {
            return false;
        }
        at += size;
    }
    return true;
}

/// Whether Windows-1252 has a sign for every byte, and none but those of a text: zero bytes are left to the check.
bool may_be_windows(std::string_view text) {
    return std::ranges::all_of(text, [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        const bool is_control = byte < 0x20 && c != '\n' && c != '\r' && c != '\t' && c != '\f' && c != '\v';
        return !is_control && code_of(byte) != 0;
    });
}

/// Old spreadsheets end a line by \r alone.
void unify_line_ends(std::string& text) {
    if (text.find('\r') == std::string::npos) {
        return;
    }
    std::string lines;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const bool is_end = text[k] == '\r';
        lines += is_end ? '\n' : text[k];
        k += is_end && k + 1 < text.size() && text[k + 1] == '\n' ? 1U : 0U;
    }
    text = std::move(lines);
}

} // namespace

std::shared_ptr<const Source> decode_sheet(const std::shared_ptr<const Source>& source, Problems& problems) {
    for (const Kind& kind : kinds) {
        if (source->text.starts_with(kind.begin)) {
            problems.error("E100", {source, 0, 0, 1}, fmt::format("the file is {}", kind.name), kind.advice);
            return nullptr;
        }
    }
    auto decoded = std::make_shared<Source>(*source);
    if (is_utf16(source->text)) {
        const auto text = decode_utf16(source->text);
        if (!text) {
            problems.error("E100", {source, 0, 0, 1}, "the file is UTF-16 text that is cut off", "save it again");
            return nullptr;
        }
        decoded->text = *text;
    } else if (!is_utf8(decoded->text) && may_be_windows(decoded->text)) {
        std::string text;
        for (const char c : decoded->text) {
            append_utf8(text, code_of(static_cast<unsigned char>(c)));
        }
        decoded->text = std::move(text);
        problems.warning(
            "W508", {source, 0, 0, 1}, "read as Windows-1252 because it is not UTF-8 text",
            "save it as UTF-8 if a letter looks wrong"
        );
    }
    unify_line_ends(decoded->text);
    if (!check_encoding(decoded, problems)) {
        return nullptr;
    }
    return decoded;
}

} // namespace suffuse::gradings
