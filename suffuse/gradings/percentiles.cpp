#include "suffuse/gradings/percentiles.hpp"

#include "suffuse/gradings/sheet_header.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

namespace suffuse::gradings {

namespace {

constexpr std::size_t least_points = 3; // of a curve; Cu needs two

/// A column of sizes that a given share is finer than.
struct PercentileColumn {
    std::size_t index = 0;
    double share = 0; ///< [-]
    SizeScale scale = SizeScale::Unknown;
};

/// "d60_mm", "D10 (mm)", "dmax": columns with a share each, none twice, the finest first.
std::vector<PercentileColumn> find_columns(const SheetRow& row) {
    std::vector<PercentileColumn> columns;
    for (std::size_t k = 0; k < row.cells.size(); ++k) {
        const auto derived = read_derived_name(row.cells[k].text);
        const bool is_size = derived && derived->kind == DerivedValue::Kind::SizeAt;
        const bool is_largest = derived && derived->kind == DerivedValue::Kind::Largest;
        const double share = is_largest ? 1 : is_size ? derived->at : 0;
        if (share > 0 && std::ranges::find(columns, share, &PercentileColumn::share) == columns.end()) {
            columns.push_back({k, share, read_heading(row.cells[k].text).scale});
        }
    }
    std::ranges::sort(columns, {}, &PercentileColumn::share);
    return columns;
}

/// The names of a soil: of all columns of samples; without one, of a first column without a heading.
std::string name_of(const SheetRow& header, const SheetRow& row) {
    std::string name;
    for (std::size_t k = 0; k < header.cells.size(); ++k) {
        const bool is_named = read_heading(header.cells[k].text).kind == ColumnKind::Sample;
        const bool is_index = k == 0 && is_blank(header.cells[k].text);
        if ((is_named || is_index) && !is_blank(text_at(row, k))) {
            append_word(name, text_at(row, k));
        }
    }
    return name.empty() ? fmt::format("line {}", row.place.line) : name;
}

SheetTable table_of(
    const Sheet& sheet, const SheetRow& header, const SheetRow& row, const std::vector<PercentileColumn>& columns
) {
    SheetTable table;
    table.name = name_of(header, row);
    table.sheet.mark = sheet.mark;
    table.sheet.rows.push_back({{{"d", header.place}, {"passing", header.place}}, header.place, false});
    for (const PercentileColumn& column : columns) {
        if (is_blank(text_at(row, column.index))) {
            continue;
        }
        const SheetCell& size = row.cells[column.index];
        const SheetCell share{fmt::format("{:.6g}", 100 * column.share), size.place, true};
        table.sheet.rows.push_back({{size, share}, row.place, false});
    }
    GradingColumns found;
    found.first_row = 1;
    found.size.scale = columns.front().scale;
    found.shares.push_back({1, {}, "", ShareMeaning::Passing, ShareUnit::Percent});
    table.columns = std::move(found);
    return table;
}

} // namespace

std::vector<SheetTable> read_percentiles(const Sheet& sheet, Problems& problems) {
    std::vector<SheetTable> tables;
    for (std::size_t k = 0; k < std::min(sheet.rows.size(), most_titles) && tables.empty(); ++k) {
        const SheetRow& header = sheet.rows[k];
        const auto columns = find_columns(header);
        const bool have_one_scale = std::ranges::all_of(columns, [&columns](const PercentileColumn& column) {
            return column.scale == columns.front().scale;
        });
        if (header.is_comment || columns.size() < least_points || !have_one_scale) {
            continue;
        }
        std::vector<const SheetRow*> left_out;
        for (const SheetRow* row : value_rows(sheet, k + 1)) {
            const auto count = std::ranges::count_if(columns, [&](const PercentileColumn& column) {
                return number_at(sheet, *row, column.index).has_value();
            });
            if (count >= static_cast<std::ptrdiff_t>(least_points)) {
                tables.push_back(table_of(sheet, header, *row, columns));
            } else if (count > 0) {
                left_out.push_back(row);
            }
        }
        if (!tables.empty() && !left_out.empty()) {
            std::vector<std::string> names;
            for (const SheetRow* row : left_out) {
                names.push_back(name_of(header, *row));
            }
            problems.warning(
                sheet_remark, left_out.front()->place,
                fmt::format(
                    "left out, because less than {} sizes are given: {}; read: {}{}", least_points,
                    fmt::join(names, ", "), tables.front().name,
                    tables.size() > 1 ? fmt::format(" and {} more", tables.size() - 1) : ""
                )
            );
        }
        if (!tables.empty()) {
            problems.warning(
                sheet_remark, header.place,
                fmt::format("each line is a soil with the sizes at given percents passing: {} of them", columns.size())
            );
        }
    }
    return tables;
}

} // namespace suffuse::gradings
