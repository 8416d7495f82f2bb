#include "suffuse/gradings/tables_side_by_side.hpp"

#include "suffuse/gradings/sheet_header.hpp"
#include "suffuse/gradings/sheet_titles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace suffuse::gradings {

namespace {

/// The cells of some columns; rows that have nothing there are left out.
Sheet take_columns(const Sheet& sheet, std::size_t from, std::size_t to, std::size_t first_row) {
    Sheet part{{}, sheet.mark};
    for (std::size_t k = first_row; k < sheet.rows.size(); ++k) {
        SheetRow row{{}, sheet.rows[k].place, sheet.rows[k].is_comment};
        for (std::size_t c = from; c < std::min(to, sheet.rows[k].cells.size()); ++c) {
            row.cells.push_back(sheet.rows[k].cells[c]);
        }
        while (!row.cells.empty() && row.cells.back().text.empty()) {
            row.cells.pop_back();
        }
        if (!row.cells.empty()) {
            part.rows.push_back(std::move(row));
        }
    }
    return part;
}

/// Where a second table begins next to the first: sizes and shares, and again sizes and shares of the same kind, that
/// are not the same sizes in another unit.
std::vector<std::size_t> find_tables_side_by_side(const Sheet& sheet, const SheetHeader& header) {
    std::vector<std::size_t> begins;
    const auto sizes = columns_of_kind(header.headings, ColumnKind::Size);
    for (std::size_t k = 0; k < sizes.size(); ++k) {
        const std::size_t end = k + 1 < sizes.size() ? sizes[k + 1] : header.headings.size();
        const bool has_share = std::any_of(
            header.headings.begin() + static_cast<std::ptrdiff_t>(sizes[k]),
            header.headings.begin() + static_cast<std::ptrdiff_t>(end),
            [](const Heading& heading) {
                return heading.kind == ColumnKind::Share && heading.meaning == ShareMeaning::Passing;
            }
        );
        if (!has_share) {
            return {};
        }
        begins.push_back(k == 0 ? 0 : sizes[k]);
    }
    const std::size_t first = header.row + header.lines;
    const bool are_same =
        begins.size() == 2 &&
        std::all_of(
            sheet.rows.begin() + static_cast<std::ptrdiff_t>(std::min(first, sheet.rows.size())), sheet.rows.end(),
            [&](const SheetRow& row) { // a line for each sieve: the other size of it
                const auto value = [&](std::size_t size) { return number_at(sheet, row, size + 1); };
                return row.is_comment || value(sizes[0]) == value(sizes[1]);
            }
        );
    return begins.size() > 1 && !are_same ? begins : std::vector<std::size_t>{};
}

/// The row right above the headings where it has a title for each of the tables side by side.
const SheetRow* find_titles_next_to(const Sheet& sheet, std::size_t header, const std::vector<std::size_t>& begins) {
    const SheetRow* above = header > 0 ? &sheet.rows[header - 1] : nullptr;
    const bool is_next = above != nullptr && above->place.line + 1 == sheet.rows[header].place.line;
    const bool has_title =
        is_next && std::ranges::any_of(begins, [above](std::size_t k) { return !is_blank(text_at(*above, k)); });
    return has_title ? above : nullptr;
}

/// Whether sizes and shares go on from each table to the next, so that they are one: a curve in several columns.
bool go_on(const Sheet& sheet, std::size_t first_row, const std::vector<std::size_t>& begins) {
    std::vector<std::pair<double, double>> points;
    for (const std::size_t begin : begins) {
        for (std::size_t k = first_row; k < sheet.rows.size(); ++k) {
            const auto size = number_at(sheet, sheet.rows[k], begin),
                       share = number_at(sheet, sheet.rows[k], begin + 1);
            if (!sheet.rows[k].is_comment && size && share) {
                points.emplace_back(*size, *share);
            }
        }
    }
    const auto rises = [](const auto& a, const auto& b) { return a.first < b.first && a.second <= b.second; };
    const auto falls = [](const auto& a, const auto& b) { return a.first > b.first && a.second >= b.second; };
    const auto is_all = [&points](const auto& in_order) {
        return std::adjacent_find(points.begin(), points.end(), [&](const auto& a, const auto& b) {
                   return !in_order(a, b);
               }) == points.end();
    };
    return points.size() > begins.size() && (is_all(rises) || is_all(falls));
}

/// The tables next to the first one below it.
SheetTable stack(SheetTable table, const SheetHeader& header, const std::vector<std::size_t>& begins) {
    Sheet stacked{{}, table.sheet.mark};
    for (std::size_t part = 0; part < begins.size(); ++part) {
        const std::size_t end = part + 1 < begins.size() ? begins[part + 1] : std::string::npos;
        const std::size_t from = part == 0 ? 0 : header.row + header.lines;
        Sheet rows = take_columns(table.sheet, begins[part], end, from);
        stacked.rows.insert(stacked.rows.end(), rows.rows.begin(), rows.rows.end());
    }
    table.sheet = std::move(stacked);
    return table;
}

} // namespace

std::vector<SheetTable> split_side_by_side(SheetTable table, Problems& problems) {
    const auto header = find_sheet_header(table.sheet);
    const auto begins = header ? find_tables_side_by_side(table.sheet, *header) : std::vector<std::size_t>{};
    if (begins.empty()) {
        return {std::move(table)};
    }
    const SheetRow* titles = find_titles_next_to(table.sheet, header->row, begins);
    if (titles == nullptr && go_on(table.sheet, header->row + header->lines, begins)) {
        problems.warning(
            sheet_remark, table.sheet.rows[header->row].place,
            fmt::format("{} tables side by side continue each other: read as one", begins.size())
        );
        return {stack(std::move(table), *header, begins)};
    }
    std::vector<SheetTable> parts;
    for (std::size_t k = 0; k < begins.size(); ++k) {
        const std::size_t end = k + 1 < begins.size() ? begins[k + 1] : std::string::npos; // no cell is lost
        SheetTable part;
        part.sheet = take_columns(table.sheet, begins[k], end, header->row);
        part.dry = table.dry;
        if (titles != nullptr) {
            part.name = text_at(*titles, begins[k]);
            part.is_hydrometer = names_hydrometer(
                {{titles->cells.size() > begins[k] ? titles->cells[begins[k]] : SheetCell{}}, titles->place, false}
            );
        }
        parts.push_back(std::move(part));
    }
    if (std::ranges::any_of(parts, &SheetTable::is_hydrometer)) { // titles of methods, not of samples
        for (SheetTable& part : parts) {
            part.name = table.name;
        }
    }
    parts.front().notes = std::move(table.notes);
    return parts;
}

} // namespace suffuse::gradings
