// Alters every sentence where it is made: what is thrown, what is formatted into words, the problems of a case, and why
// an erosion ends. The program that has this file has the objects of the program otherwise; the linker puts these
// functions in between (--wrap, tests/CMakeLists.txt). If it computes, refuses and reads the same, no control flow
// reads a sentence.
//
// Letters become capitals. Names, quotations, fields of a format, and words with digits, slashes and the like stay as
// they are.

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/erosion/ending.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace suffuse::altered {
namespace {

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Which characters are of a quotation, or of a field of a format.
std::vector<bool> find_kept(std::string_view text) {
    std::vector<bool> kept(text.size());
    std::size_t depth = 0;
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (depth == 0 && (text[k] == '"' || text[k] == '`')) {
            const std::size_t end = std::min(text.find(text[k], k + 1), text.size() - 1);
            std::fill(kept.begin() + std::ptrdiff_t(k), kept.begin() + std::ptrdiff_t(end) + 1, end > k);
            k = std::max(k, end);
            continue;
        }
        depth += text[k] == '{' ? 1 : 0;
        kept[k] = depth > 0;
        depth -= text[k] == '}' && depth > 0 ? 1 : 0;
    }
    return kept;
}

/// "Kenney and Lau": of works, which a page lists that names them.
bool is_name(std::string_view text, std::size_t begin, std::size_t end) {
    const auto is_capital = [&](std::size_t at) {
        at = std::min(text.find_first_not_of("('", at), text.size());
        return at < text.size() && text[at] >= 'A' && text[at] <= 'Z';
    };
    return is_capital(begin) || (text.substr(begin, end - begin) == "and" && is_capital(end + 1));
}

std::string in_capitals(std::string_view text) {
    const std::vector<bool> kept = find_kept(text);
    std::string out(text);
    const auto is_blank = [&](std::size_t k) { return !kept[k] && (text[k] == ' ' || text[k] == '\n'); };
    for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end + 1) {
        for (end = begin; end < text.size() && !is_blank(end);) {
            ++end;
        }
        bool is_word = !is_name(text, begin, end); // and no path, number, key or unit
        for (std::size_t k = begin; k < end; ++k) {
            const bool is_inside = k + 1 < end && !kept[k + 1] && is_letter(text[k + 1]);
            const bool is_mark = std::string_view("-'(),;:").find(text[k]) != std::string_view::npos;
            is_word = is_word && (kept[k] || is_letter(text[k]) || is_mark || (text[k] == '.' && !is_inside));
        }
        for (std::size_t k = begin; k < end && is_word; ++k) {
            out[k] = kept[k] ? out[k] : static_cast<char>(std::toupper(static_cast<unsigned char>(out[k])));
        }
    }
    return out;
}

/// Four words in a row, for curves have names of three, and nothing of a page, a table or a case.
bool is_sentence(std::string_view form) {
    if (form.find_first_of("<>#|=\\") != std::string_view::npos || form.starts_with("ITEM: ")) {
        return false;
    }
    int words = 0, letters = 0;
    for (const char c : form) {
        words = is_letter(c) ? words + (letters == 0 ? 1 : 0) : c == ' ' && letters > 0 ? words : 0;
        letters = is_letter(c) ? letters + 1 : 0;
        if (words >= 4) {
            return true;
        }
    }
    return false;
}

} // namespace
} // namespace suffuse::altered

// NOLINTBEGIN: names as the linker has them
using suffuse::altered::in_capitals;
#define STRING "NSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEE"

#define RUNTIME_ERROR "_ZNSt13runtime_errorC2ERK" STRING
void real(std::runtime_error* self, const std::string& what) asm("__real_" RUNTIME_ERROR);
void wrap(std::runtime_error* self, const std::string& what) asm("__wrap_" RUNTIME_ERROR);

void wrap(std::runtime_error* self, const std::string& what) {
    real(self, in_capitals(what));
}

void wrap(std::runtime_error* self, const char* what) asm("__wrap__ZNSt13runtime_errorC2EPKc");

void wrap(std::runtime_error* self, const char* what) {
    real(self, in_capitals(what));
}

#define LOGIC_ERROR "_ZNSt11logic_errorC2ERK" STRING
void real(std::logic_error* self, const std::string& what) asm("__real_" LOGIC_ERROR);
void wrap(std::logic_error* self, const std::string& what) asm("__wrap_" LOGIC_ERROR);

void wrap(std::logic_error* self, const std::string& what) {
    real(self, in_capitals(what));
}

#define VFORMAT                                                                                                        \
    "_ZN3fmt2v97vformatB5cxx11ENS0_17basic_string_viewIcEENS0_17basic_format_argsINS0_20basic_format_contextINS0_"     \
    "8appenderEcEEEE"
std::string real(fmt::string_view form, fmt::format_args values) asm("__real_" VFORMAT);
std::string wrap(fmt::string_view form, fmt::format_args values) asm("__wrap_" VFORMAT);

std::string wrap(fmt::string_view form, fmt::format_args values) {
    const std::string_view text(form.data(), form.size());
    return suffuse::altered::is_sentence(text) ? real(in_capitals(text), values) : real(form, values);
}

#define WORDS_OF_ENDING "_ZN7suffuse5facts8words_ofB5cxx11ERKNS_7erosion6EndingE"
std::string real(const suffuse::erosion::Ending& ending) asm("__real_" WORDS_OF_ENDING);
std::string wrap(const suffuse::erosion::Ending& ending) asm("__wrap_" WORDS_OF_ENDING);

std::string wrap(const suffuse::erosion::Ending& ending) {
    return in_capitals(real(ending));
}

#define PROBLEM(kind) "_ZN7suffuse8Problems" kind "E" STRING "RKNS_5PlaceES6_S6_S6_"
using Words = std::string;
void real_error(suffuse::Problems*, Words, const suffuse::Place&, Words, Words, Words) asm("__real_" PROBLEM("5error"));
void wrap_error(suffuse::Problems*, Words, const suffuse::Place&, Words, Words, Words) asm("__wrap_" PROBLEM("5error"));

void wrap_error(
    suffuse::Problems* self, Words code, const suffuse::Place& place, Words message, Words help, Words label
) {
    real_error(self, std::move(code), place, in_capitals(message), in_capitals(help), in_capitals(label));
}

void real_warning(suffuse::Problems*, Words, const suffuse::Place&, Words, Words, Words) asm(
    "__real_" PROBLEM("7warning")
);
void wrap_warning(suffuse::Problems*, Words, const suffuse::Place&, Words, Words, Words) asm(
    "__wrap_" PROBLEM("7warning")
);

void wrap_warning(
    suffuse::Problems* self, Words code, const suffuse::Place& place, Words message, Words help, Words label
) {
    real_warning(self, std::move(code), place, in_capitals(message), in_capitals(help), in_capitals(label));
}

// NOLINTEND
