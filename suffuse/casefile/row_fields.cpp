#include "suffuse/casefile/row_fields.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/read_text.hpp"
#include "suffuse/casefile/special_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <sstream>

namespace suffuse::casefile {
namespace {

std::string trimmed(std::string text) {
    text.erase(0, text.find_first_not_of(" \t\r\""));
    text.erase(text.find_last_not_of(" \t\r\"") + 1);
    return text;
}

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream words(line);
    for (std::string cell; std::getline(words, cell, ',');) {
        cells.push_back(trimmed(std::move(cell)));
    }
    return cells;
}

/// A number, whole where it is written so; else a text, as a quantity with its unit is.
Scalar scalar_in(const std::string& cell) {
    const char *begin = cell.data(), *end = begin + cell.size();
    std::int64_t whole = 0;
    double number = 0;
    if (const auto [stop, failed] = std::from_chars(begin, end, whole); failed == std::errc() && stop == end) {
        return whole;
    }
    if (const auto [stop, failed] = std::from_chars(begin, end, number); failed == std::errc() && stop == end) {
        return number;
    }
    return cell;
}

std::vector<Sweep> rows_in_file(Reader& v, const Node& node) {
    std::vector<Sweep> rows;
    const std::string path = (std::filesystem::path(v.context().folder) / node.text).lexically_normal().string();
    std::string text;
    try {
        text = read_whole_file(path);
    } catch (const IoError& problem) {
        v.error("E501", node.place, problem.what(), "paths start at the folder of the case");
        return rows;
    }
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const std::vector<std::string> cells = cells_of(line);
        if (cells.empty() || (cells.size() == 1 && cells.front().empty()) || cells.front().starts_with('#')) {
            continue;
        }
        if (rows.empty()) {
            const auto twice =
                std::ranges::find_if(cells, [&](const std::string& key) { return std::ranges::count(cells, key) > 1; });
            if (twice != cells.end()) {
                v.error(
                    "E205", node.place, fmt::format("{}:{} has the heading `{}` twice", path, number, *twice),
                    "one column for each key: two values of one key are two rows"
                );
                return {};
            }
            std::ranges::transform(cells, std::back_inserter(rows), [](const std::string& key) {
                return Sweep{key, {}};
            });
            continue;
        }
        if (cells.size() != rows.size() || std::ranges::any_of(cells, &std::string::empty)) {
            v.error(
                "E205", node.place, fmt::format("{}:{} has not a value for each heading", path, number),
                "a line of headings, keys as in `sweep`, and a line of values a row, with their units"
            );
            return {};
        }
        for (std::size_t k = 0; k < cells.size(); ++k) {
            rows[k].values.push_back(scalar_in(cells[k]));
        }
    }
    return rows;
}

} // namespace

void rows_field(Reader& v, Study& study) {
    const Node* node = v.take("rows");
    if (node == nullptr) {
        return;
    }
    if (node->is_table()) {
        sweep_field(v, "rows", study.rows);
    } else if (node->kind == Node::Kind::Text) {
        study.rows = rows_in_file(v, *node);
    } else {
        return v.wrong_type("rows", *node, "a CSV file, or a table of lists, { KEY = [values] }");
    }
    if (v.context().problems.has_errors() && study.rows.empty()) {
        return; // it could not be read
    }
    const std::size_t count = study.rows.empty() ? 0 : study.rows.front().values.size();
    if (count == 0 ||
        std::ranges::any_of(study.rows, [&](const Sweep& column) { return column.values.size() != count; })) {
        v.error("E205", node->place, "`rows` needs a value of each key in each row", "lists of one length");
    }
    for (const Sweep& column : study.rows) {
        if (std::ranges::find(study.sweep, column.key, &Sweep::key) != study.sweep.end()) {
            v.error(
                "E207", node->place, fmt::format("`{}` is in `rows` and in `sweep`", column.key),
                "keep it in one of them"
            );
        }
    }
    const auto chosen = std::ranges::find(study.sweep, row_key, &Sweep::key);
    if (chosen == study.sweep.end()) {
        Sweep all{row_key, {}};
        for (std::size_t k = 1; k <= count; ++k) {
            all.values.emplace_back(static_cast<std::int64_t>(k));
        }
        study.sweep.push_back(std::move(all));
        return;
    }
    for (const Scalar& value : chosen->values) {
        const auto* row = std::get_if<std::int64_t>(&value);
        if (row == nullptr || *row < 1 || *row > static_cast<std::int64_t>(count)) {
            v.error(
                "E203", node->place, fmt::format("the sweep over `row` has values that no row has: 1 to {}", count)
            );
            return;
        }
    }
}

void rows_field(Writer& v, const Study& study) {
    sweep_field(v, "rows", study.rows);
}

std::map<std::string, Scalar> values_of_row(const Study& study, const std::map<std::string, Scalar>& values) {
    std::map<std::string, Scalar> chosen;
    const auto row = values.find(row_key);
    const auto* number = row == values.end() ? nullptr : std::get_if<std::int64_t>(&row->second);
    for (const Sweep& column : study.rows) {
        if (number != nullptr && *number >= 1 && *number <= std::ssize(column.values)) {
            chosen[column.key] = column.values[static_cast<std::size_t>(*number - 1)];
        }
    }
    return chosen;
}

} // namespace suffuse::casefile
