#include "suffuse/gradings/derived_names.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/gradings/heading.hpp"
#include "suffuse/gradings/lexicon.hpp"
#include "suffuse/gradings/sheet.hpp"
#include "suffuse/gradings/sieve_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace suffuse::gradings {

namespace {

using Kind = DerivedValue::Kind;

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
        const auto known = result_named(word);
        if (!known) {
            if (!is_word_of(Topic::ResultFiller, word)) {
                return std::nullopt;
            }
            continue;
        }
        const bool are_fines = found && ((*found == Kind::Silt && *known == Kind::Clay) ||
                                         (*found == Kind::Clay && *known == Kind::Silt) ||
                                         (*found == Kind::Fines && *known != Kind::Other));
        const bool agree = !found || *found == *known;
        found = are_fines ? Kind::Fines : agree ? *known : Kind::Other;
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
