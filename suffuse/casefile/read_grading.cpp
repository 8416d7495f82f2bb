#include "suffuse/casefile/read_grading.hpp"

#include "suffuse/base/units.hpp"
#include "suffuse/casefile/read_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::casefile {

namespace {

struct CsvCell {
    std::string text; ///< without blanks around it
    Place place;
};

struct CsvRow {
    std::vector<CsvCell> cells;
    Place place;
};

/// Which column holds what, and in which unit.
struct Columns {
    std::size_t diameter = 0, passing = 0;
    std::string diameter_unit = "mm", passing_unit = "%";
};

constexpr std::string_view expected_header = "the first line names the columns: `d [mm],passing [%]`";

int count_characters(std::string_view text) {
    return static_cast<int>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    }));
}

std::vector<CsvCell>
split_line(const std::shared_ptr<const Source>& source, std::string_view line, int number, char mark) {
    std::vector<CsvCell> cells;
    std::size_t begin = 0;
    while (begin <= line.size()) {
        const std::size_t end = std::min(line.find(mark, begin), line.size());
        std::size_t first = begin, last = end;
        while (first < last && (line[first] == ' ' || line[first] == '\t')) {
            ++first;
        }
        while (last > first && (line[last - 1] == ' ' || line[last - 1] == '\t')) {
            --last;
        }
        const std::string_view text = line.substr(first, last - first);
        cells.push_back(
            {std::string(text),
             {source, number, count_characters(line.substr(0, first)) + 1, std::max(1, count_characters(text))}}
        );
        begin = end + 1;
    }
    return cells;
}

/// Rows that hold something; the mark between columns is the first of , ; tab that the header has.
std::vector<CsvRow> split_rows(const std::shared_ptr<const Source>& source) {
    std::vector<CsvRow> rows;
    char mark = 0;
    int number = 0;
    const std::string_view text = source->text;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        std::string_view line = text.substr(begin, end - begin);
        begin = end + 1;
        ++number;
        line = line.substr(0, line.find('#'));
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t')) {
            line.remove_suffix(1);
        }
        if (line.find_first_not_of(" \t") == std::string_view::npos) {
            continue;
        }
        if (mark == 0) {
            const std::size_t found = line.find_first_of(",;\t");
            mark = found == std::string_view::npos ? ',' : line[found];
        }
        rows.push_back(
            {split_line(source, line, number, mark), {source, number, 1, std::max(1, count_characters(line))}}
        );
    }
    return rows;
}

std::optional<Columns> read_header(const CsvRow& header, Problems& problems) {
    Columns columns;
    bool has_diameter = false, has_passing = false;
    for (std::size_t k = 0; k < header.cells.size(); ++k) {
        const CsvCell& cell = header.cells[k];
        const std::size_t open = cell.text.find('[');
        const std::size_t close = cell.text.find(']', open == std::string::npos ? 0 : open);
        std::string name = cell.text.substr(0, open);
        name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
        const bool has_unit = open != std::string::npos && close != std::string::npos;
        const std::string unit = has_unit ? cell.text.substr(open + 1, close - open - 1) : std::string();
        const bool is_diameter = name == "d" || name == "diameter" || name == "size";
        const bool is_passing = name == "passing";
        if (!is_diameter && !is_passing) {
            continue;
        }
        (is_diameter ? has_diameter : has_passing) = true;
        (is_diameter ? columns.diameter : columns.passing) = k;
        if (!has_unit) {
            continue;
        }
        (is_diameter ? columns.diameter_unit : columns.passing_unit) = unit == "-" ? "1" : unit;
        try {
            parse_quantity(
                "1 " + std::string(unit == "-" ? "1" : unit), is_diameter ? dimension::length : dimension::none
            );
        } catch (const UnitError& problem) {
            problems.error(
                "E506", cell.place, fmt::format("the column `{}`: {}", cell.text, problem.what()), problem.help
            );
            return std::nullopt;
        }
    }
    if (has_diameter && has_passing) {
        return columns;
    }
    problems.error(
        "E506", header.place,
        fmt::format(
            "a grading curve needs a column of sizes and one of percent passing, and `{}` is missing",
            has_diameter ? "passing" : "d"
        ),
        std::string(expected_header)
    );
    return std::nullopt;
}

std::optional<double>
read_value(const CsvCell& cell, const std::string& unit, Dimension dimension, Problems& problems) {
    std::string what;
    try {
        if (!parse_quantity(cell.text).has_unit) {
            return parse_quantity(cell.text + " " + unit, dimension);
        }
        what = fmt::format("\"{}\" has its own unit", cell.text);
    } catch (const UnitError&) {
        what = cell.text.empty() ? "a value is missing" : fmt::format("\"{}\" is not a number", cell.text);
    }
    problems.error(
        "E502", cell.place, what,
        fmt::format("write a plain number with a decimal point; it is read in {}", unit == "1" ? "shares of 1" : unit)
    );
    return std::nullopt;
}

std::string in_mm(double diameter) {
    return fmt::format("{:.6g} mm", diameter * 1e3);
}

std::string in_percent(double passing) {
    return fmt::format("{:.6g} %", passing * 100);
}

bool check_values(const std::vector<GradingPoint>& points, Problems& problems) {
    bool is_good = true;
    for (const GradingPoint& point : points) {
        if (!(point.diameter > 0)) {
            problems.error(
                "E504", point.diameter_place, fmt::format("a grain size of {}", in_mm(point.diameter)),
                "sizes are above 0"
            );
            is_good = false;
        }
        if (!(point.passing >= 0 && point.passing <= 1)) {
            problems.error(
                "E504", point.passing_place, fmt::format("{} passing", in_percent(point.passing)),
                "percent passing is between 0 and 100"
            );
            is_good = false;
        }
    }
    return is_good;
}

/// Points with sizes rising.
bool check_order(const std::vector<GradingPoint>& points, Problems& problems) {
    bool is_good = true;
    for (std::size_t k = 1; k < points.size(); ++k) {
        const GradingPoint &below = points[k - 1], &point = points[k];
        if (!(point.diameter > below.diameter)) {
            problems.error(
                "E503", point.diameter_place,
                fmt::format(
                    "the grading is not monotonic: {} stands beside {}", in_mm(point.diameter), in_mm(below.diameter)
                ),
                "sizes must rise from line to line, or fall from line to line, each once"
            );
            is_good = false;
        } else if (point.passing < below.passing) {
            problems.error(
                "E503", point.passing_place,
                fmt::format(
                    "the grading is not monotonic: {} passes {}, but {} passes the smaller {}",
                    in_percent(point.passing), in_mm(point.diameter), in_percent(below.passing), in_mm(below.diameter)
                ),
                "percent passing cannot fall as the size grows"
            );
            is_good = false;
        }
    }
    return is_good;
}

/// Curves that no soil has, but one whose unit was forgotten.
bool check_units(const std::vector<GradingPoint>& points, Problems& problems) {
    constexpr double stones = 0.06, least_end = 0.02; // [m], [-]
    if (points.front().diameter >= stones) {
        problems.error(
            "E504", points.front().diameter_place,
            fmt::format("the smallest size is {}: a soil of stones alone", in_mm(points.front().diameter)),
            "sizes are in mm unless the header says otherwise: `d [um]` for micrometers"
        );
        return false;
    }
    if (points.back().passing <= least_end) {
        problems.error(
            "E504", points.back().passing_place,
            fmt::format(
                "the curve ends at {} passing {}", in_percent(points.back().passing), in_mm(points.back().diameter)
            ),
            "percent unless the header says otherwise: `passing [-]` for fractions"
        );
        return false;
    }
    return true;
}

/// From nothing to everything, sizes rising.
bool check_ends(const std::vector<GradingPoint>& points, Problems& problems) {
    if (points.front().passing != 0) {
        problems.error(
            "E504", points.front().passing_place,
            fmt::format(
                "the curve starts at {} passing {}", in_percent(points.front().passing), in_mm(points.front().diameter)
            ),
            "add the size that nothing passes (0 %): the smallest grains that you want to model"
        );
        return false;
    }
    if (points.back().passing != 1) {
        problems.error(
            "E504", points.back().passing_place,
            fmt::format(
                "the curve ends at {} passing {}", in_percent(points.back().passing), in_mm(points.back().diameter)
            ),
            "add the size that everything passes (100 %)"
        );
        return false;
    }
    return true;
}

} // namespace

std::optional<grains::Grading> make_grading(
    std::vector<GradingPoint> points, const std::string& origin, const Place& whole, Problems& problems, CurveEnds ends
) {
    if (points.size() < 2) {
        problems.error(
            "E505", whole,
            fmt::format(
                "a grading curve needs at least two points, and there {} {}", points.size() == 1 ? "is" : "are",
                points.size()
            ),
            "a line for each sieve: its size and the percent passing"
        );
        return std::nullopt;
    }
    if (!check_values(points, problems)) {
        return std::nullopt;
    }
    // Sieve tables often start with the coarsest.
    if (points.front().diameter > points.back().diameter) {
        std::reverse(points.begin(), points.end());
    }
    if (!check_order(points, problems) || !check_units(points, problems)) {
        return std::nullopt;
    }
    if (ends == CurveEnds::Closed && !check_ends(points, problems)) {
        return std::nullopt;
    }
    grains::Grading grading;
    grading.origin = origin;
    for (const GradingPoint& point : points) {
        grading.diameter.push_back(point.diameter);
        grading.passing.push_back(point.passing);
    }
    return grading;
}

std::optional<grains::Grading>
parse_grading(const std::shared_ptr<const Source>& source, Problems& problems, CurveEnds ends) {
    const Place whole{source, 0, 0, 1};
    if (!check_encoding(source, problems)) {
        return std::nullopt;
    }
    const std::vector<CsvRow> rows = split_rows(source);
    if (rows.empty()) {
        problems.error("E505", whole, "the file is empty", std::string(expected_header));
        return std::nullopt;
    }
    const auto columns = read_header(rows[0], problems);
    if (!columns) {
        return std::nullopt;
    }
    std::vector<GradingPoint> points;
    bool is_good = true;
    for (std::size_t k = 1; k < rows.size(); ++k) {
        const std::vector<CsvCell>& cells = rows[k].cells;
        if (cells.size() != rows[0].cells.size()) {
            problems.error(
                "E502", rows[k].place,
                fmt::format("{} values where the header names {} columns", cells.size(), rows[0].cells.size()),
                "one value for each column; numbers have a decimal point, not a comma"
            );
            is_good = false;
            continue;
        }
        const CsvCell &size = cells[columns->diameter], &share = cells[columns->passing];
        const auto diameter = read_value(size, columns->diameter_unit, dimension::length, problems);
        const auto passing = read_value(share, columns->passing_unit, dimension::none, problems);
        is_good = is_good && diameter && passing;
        if (diameter && passing) {
            points.push_back({*diameter, *passing, size.place, share.place});
        }
    }
    if (!is_good) {
        return std::nullopt;
    }
    return make_grading(std::move(points), source->name, whole, problems, ends);
}

grains::Grading read_grading(const std::string& path, CurveEnds ends) {
    Problems problems;
    const auto grading = parse_grading(std::make_shared<Source>(Source{path, read_whole_file(path)}), problems, ends);
    if (!grading) {
        throw CaseProblems(problems.sorted());
    }
    return *grading;
}

} // namespace suffuse::casefile
