#include "suffuse/gradings/derived_names.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/gradings/heading.hpp"
#include "suffuse/gradings/sheet.hpp"
#include "suffuse/gradings/sieve_size.hpp"
#include "suffuse/gradings/size_among_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace suffuse::gradings {

namespace {

using Kind = DerivedValue::Kind;

struct KnownWord {
    std::string_view word;
    Kind kind;
};

// English, French, German, Spanish, Italian; whole words without accents.
constexpr std::array known_words{
    KnownWord{"cu", Kind::Uniformity},
    KnownWord{"u", Kind::Uniformity},
    KnownWord{"uniformity", Kind::Uniformity},
    KnownWord{"uniformite", Kind::Uniformity},
    KnownWord{"ungleichformigkeitszahl", Kind::Uniformity},
    KnownWord{"ungleichformigkeit", Kind::Uniformity},
    KnownWord{"uniformidad", Kind::Uniformity},
    KnownWord{"uniformita", Kind::Uniformity},
    KnownWord{"hazen", Kind::Uniformity},
    KnownWord{"cc", Kind::Curvature},
    KnownWord{"cz", Kind::Curvature},
    KnownWord{"c", Kind::Curvature},
    KnownWord{"curvature", Kind::Curvature},
    KnownWord{"courbure", Kind::Curvature},
    KnownWord{"krummungszahl", Kind::Curvature},
    KnownWord{"curvatura", Kind::Curvature},
    KnownWord{"cobbles", Kind::Cobbles},
    KnownWord{"boulders", Kind::Cobbles},
    KnownWord{"cailloux", Kind::Cobbles},
    KnownWord{"steine", Kind::Cobbles},
    KnownWord{"bolos", Kind::Cobbles},
    KnownWord{"ciottoli", Kind::Cobbles},
    KnownWord{"gravel", Kind::Gravel},
    KnownWord{"gravier", Kind::Gravel},
    KnownWord{"graviers", Kind::Gravel},
    KnownWord{"kies", Kind::Gravel},
    KnownWord{"grava", Kind::Gravel},
    KnownWord{"gravas", Kind::Gravel},
    KnownWord{"ghiaia", Kind::Gravel},
    KnownWord{"sand", Kind::Sand},
    KnownWord{"sable", Kind::Sand},
    KnownWord{"sables", Kind::Sand},
    KnownWord{"arena", Kind::Sand},
    KnownWord{"arenas", Kind::Sand},
    KnownWord{"sabbia", Kind::Sand},
    KnownWord{"fines", Kind::Fines},
    KnownWord{"finos", Kind::Fines},
    KnownWord{"fini", Kind::Fines},
    KnownWord{"feinanteil", Kind::Fines},
    KnownWord{"silt", Kind::Silt},
    KnownWord{"limon", Kind::Silt},
    KnownWord{"limons", Kind::Silt},
    KnownWord{"schluff", Kind::Silt},
    KnownWord{"limo", Kind::Silt},
    KnownWord{"clay", Kind::Clay},
    KnownWord{"argile", Kind::Clay},
    KnownWord{"argiles", Kind::Clay},
    KnownWord{"ton", Kind::Clay},
    KnownWord{"arcilla", Kind::Clay},
    KnownWord{"argilla", Kind::Clay},
    KnownWord{"dmax", Kind::Largest},
    KnownWord{"maximum", Kind::Largest},
    KnownWord{"coarse", Kind::Other},
    KnownWord{"medium", Kind::Other},
    KnownWord{"fine", Kind::Other},
    KnownWord{"fm", Kind::Other},
    KnownWord{"fineness", Kind::Other},
    KnownWord{"modulus", Kind::Other},
    KnownWord{"finura", Kind::Other},
    KnownWord{"finesse", Kind::Other},
    KnownWord{"ll", Kind::Other},
    KnownWord{"pl", Kind::Other},
    KnownWord{"pi", Kind::Other},
    KnownWord{"ip", Kind::Other},
    KnownWord{"liquid", Kind::Other},
    KnownWord{"plastic", Kind::Other},
    KnownWord{"plasticity", Kind::Other},
    KnownWord{"gs", Kind::Other},
    KnownWord{"gravity", Kind::Other},
    KnownWord{"uscs", Kind::Other},
    KnownWord{"aashto", Kind::Other},
    KnownWord{"classification", Kind::Other},
    KnownWord{"moisture", Kind::Other},
    KnownWord{"water", Kind::Other},
    KnownWord{"dmin", Kind::Other},
    KnownWord{"siebverlust", Kind::Other},
    KnownWord{"loss", Kind::Other},
    KnownWord{"mean", Kind::Other},
    KnownWord{"median", Kind::Other},
    KnownWord{"sorting", Kind::Other},
    KnownWord{"skewness", Kind::Other},
    KnownWord{"kurtosis", Kind::Other}};

constexpr std::array<std::string_view, 33> fillers{
    "coefficient", "coeff", "coef",  "coefficiente", "of", "de",  "di",   "d",      "der",      "content", "percent",
    "percentage",  "pct",   "total", "size",         "mm", "um",  "m",    "value",  "the",      "index",   "number",
    "particle",    "grain", "limit", "specific",     "by", "dry", "mass", "weight", "fraction", "f",       "and"};

std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    const std::string plain = plain_words(text);
    for (std::size_t begin = 0; begin < plain.size();) {
        const std::size_t end = std::min(plain.find(' ', begin), plain.size());
        if (end > begin) {
            words.push_back(plain.substr(begin, end - begin));
        }
        begin = end + 1;
    }
    return words;
}

/// "d10", "d 10", "D(0.1)": the share passing.
std::optional<double> read_percentile(std::string_view text) {
    std::string plain;
    for (const char c : text) {
        plain += c == ',' ? '.' : c;
    }
    std::string_view rest = trimmed(plain);
    if (rest.empty() || (rest.front() != 'd' && rest.front() != 'D')) {
        return std::nullopt;
    }
    rest.remove_prefix(1);
    while (!rest.empty() && std::string_view(" _([v").find(rest.front()) != std::string_view::npos) {
        rest.remove_prefix(1);
    }
    const std::size_t end = std::min(rest.find_first_not_of("0123456789."), rest.size());
    const auto number = plain_number(rest.substr(0, end), false);
    rest.remove_prefix(end);
    const std::string after = plain_words(rest);
    const std::string_view unit = trimmed(after);
    const bool is_alone = unit.empty() || size_scale_of(unit) != SizeScale::Unknown || unit == "size";
    if (!number || !is_alone || !(*number > 0) || *number > 100) {
        return std::nullopt;
    }
    return *number < 1 ? *number : *number / 100;
}

std::optional<Kind> kind_of(const std::vector<std::string>& words) {
    if (words == std::vector<std::string>{"f", "m"}) { // F.M., the fineness modulus
        return Kind::Other;
    }
    std::optional<Kind> found;
    for (const std::string& word : words) {
        const auto known = std::ranges::find(known_words, std::string_view(word), &KnownWord::word);
        if (known == known_words.end()) {
            if (std::ranges::find(fillers, std::string_view(word)) == fillers.end()) {
                return std::nullopt;
            }
            continue;
        }
        const bool are_fines = found && ((*found == Kind::Silt && known->kind == Kind::Clay) ||
                                         (*found == Kind::Clay && known->kind == Kind::Silt) ||
                                         (*found == Kind::Fines && known->kind != Kind::Other));
        const bool agree = !found || *found == known->kind;
        found = are_fines ? Kind::Fines : agree ? known->kind : Kind::Other;
    }
    return found;
}

/// "% passing No. 200": the sieve.
std::optional<double> sieve_in(std::string_view name) {
    const Heading heading = read_heading(name);
    const auto size = read_sieve_size(size_among_words(name), SizeScale::Unknown);
    const bool is_named = size && size->is_on_scale && size->notation != SizeNotation::Plain;
    return is_named && heading.meaning == ShareMeaning::Passing ? std::optional(size->diameter) : std::nullopt;
}

std::optional<DerivedValue> read_name(std::string_view name) {
    DerivedValue found;
    found.name = std::string(name);
    if (const auto share = read_percentile(name)) {
        found.kind = Kind::SizeAt, found.at = *share;
    } else if (name.starts_with('%') && plain_words(name).find(" 3 ") != std::string::npos && name.find('+') != std::string_view::npos) { // % +3"
        found.kind = Kind::Cobbles;
    } else if (const auto size = sieve_in(name)) {
        found.kind = Kind::Passing, found.at = *size;
    } else if (const auto kind = kind_of(words_of(name))) {
        found.kind = *kind;
    } else {
        return std::nullopt;
    }
    return found;
}

} // namespace

std::size_t value_begin(std::string_view text) {
    const std::size_t mark = text.find_first_of("=:");
    if (mark != std::string_view::npos) {
        return mark + 1;
    }
    for (std::size_t at = text.find(' '); at < text.size(); at = text.find(' ', at + 1)) {
        std::string_view value = trimmed(text.substr(at));
        value = value.ends_with('%') ? trimmed(value.substr(0, value.size() - 1)) : value;
        const bool is_value = plain_number(value, true) || read_sieve_size(value, SizeScale::Millimeters);
        if (is_value && read_name(trimmed(text.substr(0, at)))) {
            return at;
        }
    }
    return text.size();
}

std::optional<DerivedValue> read_derived_name(std::string_view text) {
    constexpr std::size_t longest = 80; // of a name
    if (text.size() > longest) {
        return std::nullopt;
    }
    if (auto whole = read_name(trimmed(text))) { // D 10, % passing No. 200
        return whole;
    }
    std::string_view name = text.substr(0, value_begin(text));
    while (name.ends_with('=') || name.ends_with(':') || name.ends_with(' ')) {
        name.remove_suffix(1);
    }
    return read_name(trimmed(name));
}

std::vector<std::string_view> split_joined(std::string_view text) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('/', begin), text.size());
        parts.push_back(trimmed(text.substr(begin, end - begin)));
        begin = end + 1;
    }
    return parts;
}

std::vector<DerivedValue> read_joined_names(std::string_view text) {
    const std::size_t mark = std::min(text.find_first_of("=:"), text.size());
    std::vector<DerivedValue> names;
    const auto parts = split_joined(text.substr(0, mark));
    for (const std::string_view part : parts) {
        if (auto name = parts.size() > 1 ? read_name(part) : std::nullopt) {
            names.push_back(std::move(*name));
        } else {
            return {};
        }
    }
    const auto whole = read_name(trimmed(text.substr(0, mark)));
    const bool is_one = whole && whole->kind != Kind::Other; // silt/clay are the fines
    return is_one ? std::vector<DerivedValue>{} : names;
}

} // namespace suffuse::gradings
