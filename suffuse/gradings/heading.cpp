#include "suffuse/gradings/heading.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/gradings/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <vector>

namespace suffuse::gradings {

namespace {

enum class Role {
    Size,
    Sieve,
    Number,
    Passing,
    Retained,
    Coarser,
    Cumulative,
    OnOne,
    Percent,
    Fraction,
    Mass,
    By,
    Tare,
    And,
    Soil,
    Sample,
    Depth,
    Phi,
    Filler,
};

struct Stem {
    std::string_view text; ///< five letters or more: also within a longer word; fewer: the whole word
    Role role;
};

// clang-format off
constexpr std::array stems{
    // English
    Stem{"d", Role::Size}, Stem{"diam", Role::Size}, Stem{"diameter", Role::Size}, Stem{"size", Role::Size},
    Stem{"sizes", Role::Size}, Stem{"grainsize", Role::Size}, Stem{"opening", Role::Size}, Stem{"aperture", Role::Size},
    Stem{"sieve", Role::Sieve}, Stem{"sieves", Role::Sieve}, Stem{"screen", Role::Sieve}, Stem{"mesh", Role::Number},
    Stem{"no", Role::Number}, Stem{"number", Role::Number}, Stem{"id", Role::Number}, Stem{"name", Role::Filler},
    Stem{"ref", Role::Filler}, Stem{"nos", Role::Number},
    Stem{"designation", Role::Number}, Stem{"passing", Role::Passing}, Stem{"passed", Role::Passing},
    Stem{"passes", Role::Passing}, Stem{"pass", Role::Passing}, Stem{"finer", Role::Passing},
    Stem{"undersize", Role::Passing}, Stem{"under", Role::Passing}, Stem{"smaller", Role::Passing}, Stem{"retained", Role::Retained},
    Stem{"retaining", Role::Retained}, Stem{"ret", Role::Retained}, Stem{"coarser", Role::Coarser},
    Stem{"oversize", Role::Coarser}, Stem{"larger", Role::Coarser}, Stem{"cum", Role::Cumulative},
    Stem{"cumul", Role::Cumulative}, Stem{"total", Role::Cumulative}, Stem{"accumulated", Role::Cumulative},
    Stem{"individual", Role::OnOne}, Stem{"each", Role::OnOne}, Stem{"on", Role::OnOne}, Stem{"partial", Role::OnOne},
    Stem{"percent", Role::Percent}, Stem{"percentage", Role::Percent}, Stem{"pct", Role::Percent},
    Stem{"fraction", Role::Fraction}, Stem{"ratio", Role::Fraction}, Stem{"proportion", Role::Fraction},
    Stem{"mass", Role::Mass}, Stem{"weight", Role::Mass}, Stem{"wt", Role::Mass}, Stem{"g", Role::Mass},
    Stem{"kg", Role::Mass}, Stem{"grams", Role::Mass}, Stem{"gram", Role::Mass}, Stem{"gr", Role::Mass},
    Stem{"by", Role::By}, Stem{"than", Role::Filler}, Stem{"of", Role::Filler}, Stem{"the", Role::Filler},
    Stem{"tare", Role::Tare}, Stem{"empty", Role::Tare}, Stem{"plus", Role::And}, Stem{"and", Role::And},
    Stem{"with", Role::And}, Stem{"gross", Role::And}, Stem{"soil", Role::Soil}, Stem{"sample", Role::Sample},
    Stem{"specimen", Role::Sample}, Stem{"borehole", Role::Sample}, Stem{"bh", Role::Sample},
    Stem{"boring", Role::Sample}, Stem{"point", Role::Sample}, Stem{"pointid", Role::Sample},
    Stem{"hole", Role::Sample}, Stem{"location", Role::Sample}, Stem{"test", Role::Sample}, Stem{"pit", Role::Sample},
    Stem{"depth", Role::Depth}, Stem{"top", Role::Depth}, Stem{"bottom", Role::Depth}, Stem{"phi", Role::Phi},
    Stem{"particle", Role::Filler}, Stem{"grain", Role::Filler}, Stem{"standard", Role::Filler},
    // French
    Stem{"diametre", Role::Size}, Stem{"ouverture", Role::Size}, Stem{"maille", Role::Size}, Stem{"taille", Role::Size},
    Stem{"dimension", Role::Size}, Stem{"tamis", Role::Sieve}, Stem{"passant", Role::Passing},
    Stem{"tamisat", Role::Passing}, Stem{"inferieur", Role::Passing}, Stem{"refus", Role::Retained},
    Stem{"retenu", Role::Retained}, Stem{"partiel", Role::OnOne}, Stem{"pourcentage", Role::Percent},
    Stem{"masse", Role::Mass}, Stem{"poids", Role::Mass}, Stem{"vide", Role::Tare}, Stem{"avec", Role::And},
    Stem{"et", Role::And}, Stem{"sol", Role::Soil}, Stem{"echantillon", Role::Sample}, Stem{"sondage", Role::Sample},
    Stem{"profondeur", Role::Depth}, Stem{"prof", Role::Depth}, Stem{"numero", Role::Number}, Stem{"des", Role::Filler}, Stem{"de", Role::Filler},
    Stem{"du", Role::Filler}, Stem{"la", Role::Filler}, Stem{"les", Role::Filler}, Stem{"en", Role::Filler},
    Stem{"sur", Role::OnOne}, Stem{"grain", Role::Filler}, Stem{"grains", Role::Filler},
    // German
    Stem{"durchmesser", Role::Size}, Stem{"korngro", Role::Size}, Stem{"siebweite", Role::Size},
    Stem{"maschenweite", Role::Size}, Stem{"lochweite", Role::Size}, Stem{"offnung", Role::Size},
    Stem{"oeffnung", Role::Size}, Stem{"siebgro", Role::Size}, Stem{"sieb", Role::Sieve}, Stem{"siebe", Role::Sieve},
    Stem{"durchgang", Role::Passing}, Stem{"durchgange", Role::Passing}, Stem{"feiner", Role::Passing},
    Stem{"ruckstand", Role::Retained}, Stem{"rueckstand", Role::Retained}, Stem{"grober", Role::Coarser},
    Stem{"groeber", Role::Coarser}, Stem{"summe", Role::Cumulative}, Stem{"kumul", Role::Cumulative},
    Stem{"gesamt", Role::Cumulative}, Stem{"einzel", Role::OnOne}, Stem{"auf", Role::OnOne}, Stem{"je", Role::OnOne},
    Stem{"prozent", Role::Percent}, Stem{"anteil", Role::Fraction}, Stem{"gewicht", Role::Mass},
    Stem{"leer", Role::Tare}, Stem{"mit", Role::And}, Stem{"und", Role::And}, Stem{"boden", Role::Soil},
    Stem{"probe", Role::Sample}, Stem{"entnahmestelle", Role::Sample}, Stem{"schurf", Role::Sample}, Stem{"bohrung", Role::Sample}, Stem{"tiefe", Role::Depth}, Stem{"teufe", Role::Depth},
    Stem{"nr", Role::Number}, Stem{"als", Role::Filler}, Stem{"in", Role::Filler}, Stem{"der", Role::Filler},
    // Spanish
    Stem{"diametro", Role::Size}, Stem{"abertura", Role::Size}, Stem{"tamano", Role::Size}, Stem{"malla", Role::Sieve},
    Stem{"tamiz", Role::Sieve}, Stem{"tamices", Role::Sieve}, Stem{"pasa", Role::Passing}, Stem{"pasante", Role::Passing},
    Stem{"pasando", Role::Passing}, Stem{"retenid", Role::Retained}, Stem{"acumulad", Role::Cumulative},
    Stem{"parcial", Role::OnOne}, Stem{"porcentaje", Role::Percent}, Stem{"peso", Role::Mass}, Stem{"masa", Role::Mass},
    Stem{"tara", Role::Tare}, Stem{"vacio", Role::Tare}, Stem{"con", Role::And}, Stem{"suelo", Role::Soil},
    Stem{"muestra", Role::Sample}, Stem{"calicata", Role::Sample}, Stem{"cata", Role::Sample}, Stem{"sondeo", Role::Sample}, Stem{"profundidad", Role::Depth},
    Stem{"que", Role::Filler}, Stem{"del", Role::Filler}, Stem{"el", Role::Filler},
    // Portuguese, where it is not Spanish
    Stem{"peneira", Role::Sieve}, Stem{"retid", Role::Retained}, Stem{"passa", Role::Passing},
    Stem{"amostra", Role::Sample}, Stem{"sondagem", Role::Sample}, Stem{"furo", Role::Sample},
    // Italian
    Stem{"apertura", Role::Size}, Stem{"maglia", Role::Size}, Stem{"dimensione", Role::Size}, Stem{"luce", Role::Size},
    Stem{"setaccio", Role::Sieve}, Stem{"vaglio", Role::Sieve}, Stem{"crivello", Role::Sieve},
    Stem{"passante", Role::Passing}, Stem{"passanti", Role::Passing}, Stem{"trattenut", Role::Retained},
    Stem{"ritenut", Role::Retained}, Stem{"cumulat", Role::Cumulative}, Stem{"progressiv", Role::Cumulative},
    Stem{"parziale", Role::OnOne}, Stem{"singolo", Role::OnOne}, Stem{"percentuale", Role::Percent},
    Stem{"massa", Role::Mass}, Stem{"vuoto", Role::Tare}, Stem{"terreno", Role::Soil}, Stem{"campione", Role::Sample},
    Stem{"sondaggio", Role::Sample}, Stem{"profondita", Role::Depth}, Stem{"di", Role::Filler},
    Stem{"al", Role::Filler}, Stem{"dei", Role::Filler},
};

// clang-format on

std::optional<Role> role_of(std::string_view word) {
    constexpr std::size_t whole = 5; // shorter stems are words of their own
    for (const Stem& stem : stems) {
        if (word == stem.text) {
            return stem.role;
        }
    }
    std::optional<Role> found;
    std::size_t longest = 0;
    for (const Stem& stem : stems) {
        if (stem.text.size() >= whole && stem.text.size() > longest && word.find(stem.text) != std::string_view::npos) {
            found = stem.role, longest = stem.text.size();
        }
    }
    return found;
}

/// Letters of Latin-1 beyond ASCII, from U+00C0 on, without their accents; a blank where there is no letter.
constexpr std::string_view latin = "aaaaaaaceeeeiiiidnooooo ouuuuypsaaaaaaaceeeeiiiidnooooo ouuuuypy";

/// What a bracket or the end of a heading says of the unit. @return whether it is one.
bool take_unit(std::string_view text, Heading& heading) {
    std::string plain(trimmed(text));
    std::transform(plain.begin(), plain.end(), plain.begin(), [](unsigned char c) {
        return static_cast<char>(std::tolower(c));
    });
    if (plain.find('%') != std::string::npos || plain == "percent" || plain == "pct") {
        heading.unit = ShareUnit::Percent;
        return true;
    }
    if (plain == "-" || plain == "1" || plain == "fraction") {
        heading.unit = ShareUnit::Fraction;
        return true;
    }
    if (plain == "g" || plain == "kg" || plain == "gr" || plain == "grams" || plain == "gm" || plain == "mg") {
        heading.unit = ShareUnit::Mass;
        heading.mass_unit = plain == "kg" ? "kg" : plain == "mg" ? "mg" : "g";
        return true;
    }
    if (const SizeScale scale = size_scale_of(trimmed(text)); scale != SizeScale::Unknown) {
        heading.scale = scale;
        return true;
    }
    return false;
}

/// The words of a heading and where each stands in it.
struct Word {
    std::string text; ///< plain
    std::string_view as_written;
};

std::vector<Word> split_words(std::string_view text) {
    std::vector<Word> words;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find_first_of(" \t_.,:;/()[]=\"'", begin), text.size());
        if (end > begin) {
            const std::string_view written = text.substr(begin, end - begin);
            const std::string plain = plain_words(written);
            if (const std::string_view word = trimmed(plain); !word.empty()) {
                words.push_back({std::string(word), written});
            } else if (written == "+" || written == "&") {
                words.push_back({"and", written});
            } else if (written == "#") {
                words.push_back({"no", written});
            }
        }
        begin = end + 1;
    }
    return words;
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
    const std::size_t cut = trimmed(rest).find_last_of(" _,");
    if (cut != std::string_view::npos && heading.scale == SizeScale::Unknown) {
        const std::string whole(trimmed(rest));
        const std::string last(trimmed(std::string_view(whole).substr(cut + 1)));
        const bool is_number_word = last == "No" || last == "no" || last == "No." || last == "Nr" || last == "#";
        const bool is_name = last == "1" || last == "-"; // of a sample: units only in brackets
        if (!is_number_word && !is_name && take_unit(last, heading)) {
            rest = whole.substr(0, cut);
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

/// What has none is the heading's rest.
Roles read_roles(const std::string& named, Heading& heading) {
    Roles roles;
    for (const Word& word : split_words(named)) {
        if (const auto role = role_of(word.text)) {
            roles.add(*role);
        } else {
            heading.rest += heading.rest.empty() ? "" : " ";
            heading.rest += word.as_written;
        }
    }
    return roles;
}

/// Masses of sieves, with soil or empty.
bool take_mass(const Roles& roles, bool weighed, Heading& heading) {
    const bool says_sieve = roles.has(Role::Sieve);
    const bool says_share = roles.has(Role::Passing) || roles.has(Role::Retained) || roles.has(Role::Coarser);
    if (weighed && says_sieve && roles.has(Role::And) && (roles.has(Role::Soil) || roles.has(Role::Retained))) {
        heading.kind = ColumnKind::Gross;
        return true;
    }
    if (weighed && !says_share && (roles.has(Role::Tare) || says_sieve)) {
        heading.kind = ColumnKind::Tare;
        return true;
    }
    return false;
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
    const bool says_mesh = roles.has(Role::Number) && words.find("mesh") != std::string::npos;
    if (roles.has(Role::Sample)) {
        heading.kind = ColumnKind::Sample;
    } else if (roles.has(Role::Depth)) {
        const bool is_of_hydrometer = words.find("effective") != std::string::npos; // how deep its bulb hangs
        heading.kind = is_of_hydrometer ? ColumnKind::Other : ColumnKind::Sample, heading.names_depth = true;
        heading.scale = is_of_hydrometer ? SizeScale::Unknown : heading.scale;
    } else if (roles.has(Role::Size) || roles.has(Role::Sieve) || roles.has(Role::Phi) || says_mesh) {
        heading.kind = ColumnKind::Size;
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

Heading read_heading(std::string_view text) {
    Heading heading;
    const std::string named = cut_unit(text, heading);
    const Roles roles = read_roles(named, heading);
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
    const bool has_digit = heading.rest.find_first_of("0123456789") != std::string::npos;         // a name: TP2 (0.5 m)
    if (heading.kind == ColumnKind::Other && heading.scale != SizeScale::Unknown && !has_digit) { // a unit alone
        heading.kind = ColumnKind::Size, heading.is_length_alone = true;
    } else if (heading.kind == ColumnKind::Other && heading.unit == ShareUnit::Percent && heading.rest.empty()) {
        heading.kind = ColumnKind::Share, heading.meaning = ShareMeaning::Cumulative;
    } else if (heading.kind == ColumnKind::Other && weighed && heading.rest.empty() && !roles.has(Role::Cumulative)) {
        heading.kind = ColumnKind::Share, heading.meaning = ShareMeaning::Retained, heading.is_bare_mass = true;
    }
    if (heading.kind == ColumnKind::Share && weighed) {
        heading.unit = ShareUnit::Mass;
    }
    return heading;
}

} // namespace suffuse::gradings
