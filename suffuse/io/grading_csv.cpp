#include "suffuse/io/grading_csv.hpp"

#include "suffuse/io/grading_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <string>

namespace suffuse::io {

namespace {

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

    std::optional<double> read(const CsvCell& cell, const Column& column) {
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
                return parse_quantity(text + " " + column.unit, column.dimension);
            }
            const bool is_same = text.ends_with(column.unit);
            if (is_same || (!column.names_unit && column.each_has_own)) {
                return parse_quantity(text, column.dimension);
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

/// From masses to shares of the whole sample, which only the pan completes. @return whether they can be.
bool divide_by_total(
    std::vector<GradingPoint>& points, Meaning meaning, const std::optional<double>& pan, const Place& end,
    Problems& problems
) {
    if (!pan) {
        problems.error(
            "E504", end, "masses retained, and no line `pan`: of what mass are they a share?",
            "add `pan` and the mass that passed the finest sieve, 0 where nothing did; in a cumulative column the mass "
            "of the whole sample"
        );
        return false;
    }
    double total = *pan;
    bool is_good = true;
    for (const GradingPoint& point : points) {
        total += meaning == Meaning::RetainedOnSieve ? point.passing : 0;
        is_good = is_good && point.passing >= 0;
    }
    is_good = is_good && *pan >= 0 && total > 0 && std::isfinite(total);
    if (!is_good) {
        problems.error("E504", end, "the masses retained are no part of a mass", "masses are 0 or more, and not all 0");
        return false;
    }
    for (GradingPoint& point : points) {
        point.passing /= total;
    }
    return true;
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

bool check_width(const CsvTable& table, std::size_t row, Problems& problems) {
    const std::size_t found = table.rows[row].cells.size(), columns = table.rows[0].cells.size();
    if (found == columns) {
        return true;
    }
    problems.error(
        "E502", table.rows[row].place,
        fmt::format("{} value{} where the header names {} columns", found, found == 1 ? "" : "s", columns),
        table.mark == ','
            ? "one value for each column; where numbers have a decimal comma, columns are separated by ; as "
              "in 0,063;12,5, the header too"
            : "one value for each column"
    );
    return false;
}

} // namespace

std::optional<std::vector<GradingPoint>>
read_grading_points(const std::shared_ptr<const Source>& source, Problems& problems) {
    const CsvTable table = split_rows(source);
    if (table.rows.empty()) {
        problems.error("E505", {source, 0, 0, 1}, "the file is empty", std::string(expected_header));
        return std::nullopt;
    }
    auto columns = read_grading_header(table.rows[0], problems);
    if (!columns) {
        return std::nullopt;
    }
    NumberReader numbers(table, *columns, problems);
    const bool is_retained = columns->meaning != Meaning::Passing,
               has_masses = columns->share.dimension == dimension::mass;
    std::vector<GradingPoint> points;
    std::optional<double> pan;
    bool is_good = true;
    for (std::size_t k = 1; k < table.rows.size(); ++k) {
        if (!check_width(table, k, problems)) {
            is_good = false;
            continue;
        }
        const CsvCell &size = table.rows[k].cells[columns->size.index],
                      &share = table.rows[k].cells[columns->share.index];
        if (is_retained && is_pan(size)) { // of percents it is what is left when all sieves have theirs
            pan = has_masses ? numbers.read(share, columns->share) : 0;
            is_good = is_good && pan;
            continue;
        }
        const auto diameter = numbers.read(size, columns->size);
        const auto found = numbers.read(share, columns->share);
        is_good = is_good && diameter && found;
        if (diameter && found) {
            points.push_back({*diameter, *found, size.place, share.place});
        }
    }
    if (!is_good ||
        (has_masses && !divide_by_total(points, columns->meaning, pan, table.rows.back().place, problems))) {
        return std::nullopt;
    }
    if (columns->meaning == Meaning::RetainedOnSieve) {
        add_up(points);
    }
    for (GradingPoint& point : points) {
        point.passing = columns->meaning == Meaning::CumulativeRetained ? 1 - point.passing : point.passing;
    }
    return points;
}

} // namespace suffuse::io
