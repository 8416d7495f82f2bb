#include "suffuse/casefile/grading_csv.hpp"

#include "suffuse/base/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <string>
#include <string_view>

namespace suffuse::casefile {

namespace {

struct CsvCell {
    std::string text; ///< without blanks and quotes around it
    Place place;
};

struct CsvRow {
    std::vector<CsvCell> cells;
    Place place;
};

struct CsvTable {
    std::vector<CsvRow> rows; ///< those that hold something
    char mark = ',';          ///< between columns
};

/// `Retained` does not say whether on the sieve alone or on it and all coarser ones.
enum class Meaning { Other, Size, Passing, CumulativeRetained, RetainedOnSieve, Retained };

struct Column {
    std::size_t index = 0;
    std::string name; ///< as written
    std::string unit;
    bool names_unit = false;   ///< false: the usual one
    bool each_has_own = false; ///< a unit stands at every number
};

struct Columns {
    Column size, share;
    Meaning meaning = Meaning::Passing; ///< of the share
};

constexpr std::string_view expected_header = "the first line names the columns: `d [mm],passing [%]`; also size, sieve "
                                             "or diameter, and finer, cumulative retained or retained on sieve";
constexpr std::string_view blanks = " \t\r";

int count_characters(std::string_view text) {
    return static_cast<int>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    }));
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = std::min(text.find_first_not_of(blanks), text.size());
    text.remove_prefix(first);
    return text.substr(0, text.find_last_not_of(blanks) + 1);
}

/// The first of these outside of quotes.
std::size_t find_outside_quotes(std::string_view text, std::string_view marks, std::size_t begin = 0) {
    bool is_quoted = false;
    for (std::size_t k = begin; k < text.size(); ++k) {
        is_quoted = is_quoted != (text[k] == '"');
        if (!is_quoted && marks.find(text[k]) != std::string_view::npos) {
            return k;
        }
    }
    return text.size();
}

CsvRow split_line(const std::shared_ptr<const Source>& source, std::string_view line, int number, char mark) {
    CsvRow row;
    row.place = {source, number, 1, std::max(1, count_characters(line))};
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = find_outside_quotes(line, std::string_view(&mark, 1), begin);
        std::string_view text = trimmed(line.substr(begin, end - begin));
        const auto first = static_cast<std::size_t>(text.data() - line.data());
        const Place place{
            source, number, count_characters(line.substr(0, first)) + 1, std::max(1, count_characters(text))};
        if (text.size() > 1 && text.front() == '"' && text.back() == '"') {
            text = trimmed(text.substr(1, text.size() - 2));
        }
        row.cells.push_back({std::string(text), place});
        begin = end + 1;
    }
    return row;
}

/// The mark between columns is the first of ; and tab that the header has, else a comma. Empty cells at the end of a
/// line, where spreadsheets leave some, are dropped.
CsvTable split_rows(const std::shared_ptr<const Source>& source) {
    CsvTable table;
    int number = 0;
    const std::string_view text = source->text;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        std::string_view line = text.substr(begin, end - begin);
        begin = end + 1;
        ++number;
        line = line.substr(0, find_outside_quotes(line, "#"));
        line = line.substr(0, line.find_last_not_of(" \r") + 1);
        if (trimmed(line).empty()) {
            continue;
        }
        if (table.rows.empty()) {
            const std::size_t found = find_outside_quotes(line, ";\t");
            table.mark = found < line.size() ? line[found] : ',';
        }
        table.rows.push_back(split_line(source, line, number, table.mark));
        std::vector<CsvCell>& cells = table.rows.back().cells;
        const std::size_t columns = table.rows.front().cells.size();
        while (cells.size() > 1 && cells.back().text.empty() && (table.rows.size() == 1 || cells.size() > columns)) {
            cells.pop_back();
        }
    }
    return table;
}

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
    constexpr std::array units{"mm", "um", "µm", "cm", "m", "percent", "pct"};
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
        if (unit.empty()) {
            return true;
        }
        const auto known = known_unit(cell, unit, is_size ? dimension::length : dimension::none, problems_);
        column->unit = known.value_or("");
        return known.has_value();
    }

    void complain_about_missing(const CsvRow& header) {
        if (size_ && has_plain_retained_) {
            problems_.error(
                "E506", header.place, "percent retained: on each sieve alone, or on it and all coarser ones?",
                "name the column `retained on sieve [%]` or `cumulative retained [%]`; of masses write percent "
                "passing, "
                "100 minus what is retained on the sieve and on all coarser ones"
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

/// Numbers of a table: the decimal mark is one for all of them.
class NumberReader {
public:
    NumberReader(const CsvTable& table, Columns& columns, Problems& problems) : problems_(problems) {
        std::size_t own_sizes = 0, own_shares = 0;
        for (std::size_t k = 1; k < table.rows.size(); ++k) {
            const std::vector<CsvCell>& cells = table.rows[k].cells;
            if (cells.size() == table.rows[0].cells.size()) {
                own_sizes += look_at(cells[columns.size.index]) ? 1U : 0U;
                own_shares += look_at(cells[columns.share.index]) ? 1U : 0U;
            }
        }
        columns.size.each_has_own = own_sizes + 1 == table.rows.size();
        columns.share.each_has_own = own_shares + 1 == table.rows.size();
        separates_ = table.mark == ',';
    }

    std::optional<double> read(const CsvCell& cell, const Column& column, Dimension wanted) {
        std::string text = cell.text;
        if (const std::size_t comma = text.find(','); comma != std::string::npos) {
            if (separates_ || has_points_) {
                return complain(
                    cell, fmt::format("\"{}\" has a comma", text),
                    separates_ ? "commas separate the columns here: write a decimal point"
                               : "other numbers have a decimal point: write the same mark everywhere, and none between "
                                 "thousands"
                );
            }
            text[comma] = '.';
        }
        try {
            if (!parse_quantity(text).has_unit) {
                return parse_quantity(text + " " + column.unit, wanted);
            }
            const bool is_same = text.ends_with(column.unit);
            if (is_same || (!column.names_unit && column.each_has_own)) {
                return parse_quantity(text, wanted);
            }
        } catch (const UnitError& problem) {
            const std::string what = cell.text.empty() ? "a value is missing" : problem.what();
            return complain(
                cell, what.find("start with a number") == std::string::npos ? what : not_a_number(cell),
                plain_advice(column)
            );
        }
        return complain(cell, fmt::format("\"{}\" has its own unit", cell.text), plain_advice(column));
    }

private:
    /// Notes the decimal mark of a number. @return whether it has a unit of its own.
    bool look_at(const CsvCell& cell) {
        has_points_ = has_points_ || cell.text.find('.') != std::string::npos;
        return !cell.text.empty() && std::isdigit(static_cast<unsigned char>(cell.text.back())) == 0 &&
               cell.text.back() != '.';
    }

    static std::string not_a_number(const CsvCell& cell) { return fmt::format("\"{}\" is not a number", cell.text); }

    static std::string plain_advice(const Column& column) {
        return fmt::format("write a plain number; it is read in {}", column.unit == "1" ? "shares of 1" : column.unit);
    }

    std::optional<double> complain(const CsvCell& cell, const std::string& what, const std::string& advice) {
        problems_.error("E502", cell.place, what, advice);
        return std::nullopt;
    }

    Problems& problems_;
    bool has_points_ = false, separates_ = true;
};

bool is_pan(const CsvCell& size) {
    return size.text == "pan" || size.text == "Pan" || size.text == "PAN";
}

/// From what each sieve retains to what passes it: all that neither it nor a coarser one retains.
void add_up(std::vector<GradingPoint>& points) {
    constexpr double rounding = 0.01; // of percentages that should add up to 100
    std::vector<GradingPoint*> coarsest_first;
    for (GradingPoint& point : points) {
        coarsest_first.push_back(&point);
    }
    std::ranges::sort(coarsest_first, std::greater{}, &GradingPoint::diameter);
    double retained = 0;
    for (GradingPoint* point : coarsest_first) {
        retained += point->passing;
        const double passing = 1 - retained;
        point->passing = passing < 1e-9 && passing > -rounding ? 0 : passing;
    }
}

} // namespace

std::optional<std::vector<GradingPoint>>
read_grading_points(const std::shared_ptr<const Source>& source, Problems& problems) {
    const CsvTable table = split_rows(source);
    if (table.rows.empty()) {
        problems.error("E505", {source, 0, 0, 1}, "the file is empty", std::string(expected_header));
        return std::nullopt;
    }
    auto columns = HeaderReader(problems).read(table.rows[0]);
    if (!columns) {
        return std::nullopt;
    }
    NumberReader numbers(table, *columns, problems);
    std::vector<GradingPoint> points;
    bool is_good = true;
    for (std::size_t k = 1; k < table.rows.size(); ++k) {
        const std::vector<CsvCell>& cells = table.rows[k].cells;
        if (cells.size() != table.rows[0].cells.size()) {
            problems.error(
                "E502", table.rows[k].place,
                fmt::format(
                    "{} value{} where the header names {} columns", cells.size(), cells.size() == 1 ? "" : "s",
                    table.rows[0].cells.size()
                ),
                table.mark == ',' ? "one value for each column; where numbers have a decimal comma, columns are "
                                    "separated by ; as in 0,063;12,5, the header too"
                                  : "one value for each column"
            );
            is_good = false;
            continue;
        }
        const CsvCell &size = cells[columns->size.index], &share = cells[columns->share.index];
        if (columns->meaning == Meaning::RetainedOnSieve && is_pan(size)) {
            continue; // what is left when all sieves have theirs
        }
        const auto diameter = numbers.read(size, columns->size, dimension::length);
        const auto found = numbers.read(share, columns->share, dimension::none);
        is_good = is_good && diameter && found;
        if (diameter && found) {
            const bool is_cumulative = columns->meaning == Meaning::CumulativeRetained;
            points.push_back({*diameter, is_cumulative ? 1 - *found : *found, size.place, share.place});
        }
    }
    if (columns->meaning == Meaning::RetainedOnSieve) {
        add_up(points);
    }
    return is_good ? std::optional(std::move(points)) : std::nullopt;
}

} // namespace suffuse::casefile
