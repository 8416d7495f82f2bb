#include "suffuse/laboratory/test_heading.hpp"

#include "suffuse/io/text_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <vector>

namespace suffuse::laboratory {
namespace {

using Replacement = std::pair<std::string_view, std::string_view>;

std::string replaced(std::string_view text, std::span<const Replacement> list) {
    std::string changed(text);
    for (const auto& [from, to] : list) {
        for (std::size_t at = changed.find(from); at != std::string::npos; at = changed.find(from, at + to.size())) {
            changed.replace(at, from.size(), to);
        }
    }
    return changed;
}

/// Greek letters and digits below the line by their names.
std::string with_latin_letters(std::string_view text) {
    constexpr std::array list{Replacement{"\u03b5", "eps"},   Replacement{"\u03c3", "sigma"},
                              Replacement{"\u0394", "delta"}, Replacement{"\u2032", "'"},
                              Replacement{"\u2019", "'"},     Replacement{"\u2081", "1"},
                              Replacement{"\u2083", "3"},     Replacement{"\u2212", "-"},
                              Replacement{"\u2010", "-"},     Replacement{"\u2013", "-"}};
    return replaced(text, list);
}

/// Small letters and digits, in words; an apostrophe belongs to the word before it.
std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words(1);
    for (const char c : text) {
        const auto letter = static_cast<unsigned char>(c);
        if (std::isalnum(letter) != 0 || c == '\'' || letter >= 0x80) {
            words.back() += static_cast<char>(std::tolower(letter));
        } else if (!words.back().empty()) {
            words.emplace_back();
        }
    }
    if (words.back().empty()) {
        words.pop_back();
    }
    return words;
}

bool take_word(std::vector<std::string>& words, std::initializer_list<std::string_view> known) {
    const auto is_known = [&](const std::string& word) { return std::ranges::find(known, word) != known.end(); };
    return std::erase_if(words, is_known) > 0;
}

/// Takes the words that say more of the quantity. @return whether there was one
bool take_remarks(std::vector<std::string>& words, TestHeading& heading) {
    heading.is_effective = take_word(words, {"effective", "eff"}) || heading.is_effective;
    heading.is_total = take_word(words, {"total"});
    heading.is_cumulative = take_word(words, {"cumulative", "cum", "accumulated"});
    heading.expands = take_word(words, {"dilation", "dilatation", "dilative", "expansion", "extension", "swelling"});
    heading.contracts = take_word(words, {"contraction", "contractive", "compression", "compressive"});
    if (heading.expands || heading.contracts) {
        take_word(words, {"positive", "pos", "ve", "is", "as"});
        if (take_word(words, {"negative", "neg"})) {
            std::swap(heading.expands, heading.contracts);
        }
    }
    return heading.is_effective || heading.is_total || heading.is_cumulative || heading.expands || heading.contracts;
}

/// Cuts the unit off: in brackets at the end, or after a comma. Remarks may stand on both sides of it, and stay.
std::string take_unit(std::string& text) {
    std::string unit, remarks;
    for (;;) {
        const bool has_brackets = text.ends_with(']') || text.ends_with(')');
        const std::size_t open = has_brackets ? text.find_last_of("[(") : text.find_last_of(',');
        if (open == std::string::npos || open == 0) {
            break;
        }
        const std::string part(
            io::trimmed(std::string_view(text).substr(open + 1, text.size() - open - (has_brackets ? 2 : 1)))
        );
        std::vector<std::string> words = words_of(part);
        TestHeading remark;
        if (take_remarks(words, remark)) {
            const bool is_minus = part.starts_with('-') || part.ends_with('-') || part.ends_with(" -ve");
            remarks += " " + part + (is_minus ? " negative" : "");
        } else if (unit.empty()) {
            unit = part;
        } else {
            break;
        }
        text = std::string(io::trimmed(std::string_view(text).substr(0, open)));
    }
    text += remarks;
    return unit;
}

std::string joined(const std::vector<std::string>& words, std::size_t begin, std::size_t end) {
    std::string text;
    for (std::size_t k = begin; k < end; ++k) {
        text += words[k];
    }
    return text;
}

std::optional<Quantity> quantity_named(std::string_view word, TestKind kind) {
    for (const QuantityRow& row : quantity_rows()) {
        const bool is_measured = std::ranges::find(row.tests, kind) != row.tests.end();
        if (is_measured && std::ranges::find(row.words, word) != row.words.end()) {
            return row.quantity;
        }
    }
    return std::nullopt;
}

/// All words together, or a name with its symbol before or behind it.
std::optional<Quantity> quantity_of(const std::vector<std::string>& words, TestKind kind) {
    const std::size_t n = words.size();
    if (const auto whole = quantity_named(joined(words, 0, n), kind); whole || n < 2) {
        return whole;
    }
    for (const std::size_t cut : {n - 1, std::size_t{1}}) {
        const auto first = quantity_named(joined(words, 0, cut), kind),
                   last = quantity_named(joined(words, cut, n), kind);
        if (first && first == last) {
            return first;
        }
    }
    return std::nullopt;
}

/// "sigma1 + sigma3", "sigma1'/sigma3'": of two quantities something else than their difference.
bool is_sum_or_ratio(std::string_view text, TestKind kind) {
    constexpr std::string_view signs = "+/*:&";
    for (std::size_t at = text.find_first_of(signs); at != std::string_view::npos;
         at = text.find_first_of(signs, at + 1)) {
        std::vector<std::string> before = words_of(text.substr(0, at)), after = words_of(text.substr(at + 1));
        if (before.empty() || after.empty()) {
            continue;
        }
        std::erase(before.back(), '\''), std::erase(after.front(), '\'');
        const auto first = quantity_named(before.back(), kind), second = quantity_named(after.front(), kind);
        if (first && second && first != second) {
            return true;
        }
    }
    return false;
}

} // namespace

TestHeading read_test_heading(std::string_view text, TestKind kind) {
    TestHeading heading;
    std::string rest = with_latin_letters(io::trimmed(text));
    heading.unit = take_unit(rest);
    std::vector<std::string> words = words_of(rest);
    for (std::string& word : words) {
        heading.is_effective = std::erase(word, '\'') > 0 || heading.is_effective;
    }
    take_remarks(words, heading);
    heading.quantity = is_sum_or_ratio(rest, kind) ? std::nullopt : quantity_of(words, kind);
    if (!heading.quantity && heading.unit.empty() && words.size() > 1) { // q_kPa
        const std::string_view last = std::string_view(rest).substr(rest.find_last_of("_ ") + 1);
        const auto before = quantity_of({words.begin(), words.end() - 1}, kind);
        if (before && unit_in_si(last, row_of(*before).dimension)) {
            heading.quantity = before;
            heading.unit = std::string(last);
        }
    }
    const std::string all = joined(words, 0, words.size());
    if (kind == TestKind::Triaxial && (all == "t" || all == "s") && unit_in_si(heading.unit, dimension::pressure)) {
        heading.quantity = all == "t" ? Quantity::DeviatorStress : Quantity::MeanStress;
        heading.is_half = true;
    }
    heading.names_tests = !heading.quantity && std::ranges::find(name_words(), all) != name_words().end();
    return heading;
}

std::optional<double> unit_in_si(std::string_view unit, Dimension wanted) {
    constexpr std::array list{Replacement{"\u00b2", "2"},   Replacement{"\u00b3", "3"}, Replacement{"\u00b7", "*"},
                              Replacement{"mL", "cm3"},     Replacement{"ml", "cm3"},   Replacement{"sec", "s"},
                              Replacement{"hours", "h"},    Replacement{"hour", "h"},   Replacement{"days", "day"},
                              Replacement{"minutes", "min"}};
    std::string plain = replaced(io::trimmed(unit), list);
    if (wanted == dimension::none && plain == "-") {
        return 1;
    }
    if (plain.starts_with("L/") || plain.starts_with("l/")) { // liters
        plain.replace(0, 1, "dm3");
    }
    try {
        return parse_unit(plain, wanted);
    } catch (const UnitError&) {
        return std::nullopt;
    }
}

} // namespace suffuse::laboratory
