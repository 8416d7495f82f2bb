#include "suffuse/gradings/sieve_size.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/base/units.hpp"
#include "suffuse/gradings/lexicon.hpp"
#include "suffuse/gradings/sheet.hpp"
#include "suffuse/io/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::gradings {

namespace {

struct Opening {
    double name; ///< number, or inches
    const char* millimeters;
};

// ASTM E11-20, table 1: standard designation next to the alternative one.
constexpr std::array numbers{
    Opening{3.5, "5.6"},   Opening{4, "4.75"},    Opening{5, "4"},       Opening{6, "3.35"},    Opening{7, "2.8"},
    Opening{8, "2.36"},    Opening{10, "2"},      Opening{12, "1.7"},    Opening{14, "1.4"},    Opening{16, "1.18"},
    Opening{18, "1"},      Opening{20, "0.85"},   Opening{25, "0.71"},   Opening{30, "0.6"},    Opening{35, "0.5"},
    Opening{40, "0.425"},  Opening{45, "0.355"},  Opening{50, "0.3"},    Opening{60, "0.25"},   Opening{70, "0.212"},
    Opening{80, "0.18"},   Opening{100, "0.15"},  Opening{120, "0.125"}, Opening{140, "0.106"}, Opening{170, "0.09"},
    Opening{200, "0.075"}, Opening{230, "0.063"}, Opening{270, "0.053"}, Opening{325, "0.045"}, Opening{400, "0.038"},
    Opening{450, "0.032"}, Opening{500, "0.025"}, Opening{635, "0.02"}};

constexpr std::array inches{
    Opening{5, "125"},     Opening{4.24, "106"},  Opening{4, "100"},    Opening{3.5, "90"},      Opening{3, "75"},
    Opening{2.5, "63"},    Opening{2.12, "53"},   Opening{2, "50"},     Opening{1.75, "45"},     Opening{1.5, "37.5"},
    Opening{1.25, "31.5"}, Opening{1.06, "26.5"}, Opening{1, "25"},     Opening{0.875, "22.4"},  Opening{0.75, "19"},
    Opening{0.625, "16"},  Opening{0.53, "13.2"}, Opening{0.5, "12.5"}, Opening{0.4375, "11.2"}, Opening{0.375, "9.5"},
    Opening{0.3125, "8"},  Opening{0.265, "6.7"}, Opening{0.25, "6.3"}};

double in_meters(std::string_view millimeters) {
    return parse_quantity(fmt::format("{} mm", millimeters), dimension::length);
}

template <std::size_t N>
std::optional<double> find_opening(const std::array<Opening, N>& table, double name) {
    const auto same = [name](const Opening& opening) { return std::abs(opening.name - name) <= 1e-9 * name; };
    const auto found = std::find_if(table.begin(), table.end(), same);
    return found == table.end() ? std::nullopt : std::optional(in_meters(found->millimeters));
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
}

/// Small letters; one sign for what is written in many ways: quotes of inches, fractions, micro, numero.
std::string in_plain_signs(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 24> signs{
        {{"\u201d", "\""},       {"\u201c", "\""},   {"\u2033", "\""},   {"\u2019\u2019", "\""}, {"''", "\""},
         {"\u00b4\u00b4", "\""}, {"\u00bd", " 1/2"}, {"\u00bc", " 1/4"}, {"\u00be", " 3/4"},     {"\u215c", " 3/8"},
         {"\u215d", " 5/8"},     {"\u215b", " 1/8"}, {"\u215e", " 7/8"}, {"\u2044", "/"},        {"\u00b5", "u"},
         {"\u03bc", "u"},        {"\u2116", "no"},   {"n\u00b0", "no"},  {"n\u00ba", "no"},      {"\u2013", "-"},
         {"\u2212", "-"},        {"\u00a0", " "},    {"\u202f", " "},    {"\u2212", "-"}}};
    std::string plain = in_small_letters(text);
    for (const auto& [from, to] : signs) {
        replace_all(plain, from, to);
    }
    return std::string(trimmed(plain));
}

bool take_front(std::string_view& text, std::string_view token) {
    if (!text.starts_with(token)) {
        return false;
    }
    text = trimmed(text.substr(token.size()));
    return true;
}

/// "1-1/2", "1 1/2", "3/8", "2": as a number.
std::optional<double> mixed_number(std::string_view text, bool comma) {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) {
        return plain_number(text, comma);
    }
    std::string_view over = trimmed(text.substr(0, slash));
    const auto under = plain_number(trimmed(text.substr(slash + 1)), false);
    double whole = 0;
    if (const std::size_t cut = over.find_last_of(" -"); cut != std::string_view::npos) {
        const auto front = plain_number(trimmed(over.substr(0, over.find_last_not_of(" -", cut) + 1)), false);
        if (!front) {
            return std::nullopt;
        }
        whole = *front;
        over = over.substr(cut + 1);
    }
    const auto part = plain_number(over, false);
    if (!part || !under || !(*under > 0) || !(*part >= 0)) {
        return std::nullopt;
    }
    return whole + *part / *under;
}

SieveSize by_inches(double name) {
    const auto opening = find_opening(inches, name);
    return {opening.value_or(0.0254 * name), SizeNotation::Inches, opening.has_value()};
}

SieveSize by_number(double number) {
    const auto opening = sieve_opening(number);
    return {opening.value_or(0), SizeNotation::SieveNumber, opening.has_value()};
}

/// Where the number ends and its unit begins.
std::size_t end_of_number(std::string_view text) {
    std::size_t k = 0;
    while (k < text.size() && (is_digit(text[k]) || std::string_view("+-.,/ ").find(text[k]) != std::string_view::npos)
    ) {
        ++k;
    }
    const char after = k + 1 < text.size() ? text[k + 1] : ' ';
    if (k > 0 && k + 1 < text.size() && text[k] == 'e' && (is_digit(after) || after == '-' || after == '+')) {
        k += 2;
        while (k < text.size() && is_digit(text[k])) {
            ++k;
        }
    }
    return k;
}

/// The digits as they stand, with a decimal point, so that a unit only moves their exponent.
std::optional<double> on_unit(std::string_view digits, std::string_view unit, bool comma) {
    if (!plain_number(digits, comma)) {
        return std::nullopt;
    }
    std::string number(trimmed(digits));
    std::replace(number.begin(), number.end(), ',', '.');
    try {
        return parse_quantity(fmt::format("{} {}", number, unit), dimension::length);
    } catch (const UnitError&) {
        return std::nullopt;
    }
}

const char* unit_of(SizeScale scale) {
    switch (scale) {
    case SizeScale::Micrometers:
        return "um";
    case SizeScale::Meters:
        return "m";
    case SizeScale::Centimeters:
        return "cm";
    default:
        return "mm";
    }
}

/// A number without unit, on the scale of its column.
std::optional<SieveSize> on_scale(std::string_view text, SizeScale scale, bool comma) {
    if (text.find('/') != std::string_view::npos || scale == SizeScale::Inches) {
        const auto name = mixed_number(text, comma);
        return name ? std::optional(by_inches(*name)) : std::nullopt;
    }
    const auto number = plain_number(text, comma);
    if (!number) {
        return std::nullopt;
    }
    if (scale == SizeScale::SieveNumber) {
        return by_number(*number);
    }
    if (scale == SizeScale::Phi) {
        return SieveSize{std::exp2(-*number) * 1e-3, SizeNotation::Plain, true};
    }
    const auto size = on_unit(text, unit_of(scale), comma);
    return size ? std::optional(SieveSize{*size, SizeNotation::Plain, true}) : std::nullopt;
}

/// "no. 4", "#4", "sieve no 4", "4 mesh": the number alone.
std::optional<std::string_view> cut_number_word(std::string_view text) {
    bool is_cut = false;
    for (const std::string_view word : {"sieve", "astm", "tamis", "tamiz", "sieb", "setaccio", "us", "mesh"}) {
        const bool is_mesh = word == "mesh";
        is_cut = (take_front(text, word) && is_mesh) || is_cut;
    }
    for (const std::string_view word : {"#", "no.", "nos.", "nr.", "num.", "n.", "no", "nr", "n"}) {
        if (text.starts_with(word) && !trimmed(text.substr(word.size())).empty() &&
            is_digit(trimmed(text.substr(word.size()))[0])) {
            return trimmed(text.substr(word.size()));
        }
    }
    if (text.ends_with("mesh")) {
        return trimmed(text.substr(0, text.size() - 4));
    }
    return is_cut ? std::optional(text) : std::nullopt;
}

} // namespace

std::optional<double> plain_number(std::string_view text, bool comma) {
    text = trimmed(text);
    std::string number(text);
    if (const std::size_t at = number.find(','); at != std::string::npos) {
        if (!comma || number.find_first_of(",.", at + 1) != std::string::npos || number.find('.') < at) {
            return std::nullopt;
        }
        number[at] = '.';
    }
    const auto value = io::number_of<double>(number);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<double> sieve_opening(double number) {
    return find_opening(numbers, number);
}

SizeScale size_scale_of(std::string_view unit) {
    std::string plain = in_plain_signs(unit);
    while (plain.ends_with('.')) {
        plain.pop_back();
    }
    return size_scale_named(plain);
}

const char* scale_name(SizeScale scale) {
    switch (scale) {
    case SizeScale::Inches:
        return "in";
    case SizeScale::SieveNumber:
        return "no";
    case SizeScale::Phi:
        return "phi";
    default:
        return unit_of(scale);
    }
}

std::optional<SieveSize> read_sieve_size(std::string_view text, SizeScale scale, bool comma) {
    const std::string plain = in_plain_signs(text);
    std::string_view rest = plain;
    if (const std::size_t open = rest.find_first_of("(["); open != std::string_view::npos && open > 0) {
        const std::size_t close = rest.find_first_of(")]", open);
        const auto within = rest.substr(open + 1, close == std::string_view::npos ? close : close - open - 1);
        // No. 4 (4.75 mm): the opening in brackets is exact
        if (const auto size = read_sieve_size(within, SizeScale::Unknown, comma);
            size && size->notation != SizeNotation::Plain) {
            return size;
        }
        rest = trimmed(rest.substr(0, open));
    }
    if (const auto number = cut_number_word(rest)) {
        const auto value = mixed_number(*number, comma);
        return value ? std::optional(by_number(*value)) : std::nullopt;
    }
    const std::size_t end = end_of_number(rest);
    std::string_view unit = trimmed(rest.substr(end)), digits = trimmed(rest.substr(0, end));
    if (digits.ends_with('-')) { // 3/8-inch, 1.5-in.
        digits = trimmed(digits.substr(0, digits.size() - 1));
    }
    if (digits.empty()) {
        return std::nullopt;
    }
    if (unit.empty()) {
        return on_scale(digits, scale, comma);
    }
    if (unit.ends_with(" sieve")) {
        unit = trimmed(unit.substr(0, unit.size() - 6));
    }
    const SizeScale own = size_scale_of(unit);
    if (own == SizeScale::Unknown) {
        return std::nullopt;
    }
    auto size = on_scale(digits, own, comma);
    if (size && size->notation == SizeNotation::Plain) {
        size->notation = SizeNotation::WithUnit;
    }
    return size;
}

} // namespace suffuse::gradings
