#include "suffuse/gradings/unnamed_columns.hpp"

#include "suffuse/gradings/column_content.hpp"
#include "suffuse/gradings/derived_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace suffuse::gradings {

namespace {

/// One cell, or the names that a plotting program gives: nothing that could say of which kind or unit a column is.
bool is_title(const SheetRow& row) {
    return row.cells.size() == 1 || std::ranges::all_of(row.cells, [](const SheetCell& cell) {
               return cell.text.size() < 2; // x, y
           });
}

/// Sizes each once, shares from near nothing to 100 (or to 1).
bool may_be_sizes(const Sheet& sheet, std::size_t first_row, std::size_t size, std::size_t share) {
    std::set<double> sizes;
    const auto rows = value_rows(sheet, first_row);
    for (const SheetRow* row : rows) {
        const auto d = read_sieve_size(text_at(*row, size), SizeScale::Unknown, commas_are_decimal(sheet));
        if (d && d->diameter > 0 && number_at(sheet, *row, share)) {
            sizes.insert(d->diameter);
        }
    }
    const auto amounts = amounts_in(sheet, first_row, {size, SizeScale::Unknown}, share);
    const double most = amounts ? std::ranges::max(amounts->on_sieves) : 0;
    const bool ends_full = (most >= 90 && most <= 100.1) || (most >= 0.9 && most <= 1.001);
    return sizes.size() == rows.size() && ends_full && is_cumulative(*amounts);
}

/// "clay,silt,sand": their bounds differ between standards.
std::vector<std::string> classes_in(const SheetRow& row) {
    std::vector<std::string> classes;
    for (const SheetCell& cell : row.cells) {
        const auto derived = read_derived_name(cell.text);
        if (derived && derived->kind >= DerivedValue::Kind::Cobbles && derived->kind <= DerivedValue::Kind::Clay) {
            classes.push_back(cell.text);
        }
    }
    return classes;
}

void complain_about_header(const Sheet& sheet, bool are_two_columns, Problems& problems) {
    const auto rows = value_rows(sheet, 0);
    const SheetRow& first = rows.empty() ? sheet.rows.front() : *rows.front();
    auto classes = classes_in(first);
    if (classes.size() > 1) {
        const std::string last = classes.back();
        classes.pop_back();
        problems.error(
            "E506", first.place,
            fmt::format("shares of {} and {} are no curve: their sizes are missing", fmt::join(classes, ", "), last),
            "write the curve: `d [mm],passing [%]` with the upper bound of each class by its standard, as 0.002, 0.063 "
            "and 2 mm"
        );
        return;
    }
    problems.error(
        "E506", first.place,
        are_two_columns ? "no column headings, and the numbers do not show which are the sizes"
                        : "a grading curve needs a column of sizes and one of percent passing, and `d` is missing",
        expected_header
    );
}

} // namespace

std::optional<GradingColumns> find_unnamed_columns(const Sheet& sheet, Problems& problems) {
    const auto is_pair = [&sheet](const SheetRow& row) {
        return !row.is_comment && row.cells.size() == 2 && number_at(sheet, row, 1) && is_size(sheet, row, 0);
    };
    GradingColumns found;
    found.first_row = static_cast<std::size_t>(std::ranges::find_if(sheet.rows, is_pair) - sheet.rows.begin());
    const auto values = value_rows(sheet, found.first_row);
    const bool are_two =
        !values.empty() && std::ranges::all_of(values, [](const SheetRow* row) { return row->cells.size() == 2; });
    const bool first = are_two && may_be_sizes(sheet, found.first_row, 0, 1),
               second = are_two && may_be_sizes(sheet, found.first_row, 1, 0);
    if (first == second) {
        complain_about_header(sheet, are_two, problems);
        return std::nullopt;
    }
    for (const SheetRow* title : value_rows(sheet, 0, found.first_row)) {
        if (!is_title(*title)) {
            complain_about_header(sheet, false, problems);
            return std::nullopt;
        }
        problems.warning(
            sheet_remark, title->place, "skipped: it is not a row of two numbers",
            "name the columns in it: `d [mm],passing [%]`"
        );
    }
    found.size = {first ? 0U : 1U, SizeScale::Unknown};
    found.is_headed = false;
    found.shares.push_back({first ? 1U : 0U, {}, "", ShareMeaning::Cumulative, ShareUnit::Unknown, false});
    problems.warning(
        sheet_remark, sheet.rows[found.first_row].place,
        fmt::format(
            "no column headings: the {} is read as the size in mm, the other as a cumulative share",
            first ? "first" : "second"
        ),
        "begin with a line `d [mm],passing [%]` to say so"
    );
    return found;
}

} // namespace suffuse::gradings
