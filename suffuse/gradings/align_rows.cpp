#include "suffuse/gradings/align_rows.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace suffuse::gradings {

namespace {

/// Characters of a line, from the first to behind the last.
struct Span {
    int first = 0, end = 0;
};

Span span_of(const SheetCell& cell) {
    return {cell.place.column, cell.place.column + cell.place.length};
}

/// What the cells of the longest rows cover, column by column.
std::vector<Span> columns_of(const std::vector<SheetRow>& rows, std::size_t begin, std::size_t end) {
    std::size_t most = 0;
    for (std::size_t k = begin; k < end; ++k) {
        most = std::max(most, rows[k].cells.size());
    }
    std::vector<Span> columns;
    for (std::size_t k = begin; k < end; ++k) {
        for (std::size_t c = 0; c < most && rows[k].cells.size() == most; ++c) {
            const Span span = span_of(rows[k].cells[c]);
            if (c == columns.size()) {
                columns.push_back(span);
            }
            columns[c] = {std::min(columns[c].first, span.first), std::max(columns[c].end, span.end)};
        }
    }
    return columns;
}

/// The column that a cell stands in; of several below it the last one that begins before it does.
std::size_t column_of(const Span& cell, const std::vector<Span>& columns) {
    std::vector<std::size_t> below;
    std::size_t nearest = 0;
    int least = -1;
    for (std::size_t c = 0; c < columns.size(); ++c) {
        const int gap = std::max(columns[c].first - cell.end, cell.first - columns[c].end);
        if (gap < 0) {
            below.push_back(c);
        }
        if (least < 0 || std::max(gap, 0) < least) {
            nearest = c, least = std::max(gap, 0);
        }
    }
    if (below.size() < 2) {
        return below.empty() ? nearest : below.front();
    }
    const auto begins_before = [&](std::size_t c) { return columns[c].first <= cell.first; };
    const auto last = std::find_if(below.rbegin(), below.rend(), begins_before);
    return last == below.rend() ? below.front() : *last;
}

void align_row(SheetRow& row, const std::vector<Span>& columns) {
    if (row.is_comment || row.cells.size() < 2 || row.cells.size() >= columns.size()) {
        return;
    }
    std::vector<std::size_t> places;
    for (const SheetCell& cell : row.cells) {
        const std::size_t place = column_of(span_of(cell), columns);
        if (!places.empty() && place <= places.back()) {
            return;
        }
        places.push_back(place);
    }
    std::vector<SheetCell> aligned(places.back() + 1, SheetCell{{}, row.place, false});
    for (std::size_t k = 0; k < places.size(); ++k) {
        aligned[places[k]] = std::move(row.cells[k]);
    }
    row.cells = std::move(aligned);
}

} // namespace

void align_rows(Sheet& sheet) {
    for (std::size_t begin = 0, end = 0; begin < sheet.rows.size(); begin = end) {
        for (end = begin + 1; end < sheet.rows.size(); ++end) {
            if (sheet.rows[end].place.line != sheet.rows[end - 1].place.line + 1) {
                break;
            }
        }
        const auto columns = columns_of(sheet.rows, begin, end);
        for (std::size_t k = begin; k < end; ++k) {
            align_row(sheet.rows[k], columns);
        }
    }
}

} // namespace suffuse::gradings
