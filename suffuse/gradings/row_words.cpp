#include "suffuse/gradings/row_words.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/gradings/heading.hpp"
#include "suffuse/gradings/sheet.hpp"
#include "suffuse/gradings/sieve_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

namespace suffuse::gradings {

namespace {

template <std::size_t N>
bool is_among(const std::array<std::string_view, N>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

struct Prefix {
    std::string_view text;
    SizeSense sense;
};

// A sign stands anywhere before a size, a word of its own is followed by a blank.
constexpr std::array prefixes{
    Prefix{"<=", SizeSense::Finer},
    Prefix{"\u2264", SizeSense::Finer},
    Prefix{"<", SizeSense::Finer},
    Prefix{">=", SizeSense::Coarser},
    Prefix{"\u2265", SizeSense::Coarser},
    Prefix{">", SizeSense::Coarser},
    Prefix{"passing ", SizeSense::Finer},
    Prefix{"pass ", SizeSense::Finer},
    Prefix{"finer than ", SizeSense::Finer},
    Prefix{"less than ", SizeSense::Finer},
    Prefix{"minus ", SizeSense::Finer},
    Prefix{"passant ", SizeSense::Finer},
    Prefix{"pasa ", SizeSense::Finer},
    Prefix{"passante ", SizeSense::Finer},
    Prefix{"retained on ", SizeSense::Coarser},
    Prefix{"coarser than ", SizeSense::Coarser},
    Prefix{"plus ", SizeSense::Coarser},
    Prefix{"-#", SizeSense::Finer},
    Prefix{"+#", SizeSense::Coarser},
};

/// The number that a text begins with, and its length; with what follows as its unit.
struct Bound {
    double number = 0;
    std::string_view digits, unit;
};

std::optional<Bound> read_bound(std::string_view text) {
    text = trimmed(text);
    const std::size_t end = std::min(text.find_first_not_of("0123456789.,"), text.size());
    const auto number = plain_number(text.substr(0, end), true);
    const std::string_view unit = trimmed(text.substr(end));
    if (!number || (!unit.empty() && size_scale_of(unit) == SizeScale::Unknown)) {
        return std::nullopt;
    }
    return Bound{*number, text.substr(0, end), unit};
}

/// Two bounds of one unit: the finer one with it, or what lies below the coarser where the finer is 0.
SizeText finer_of(const Bound& first, const Bound& second) {
    const std::string_view unit = first.unit.empty() ? second.unit : first.unit;
    const Bound &finer = first.number < second.number ? first : second,
                &coarser = first.number < second.number ? second : first;
    const bool is_pan = finer.number == 0;
    return {
        fmt::format("{}{}{}", is_pan ? coarser.digits : finer.digits, unit.empty() ? "" : " ", unit),
        is_pan ? SizeSense::Finer : SizeSense::Class};
}

/// 2 mm - 850 um: the units say which is the finer one.
SizeText finer_by_unit(std::string_view first, std::string_view second) {
    const auto a = read_sieve_size(first, SizeScale::Unknown), b = read_sieve_size(second, SizeScale::Unknown);
    return {std::string(trimmed(a && b && a->diameter < b->diameter ? first : second)), SizeSense::Class};
}

/// "63 - 31.5", "2 to 0.85 mm": the finer bound with its unit.
std::optional<SizeText> split_class(std::string_view text) {
    constexpr std::array<std::string_view, 7> marks{" to ", " bis ", " \u00e0 ", " a ", "\u2013", "\u2014", "-"};
    for (const std::string_view mark : marks) {
        const std::size_t at = text.find(mark);
        if (at == std::string_view::npos || at == 0) {
            continue;
        }
        const std::string_view before = text.substr(0, at), after = text.substr(at + mark.size());
        const auto first = read_bound(before), second = read_bound(after);
        if (!first || !second || first->number == second->number) {
            return std::nullopt;
        }
        const bool have_units = !first->unit.empty() && !second->unit.empty() && first->unit != second->unit;
        return have_units ? finer_by_unit(before, after) : finer_of(*first, *second);
    }
    return std::nullopt;
}

std::string in_small_letters(std::string_view text) {
    std::string small;
    for (const char c : text) {
        small += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return small;
}

} // namespace

RowWord read_row_word(std::string_view text) {
    const std::string plain = plain_words(text);
    const std::string_view words = trimmed(plain);
    const std::string_view word = words.substr(0, words.find(' '));
    constexpr std::array<std::string_view, 16> pans{
        "pan",        "receiver",      "bottom",  "fond",  "fondo",   "schale", "boden", "bodenschale",
        "bodenblech", "auffangschale", "bandeja", "ciego", "cazuela", "rest",   "base",  "fondello"};
    constexpr std::array<std::string_view, 10> totals{"total", "totals", "sum",    "summe", "somme",
                                                      "suma",  "totale", "gesamt", "somma", "gesamtmasse"};
    constexpr std::array<std::string_view, 8> washed{" wash",   " washed",   " washing",     " lavage",
                                                     " lavado", " lavaggio", " abschlammen", " abgeschlammt"};
    constexpr std::array<std::string_view, 14> losses{"loss",   "lost",     "wash",         "washed",  "washing",
                                                      "fines",  "perte",    "perdida",      "perdita", "lavage",
                                                      "lavado", "lavaggio", "abgeschlammt", "material"};
    const std::string spaced = fmt::format(" {} ", words);
    const bool names_wash = std::any_of(washed.begin(), washed.end(), [&spaced](std::string_view known) {
        return spaced.find(fmt::format("{} ", known)) != std::string::npos;
    });
    const bool is_washed = names_wash && is_among(losses, word); // "Remarks: washed" is a note
    constexpr std::array<std::string_view, 4> doubtful{"bottom", "boden", "rest", "base"}; // of notes, too
    const bool is_note = is_among(doubtful, word) && words.find(' ') != std::string_view::npos;
    if ((is_among(pans, word) && !is_note) || is_washed) {
        return RowWord::Pan;
    }
    const bool is_sum = trimmed(text) == "\u03a3" || trimmed(text) == "\u2211";
    return is_sum || is_among(totals, word) ? RowWord::Total : RowWord::None;
}

SizeText split_size_text(std::string_view text) {
    text = trimmed(text);
    const std::string small = in_small_letters(text);
    for (const Prefix& prefix : prefixes) {
        if (small.starts_with(prefix.text)) {
            const std::size_t skipped = prefix.text.ends_with('#') ? prefix.text.size() - 1 : prefix.text.size();
            return {std::string(trimmed(text.substr(skipped))), prefix.sense};
        }
    }
    constexpr double least_number = 20; // "-200" is what passes No. 200; phi does not go as low
    if (text.starts_with('-') && plain_number(text.substr(1), true).value_or(0) > least_number) {
        return {std::string(trimmed(text.substr(1))), SizeSense::Finer};
    }
    if (text.find('/') == std::string_view::npos && !text.empty() && (is_digit(text[0]) || text[0] == '.')) {
        if (auto found = split_class(text)) {
            return *found;
        }
    }
    return {std::string(text), SizeSense::At};
}

} // namespace suffuse::gradings
