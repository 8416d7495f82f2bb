#include "suffuse/laboratory/read_test.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/read_text.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/gradings/sheet.hpp"
#include "suffuse/gradings/sheet_text.hpp"
#include "suffuse/gradings/sheet_values.hpp"
#include "suffuse/gradings/sieve_size.hpp"
#include "suffuse/gradings/thousands.hpp"
#include "suffuse/laboratory/test_conventions.hpp"
#include "suffuse/laboratory/test_heading.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace suffuse::laboratory {
namespace {

using gradings::Sheet;
using gradings::SheetRow;

[[noreturn]] void complain(const Place& place, const std::string& message) {
    throw CaseError(to_string(place) + ": " + message, place.source ? place.source->name : "", place.line);
}

/// A column of the sheet that is read.
struct ReadColumn {
    std::size_t at = 0;
    TestHeading heading;
    std::string text; ///< of the heading
};

/// The heading of a table and where its rows begin.
struct Head {
    std::vector<ReadColumn> columns;
    std::optional<std::size_t> names; ///< the column that names the tests
    std::vector<std::string> unread;
    std::size_t row = 0, first = 0; ///< of the heading, of the first reading
};

Head head_in(const SheetRow& row, TestKind kind) {
    constexpr std::size_t most = 2000; // columns
    if (row.cells.size() > most) {
        complain(row.place, fmt::format("found {} columns, expected at most {}", row.cells.size(), most));
    }
    Head head;
    for (std::size_t k = 0; k < row.cells.size(); ++k) {
        const std::string& text = row.cells[k].text;
        const TestHeading heading = read_test_heading(text, kind);
        if (heading.quantity) {
            head.columns.push_back({k, heading, shown(text)});
        } else if (heading.names_tests && !head.names) {
            head.names = k;
        } else if (!text.empty()) {
            head.unread.push_back(shown(text));
        }
    }
    return head;
}

/// The first row that names two quantities.
std::optional<Head> find_head(const Sheet& sheet, TestKind kind) {
    constexpr std::size_t looked_at = 100; // rows of titles
    for (std::size_t r = 0; r < std::min(sheet.rows.size(), looked_at); ++r) {
        Head head = head_in(sheet.rows[r], kind);
        if (head.columns.size() >= 2) {
            head.row = r;
            head.first = r + 1;
            return head;
        }
    }
    return std::nullopt;
}

/// A line of units below the heading: each is one of its column, and none is a number.
void take_units_below(const Sheet& sheet, Head& head) {
    if (head.first >= sheet.rows.size()) {
        return;
    }
    const SheetRow& row = sheet.rows[head.first];
    const auto unit_at = [&](const ReadColumn& c) {
        std::string_view text = gradings::text_at(row, c.at);
        if (text.size() > 2 && (text.front() == '[' || text.front() == '(')) {
            text = text.substr(1, text.size() - 2);
        }
        return std::string(text);
    };
    const bool are_units = std::ranges::all_of(head.columns, [&](const ReadColumn& c) {
        const std::string unit = unit_at(c);
        return !gradings::number_at(sheet, row, c.at) &&
               (unit.empty() || unit_in_si(unit, row_of(*c.heading.quantity).dimension));
    });
    if (!are_units) {
        return;
    }
    for (ReadColumn& c : head.columns) {
        const std::string unit = unit_at(c);
        if (!unit.empty() && !c.heading.unit.empty() && unit != c.heading.unit) {
            complain(
                gradings::place_at(row, c.at),
                fmt::format(
                    "found the unit {} below a heading with the unit {}; keep one", shown(unit), shown(c.heading.unit)
                )
            );
        }
        c.heading.unit = unit.empty() ? c.heading.unit : unit;
    }
    ++head.first;
}

std::string words_expected(TestKind kind) {
    std::vector<std::string_view> names;
    for (const QuantityRow& row : quantity_rows()) {
        if (std::ranges::find(row.tests, kind) != row.tests.end()) {
            names.push_back(row.name);
        }
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

TestColumn column_of(const Sheet& sheet, const Head& head, const ReadColumn& read) {
    const QuantityRow& row = row_of(*read.heading.quantity);
    TestColumn column;
    column.quantity = row.quantity;
    column.heading = read.text;
    column.unit = read.heading.unit;
    column.is_cumulative = read.heading.is_cumulative;
    column.is_half = read.heading.is_half;
    column.expands = read.heading.expands;
    column.contracts = read.heading.contracts;
    if (read.heading.is_effective || read.heading.is_total) {
        column.is_effective = read.heading.is_effective;
    }
    if (!column.unit.empty()) {
        const auto factor = unit_in_si(column.unit, row.dimension);
        if (!factor) {
            complain(
                gradings::place_at(sheet.rows[head.row], read.at),
                fmt::format(
                    "column \"{}\": found the unit \"{}\", expected one of {}, such as {}", read.text,
                    shown(column.unit), row.name, row.usual_unit
                )
            );
        }
        column.factor = *factor;
    } else if (row.dimension != dimension::none) {
        complain(
            gradings::place_at(sheet.rows[head.row], read.at),
            fmt::format("column \"{0}\" has no unit; write it in the heading: {0} [{1}]", read.text, row.usual_unit)
        );
    }
    return column;
}

/// Above these no soil test goes [SI].
double largest_of(const QuantityRow& row) {
    constexpr double strain = 1, void_ratio = 20, gradient = 1e3, pressure = 1e8; // void ratio: of fresh mud or peat
    switch (row.quantity) {
    case Quantity::AxialStrain:
    case Quantity::VolumetricStrain:
        return strain;
    case Quantity::VoidRatio:
        return void_ratio;
    case Quantity::Gradient:
        return gradient;
    default:
        return row.dimension == dimension::pressure ? pressure : std::numeric_limits<double>::infinity();
    }
}

/// A strain without a unit may be in percent.
double largest_number(const TestColumn& column) {
    const QuantityRow& row = row_of(column.quantity);
    const bool may_be_percent = column.unit.empty() && row.usual_unit == "%";
    return largest_of(row) / (may_be_percent ? 0.01 : column.factor);
}

/// "1,250" may be 1250 or 1.25. Other numbers of the sheet decide, or the quantity does.
void settle_thousands(Sheet& sheet, const Head& head, TestRecord& record) {
    const char sign = gradings::find_decimal_sign(sheet);
    for (std::size_t k = 0; k < head.columns.size(); ++k) {
        const ReadColumn& read = head.columns[k];
        const TestColumn& column = record.columns[k];
        const auto found = gradings::find_grouped(sheet, head.first, read.at);
        if (!found || sign == found->mark || found->value(true) > largest_number(column)) {
            continue;
        }
        if (sign == 0) {
            complain(
                found->cell.place,
                fmt::format(
                    "column \"{}\": \"{}\" may be {} or {}; write {} if the mark is between thousands, else {}",
                    read.text, shown(found->cell.text), found->plain(true), found->plain(false), found->plain(true),
                    found->plain(false)
                )
            );
        }
        record.findings.push_back(
            {false, fmt::format(
                        "\"{}\" in \"{}\" is {}: other numbers have a decimal {}", shown(found->cell.text), read.text,
                        found->plain(true), sign == '.' ? "point" : "comma"
                    )}
        );
        gradings::join_groups(sheet, head.first, read.at, found->mark);
    }
}

/// Nothing may stand next to a number: a unit in a cell could be another than that of its column.
std::optional<double> number_in(const Sheet& sheet, const SheetRow& row, std::size_t column) {
    const bool is_quoted = column < row.cells.size() && row.cells[column].is_quoted;
    return gradings::plain_number(gradings::text_at(row, column), gradings::commas_are_decimal(sheet) || is_quoted);
}

bool is_empty(const SheetRow& row) {
    return row.is_comment || std::ranges::all_of(row.cells, [](const gradings::SheetCell& cell) {
               return gradings::is_blank(cell.text);
           });
}

/// Tests follow one another; a name that comes back would be two tests, or one in two parts.
class TestNames {
public:
    explicit TestNames(std::string file) : file_(std::move(file)) {}

    void add(const SheetRow& row, const Head& head, TestRecord& record) {
        const std::size_t at = record.rows();
        const std::string name = head.names ? gradings::text_at(row, *head.names) : file_;
        const bool goes_on = !record.tests.empty() && (record.tests.back().name == name || name.empty());
        if (!goes_on) {
            if (!seen_.insert(name).second) {
                complain(
                    gradings::place_at(row, head.names.value_or(0)),
                    fmt::format("test \"{}\" goes on behind another one; sort the rows by tests", shown(name))
                );
            }
            record.tests.push_back({name, at, at});
        }
        record.tests.back().end = at + 1;
    }

private:
    std::string file_;
    std::set<std::string> seen_;
};

void read_rows(const Sheet& sheet, const Head& head, const std::string& name, TestRecord& record) {
    TestNames names(name);
    for (std::size_t r = head.first; r < sheet.rows.size(); ++r) {
        const SheetRow& row = sheet.rows[r];
        if (is_empty(row)) {
            continue;
        }
        names.add(row, head, record);
        for (std::size_t k = 0; k < head.columns.size(); ++k) {
            const auto value = number_in(sheet, row, head.columns[k].at);
            if (!value || !std::isfinite(*value)) {
                complain(
                    gradings::place_at(row, head.columns[k].at),
                    fmt::format(
                        "column \"{}\": found \"{}\", expected a number", head.columns[k].text,
                        shown(gradings::text_at(row, head.columns[k].at))
                    )
                );
            }
            TestColumn& column = record.columns[k];
            if (const double most = largest_number(column); std::abs(*value) > most) {
                const std::string unit = column.unit.empty() || column.unit == "-" ? "" : " " + column.unit;
                complain(
                    gradings::place_at(row, head.columns[k].at),
                    fmt::format(
                        "column \"{}\": found {:g}{}, and no {} of a soil exceeds {:g}{}; correct the number, or the "
                        "unit of the column",
                        head.columns[k].text, *value, unit, row_of(column.quantity).name, most, unit
                    )
                );
            }
            column.values.push_back(*value * column.factor);
        }
    }
}

void check_columns(const TestRecord& record, const Place& place) {
    std::set<Quantity> seen;
    for (const TestColumn& column : record.columns) {
        if (!seen.insert(column.quantity).second) {
            complain(place, fmt::format("two columns are {}; remove one", row_of(column.quantity).name));
        }
    }
    const auto need = [&](std::initializer_list<Quantity> one_of) {
        if (std::ranges::none_of(one_of, [&](Quantity q) { return seen.contains(q); })) {
            std::vector<std::string_view> words;
            words.reserve(one_of.size());
            for (const Quantity q : one_of) {
                words.push_back(row_of(q).name);
            }
            complain(
                place, fmt::format(
                           "{} {} test has a column of {}; found none", record.kind == TestKind::Oedometer ? "an" : "a",
                           test_kind_names()[static_cast<std::size_t>(record.kind)], fmt::join(words, " or ")
                       )
            );
        }
    };
    switch (record.kind) {
    case TestKind::Triaxial:
        need({Quantity::AxialStrain});
        need({Quantity::DeviatorStress, Quantity::AxialStress});
        break;
    case TestKind::Oedometer:
        need({Quantity::AxialStress});
        need({Quantity::AxialStrain, Quantity::VoidRatio});
        break;
    case TestKind::Permeameter:
        need({Quantity::Gradient, Quantity::HeadDifference});
        need({Quantity::Discharge, Quantity::Velocity, Quantity::Mass});
        break;
    }
}

/// Of the marks of the text the first with which a heading is found.
std::pair<Sheet, Head> find_table(const std::shared_ptr<const Source>& text, TestKind kind) {
    for (const char mark : gradings::possible_marks(text->text)) {
        Sheet sheet = gradings::split_sheet(text, mark);
        if (auto head = find_head(sheet, kind)) {
            return {std::move(sheet), std::move(*head)};
        }
    }
    constexpr std::array examples{Quantity::AxialStrain, Quantity::AxialStress, Quantity::Discharge}; // by kind
    const QuantityRow& example = row_of(examples[static_cast<std::size_t>(kind)]);
    throw CaseError(
        fmt::format(
            "{}: found no heading with two of: {}; write one above the numbers, such as \"{} [{}]\"", text->name,
            words_expected(kind), example.name, example.usual_unit
        ),
        text->name
    );
}

} // namespace

TestRecord parse_test(const std::shared_ptr<const Source>& source, const TestRequest& request) {
    Problems problems;
    const auto text = gradings::decode_sheet(source, problems);
    if (!text) {
        throw CaseProblems(problems.sorted());
    }
    auto [sheet, head] = find_table(text, request.kind);
    take_units_below(sheet, head);
    TestRecord record;
    record.kind = request.kind;
    record.unread = head.unread;
    for (std::size_t r = 0; r < head.row; ++r) {
        record.titles.push_back(shown(line_of(*text, sheet.rows[r].place.line)));
    }
    for (const ReadColumn& column : head.columns) {
        record.columns.push_back(column_of(sheet, head, column));
    }
    check_columns(record, sheet.rows[head.row].place);
    settle_thousands(sheet, head, record);
    read_rows(sheet, head, std::filesystem::path(source->name).stem().string(), record);
    if (record.rows() == 0) {
        complain(sheet.rows[head.row].place, "found no row of numbers below the heading");
    }
    find_conventions(record, source->name, request.contraction_is_positive);
    return record;
}

TestRecord read_test(const std::filesystem::path& path, const TestRequest& request) {
    return parse_test(std::make_shared<const Source>(Source{path.string(), read_whole_file(path.string())}), request);
}

} // namespace suffuse::laboratory
