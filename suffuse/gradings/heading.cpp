#include "suffuse/gradings/heading.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/gradings/lexicon.hpp"
#include "suffuse/gradings/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <vector>

namespace suffuse::gradings {

namespace {

/// Letters of Latin-1 beyond ASCII, from U+00C0 on, without their accents; a blank where there is no letter.
constexpr std::string_view latin = "aaaaaaaceeeeiiiidnooooo ouuuuypsaaaaaaaceeeeiiiidnooooo ouuuuypy";

/// What a bracket or the end of a heading says of the unit. @return whether it is one.
bool take_unit(std::string_view text, Heading& heading) {
    const std::string plain = in_small_letters(trimmed(text));
    const ShareUnit unit = plain.find('%') != std::string::npos ? ShareUnit::Percent : share_unit_named(plain);
    if (unit != ShareUnit::Unknown) {
        heading.unit = unit;
        heading.mass_unit = unit != ShareUnit::Mass ? heading.mass_unit
                            : plain == "kg"         ? "kg"
                            : plain == "mg"         ? "mg"
                                                    : "g";
        return true;
    }
    if (const SizeScale scale = size_scale_of(trimmed(text)); scale != SizeScale::Unknown) {
        heading.scale = scale;
        return true;
    }
    return false;
}

/// A word of a heading, plain; empty where it has no letter and no digit.
std::string plain_word(std::string_view written) {
    const std::string plain = plain_words(written);
    return written == "+" || written == "&" ? "and" : written == "#" ? "no" : std::string(trimmed(plain));
}

/// Cuts the unit off, from brackets or the end: "Sieve size (mm)", "Opening, mm", "d_mm".
std::string cut_unit(std::string_view text, Heading& heading) {
    std::string rest(text);
    if (rest.find('%') != std::string::npos) {
        heading.unit = ShareUnit::Percent;
        std::replace(rest.begin(), rest.end(), '%', ' ');
    }
    for (std::size_t open = rest.find_first_of("[("); open != std::string::npos;
         open = rest.find_first_of("[(", open)) {
        const std::size_t close = std::min(rest.find_first_of("])", open), rest.size() - 1);
        const std::string within = rest.substr(open + 1, close - open - 1);
        const bool is_unit = take_unit(within, heading);
        heading.own_unit = is_unit || within.empty() ? heading.own_unit : within;
        rest.replace(open, close + 1 - open, is_unit ? " " : fmt::format(" {} ", within));
    }
    const std::string whole(trimmed(rest));
    const SizeScale alone = size_scale_of(whole); // "mm" next to "% passing"
    if (alone == SizeScale::Millimeters || alone == SizeScale::Micrometers || alone == SizeScale::Centimeters) {
        heading.scale = alone;
        return {};
    }
    for (const char* marks : {" _,", "/"}) { // "xo/um", but "share g/kg"
        const std::size_t cut = whole.find_last_of(marks);
        if (cut == std::string::npos || heading.scale != SizeScale::Unknown || heading.unit != ShareUnit::Unknown) {
            continue; // "In %"
        }
        const std::string last(trimmed(std::string_view(whole).substr(cut + 1)));
        const bool is_number_word = last == "No" || last == "no" || last == "No." || last == "Nr" || last == "#";
        const bool is_name = last == "1" || last == "-"; // of a sample: units only in brackets
        if (!is_number_word && !is_name && take_unit(last, heading)) {
            return whole.substr(0, cut);
        }
    }
    return rest;
}

/// Which roles the words of a heading have.
class Roles {
public:
    void add(Role role) { is_there_[static_cast<std::size_t>(role)] = true; }

    [[nodiscard]] bool has(Role role) const { return is_there_[static_cast<std::size_t>(role)]; }

private:
    std::array<bool, static_cast<std::size_t>(Role::Filler) + 1> is_there_{};
};

/// What stands between two words of a name, as written; a blank for any number of them.
std::string between(std::string_view text) {
    std::string kept;
    for (const char c : text) {
        const bool is_blank = c == ' ' || c == '\t';
        if (!is_blank || kept.empty() || kept.back() != ' ') {
            kept += is_blank ? ' ' : c;
        }
    }
    return kept;
}

/// What has none is the heading's rest.
Roles read_roles(const std::string& named, Heading& heading) {
    Roles roles;
    std::size_t end = std::string::npos; // of the word of the rest right before
    for (const std::string_view written : split_words(named, " \t_.,:;/()[]=\"'")) {
        const std::string word = plain_word(written);
        if (const auto role = role_of(word)) {
            roles.add(*role);
            end = std::string::npos;
        } else if (!word.empty()) {
            const auto begin = static_cast<std::size_t>(written.data() - named.data());
            const bool follows = end != std::string::npos && !heading.rest.empty();
            heading.rest += follows ? between(named.substr(end, begin - end)) : heading.rest.empty() ? "" : " ";
            heading.rest += written;
            end = begin + written.size();
        }
    }
    return roles;
}

/// "finer by number (%)", "Q0 [%]", but "% passing number 200", which is a sieve.
bool counts_grains(const Roles& roles, std::string_view text) {
    constexpr std::string_view number = " number ";
    const std::string words = spaced_words(text);
    const std::size_t at = words.find(number);
    const bool has_unit = words.find(" mm ") != std::string::npos || words.find(" um ") != std::string::npos;
    const bool is_sieve = at != std::string::npos && is_digit(words[at + number.size()]) && !has_unit;
    return mentions(Topic::Counted, words) && !is_sieve && !roles.has(Role::Sieve) && !roles.has(Role::Sample);
}

/// Masses of sieves, with soil or empty.
bool take_mass(const Roles& roles, bool weighed, Heading& heading) {
    const bool names_sieve = roles.has(Role::Sieve);
    const bool names_share = roles.has(Role::Passing) || roles.has(Role::Retained) || roles.has(Role::Coarser);
    const bool is_called_gross = !names_share && roles.has(Role::Gross) && !roles.has(Role::Tare); // "gross_g"
    const bool holds_both = names_sieve && (roles.has(Role::And) || roles.has(Role::Gross)) &&
                            (roles.has(Role::Soil) || roles.has(Role::Sample) || roles.has(Role::Retained));
    const bool is_gross = weighed && (is_called_gross || holds_both);
    const bool is_tare = weighed && !names_share && (roles.has(Role::Tare) || names_sieve);
    heading.kind = is_gross ? ColumnKind::Gross : is_tare ? ColumnKind::Tare : heading.kind;
    return is_gross || is_tare;
}

bool take_share(const Roles& roles, Heading& heading) {
    const bool has_unit = heading.unit != ShareUnit::Mass && heading.unit != ShareUnit::Unknown;
    if (roles.has(Role::Passing)) {
        heading.meaning = ShareMeaning::Passing;
    } else if (roles.has(Role::Coarser)) {
        heading.meaning = ShareMeaning::CumulativeRetained;
    } else if (roles.has(Role::Retained)) {
        heading.meaning = roles.has(Role::Cumulative) ? ShareMeaning::CumulativeRetained
                          : roles.has(Role::OnOne)    ? ShareMeaning::OnSieve
                                                      : ShareMeaning::Retained;
    } else if (roles.has(Role::Cumulative) && has_unit) {
        heading.meaning = ShareMeaning::Cumulative;
    } else {
        return false;
    }
    heading.kind = ColumnKind::Share;
    return true;
}

/// Names of samples, depths and sizes. @param words of the whole heading
void take_other_kind(const Roles& roles, const std::string& words, Heading& heading) {
    const bool names_mesh = roles.has(Role::Number) && words.find("mesh") != std::string::npos;
    if (roles.has(Role::Sample)) {
        heading.kind = ColumnKind::Sample;
    } else if (roles.has(Role::Depth)) {
        const bool is_of_hydrometer = words.find("effective") != std::string::npos; // how deep its bulb hangs
        heading.kind = is_of_hydrometer ? ColumnKind::Other : ColumnKind::Sample, heading.names_depth = true;
        heading.scale = is_of_hydrometer ? SizeScale::Unknown : heading.scale;
    } else if (roles.has(Role::Size) || roles.has(Role::Sieve) || roles.has(Role::Phi) || names_mesh) {
        heading.kind = ColumnKind::Size;
        heading.names_sieve_alone = roles.has(Role::Sieve) && !roles.has(Role::Size);
        if (roles.has(Role::Phi)) {
            heading.scale = SizeScale::Phi;
        } else if (roles.has(Role::Number) && heading.scale == SizeScale::Unknown) {
            heading.scale = SizeScale::SieveNumber;
        }
    }
}

} // namespace

std::string plain_words(std::string_view text) {
    std::string plain;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const auto byte = static_cast<unsigned char>(text[k]);
        if (byte == 0xC3 && k + 1 < text.size()) { // U+00C0 to U+00FF
            const auto second = static_cast<unsigned char>(text[++k]);
            plain += second == 0x9F ? "ss" : std::string(1, latin[(second - 0x80U) % latin.size()]);
        } else if (byte == 0xCC) { // an accent that stands apart
            ++k;
        } else if ((text.substr(k, 2) == "\u03c6" || text.substr(k, 2) == "\u03d5") && k + 1 < text.size()) {
            plain += "phi";
            ++k;
        } else if (std::isalnum(byte) != 0) {
            plain += static_cast<char>(std::tolower(byte));
        } else {
            plain += ' ';
        }
    }
    return plain;
}

std::string spaced_words(std::string_view text) {
    std::string words = " ";
    const std::string plain = plain_words(text);
    for (const std::string_view word : split_words(plain, " ")) {
        words += fmt::format("{} ", word);
    }
    return words;
}

Heading read_heading(std::string_view text) {
    Heading heading;
    const std::string named = cut_unit(text, heading);
    const Roles roles = read_roles(named, heading);
    heading.counts_grains = counts_grains(roles, text);
    if (roles.has(Role::Percent)) {
        heading.unit = ShareUnit::Percent;
    } else if (roles.has(Role::Fraction) && heading.unit == ShareUnit::Unknown) {
        heading.unit = ShareUnit::Fraction;
    }
    const bool weighed = heading.unit == ShareUnit::Mass ||
                         (roles.has(Role::Mass) && heading.unit == ShareUnit::Unknown && !roles.has(Role::By));
    if (!take_mass(roles, weighed, heading) && !take_share(roles, heading)) {
        take_other_kind(roles, plain_words(text), heading);
    }
    const bool has_digit = heading.rest.find_first_of("0123456789") != std::string::npos; // a name: TP2 (0.5 m)
    const bool is_open = heading.kind == ColumnKind::Other,
               is_counted = roles.has(Role::Count) && heading.unit == ShareUnit::Unknown;
    if (is_open && heading.scale != SizeScale::Unknown && !has_digit) { // a unit alone
        heading.kind = ColumnKind::Size, heading.is_length_alone = true;
    } else if (is_open && heading.unit == ShareUnit::Percent && heading.rest.empty()) {
        heading.kind = ColumnKind::Share, heading.meaning = ShareMeaning::Unstated;
    } else if (is_open && (weighed || is_counted) && heading.rest.empty()) {
        heading.kind = ColumnKind::Share, heading.is_bare_mass = weighed;
        heading.unit = weighed ? heading.unit : ShareUnit::Count;
        heading.meaning = roles.has(Role::Cumulative) ? ShareMeaning::Cumulative : ShareMeaning::Retained;
    }
    if (heading.kind == ColumnKind::Share && weighed) {
        heading.unit = ShareUnit::Mass;
    }
    return heading;
}

std::string size_among_words(std::string_view text) {
    constexpr std::size_t longest = 80; // of a heading
    if (text.size() > longest || text.find_first_of("0123456789") == std::string_view::npos) {
        return {};
    }
    const ColumnKind kind = read_heading(text).kind;
    if (kind != ColumnKind::Share && kind != ColumnKind::Tare) { // "Sieve_2000um_g"
        return {};
    }
    constexpr std::string_view marks = " <>_()";
    for (std::size_t begin = 0; begin < text.size(); ++begin) {
        if (begin > 0 && marks.find(text[begin - 1]) == std::string_view::npos) {
            continue;
        }
        for (std::size_t end = text.size(); end > begin; --end) {
            const bool is_end = end == text.size() || marks.find(text[end]) != std::string_view::npos;
            const std::string_view part = trimmed(text.substr(begin, end - begin));
            if (is_end && read_sieve_size(part, SizeScale::Unknown)) {
                return std::string(part);
            }
        }
    }
    return {};
}

} // namespace suffuse::gradings
