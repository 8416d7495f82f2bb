#include "suffuse/io/grading_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace suffuse::io {

namespace {

/// What a column of this name holds; the name in small letters, without blanks and marks.
Meaning meaning_of(const std::string& name) {
    constexpr std::array sizes{
        "d",         "diameter",     "size",     "grainsize", "particlesize",  "graindiameter",   "sieve",
        "sievesize", "sieveopening", "aperture", "opening",   "sieveaperture", "particlediameter"};
    constexpr std::array shares{"passing",         "finer",         "passingbymass",     "finerbymass",
                                "passingbyweight", "finerbyweight", "cumulativepassing", "cumulativefiner"};
    const std::string plain = name.starts_with("percent") ? name.substr(7) : name;
    if (std::find(sizes.begin(), sizes.end(), name) != sizes.end()) {
        return Meaning::Size;
    }
    if (std::find(shares.begin(), shares.end(), plain) != shares.end()) {
        return Meaning::Passing;
    }
    const bool is_retained = name.find("retained") != std::string::npos;
    const auto says = [&](const char* word) { return name.find(word) != std::string::npos; };
    return !is_retained                                              ? Meaning::Other
           : says("cumul")                                           ? Meaning::CumulativeRetained
           : says("onsieve") || says("oneach") || says("individual") ? Meaning::RetainedOnSieve
                                                                     : Meaning::Retained;
}

/// The last word of a heading, where that is a unit: of "d_mm", "passing percent". @return it and what stands before.
std::pair<std::string_view, std::string_view> split_last_word(std::string_view text) {
    constexpr std::array units{"mm", "um", "µm", "cm", "m", "percent", "pct", "g", "kg"};
    text = text.substr(0, text.find_last_not_of(' ') + 1);
    const std::size_t blank = text.find_last_of(" _");
    if (blank == std::string_view::npos) {
        return {"", text};
    }
    const std::string_view word = text.substr(blank + 1);
    return std::find(units.begin(), units.end(), word) == units.end() ? std::pair{std::string_view(), text}
                                                                      : std::pair{word, text.substr(0, blank)};
}

/// "Sieve size (mm)" -> its name in small letters and its unit; "% passing" and "d_mm" have one too.
std::pair<std::string, std::string> split_heading(std::string_view text) {
    std::string name, unit;
    const std::size_t open = text.find_first_of("[(");
    const std::size_t close = open == std::string_view::npos ? open : text.find(text[open] == '[' ? ']' : ')', open);
    if (close != std::string_view::npos) {
        unit = trimmed(text.substr(open + 1, close - open - 1));
        text = text.substr(0, open);
    } else {
        const auto [word, rest] = split_last_word(text);
        unit = word.starts_with('p') ? "%" : std::string(word);
        text = rest;
    }
    for (const char c : text) {
        if (c == '%') {
            unit = unit.empty() ? "%" : unit;
        } else if (std::string_view(" _-.:").find(c) == std::string_view::npos) {
            name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        }
    }
    return {name, unit == "-" ? "1" : unit};
}

bool is_unit_of(Dimension wanted, const std::string& unit) {
    try {
        parse_quantity("1 " + unit, wanted);
        return true;
    } catch (const UnitError&) {
        return false;
    }
}

/// The unit in a spelling that is known: "MM" can only be mm.
std::optional<std::string>
known_unit(const CsvCell& heading, const std::string& unit, Dimension wanted, Problems& problems) {
    std::string small = unit;
    std::transform(small.begin(), small.end(), small.begin(), [](char c) {
        return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    });
    if (is_unit_of(wanted, small) && !is_unit_of(wanted, unit)) {
        return small;
    }
    try {
        parse_quantity("1 " + unit, wanted);
        return unit;
    } catch (const UnitError& problem) {
        problems.error(
            "E506", heading.place, fmt::format("the column `{}`: {}", heading.text, problem.what()), problem.help
        );
        return std::nullopt;
    }
}

class HeaderReader {
public:
    explicit HeaderReader(Problems& problems) : problems_(problems) {}

    std::optional<Columns> read(const CsvRow& header) {
        bool is_good = true;
        for (std::size_t k = 0; k < header.cells.size(); ++k) {
            const auto [name, unit] = split_heading(header.cells[k].text);
            is_good = take(header.cells[k], k, meaning_of(name), unit) && is_good;
        }
        if (!is_good) {
            return std::nullopt;
        }
        for (const auto& [column, meaning] :
             {std::pair{&passing_, Meaning::Passing},
              {&retained_, Meaning::CumulativeRetained},
              {&on_sieve_, Meaning::RetainedOnSieve}}) {
            if (size_ && *column) {
                return Columns{*size_, **column, meaning};
            }
        }
        complain_about_missing(header);
        return std::nullopt;
    }

private:
    bool take(const CsvCell& cell, std::size_t index, Meaning meaning, const std::string& unit) {
        if (meaning == Meaning::Other || meaning == Meaning::Retained) {
            has_plain_retained_ = has_plain_retained_ || meaning == Meaning::Retained;
            return true;
        }
        const bool is_size = meaning == Meaning::Size;
        std::optional<Column>& column = is_size                                  ? size_
                                        : meaning == Meaning::Passing            ? passing_
                                        : meaning == Meaning::CumulativeRetained ? retained_
                                                                                 : on_sieve_;
        if (column) {
            problems_.error(
                "E506", cell.place, fmt::format("`{}` and `{}` mean the same", column->name, cell.text),
                "leave one of the two columns, or give the other one a name that is not read"
            );
            return false;
        }
        column = Column{index, cell.text, is_size ? "mm" : "%", !unit.empty()};
        column->dimension = is_size ? dimension::length : dimension::none;
        if (unit.empty()) {
            return true;
        }
        if (!is_size && meaning != Meaning::Passing && is_unit_of(dimension::mass, unit)) {
            column->dimension = dimension::mass;
        }
        const auto known = known_unit(cell, unit, column->dimension, problems_);
        column->unit = known.value_or("");
        return known.has_value();
    }

    void complain_about_missing(const CsvRow& header) {
        if (size_ && has_plain_retained_) {
            problems_.error(
                "E506", header.place, "retained: on each sieve alone, or on it and all coarser ones?",
                "name the column `retained on sieve [%]` or `cumulative retained [%]`, with [g] where masses were "
                "weighed"
            );
            return;
        }
        problems_.error(
            "E506", header.place,
            fmt::format(
                "a grading curve needs a column of sizes and one of percent passing, and `{}` is missing",
                size_ ? "passing" : "d"
            ),
            std::string(expected_header)
        );
    }

    Problems& problems_;
    std::optional<Column> size_, passing_, retained_, on_sieve_;
    bool has_plain_retained_ = false;
};

} // namespace

std::optional<Columns> read_grading_header(const CsvRow& header, Problems& problems) {
    return HeaderReader(problems).read(header);
}

} // namespace suffuse::io
