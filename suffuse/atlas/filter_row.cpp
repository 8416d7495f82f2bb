#include "suffuse/atlas/filter_row.hpp"

#include "suffuse/atlas/table.hpp"

#include <algorithm>
#include <iterator>

namespace suffuse::atlas {
namespace {

FilterRow filter_row_of(const Cells& cells) {
    FilterRow row;
    row.ratio = cells.number("ratio");
    row.width = cells.number("width");
    row.seed = static_cast<int>(cells.number("seed"));
    row.gradient = cells.number("gradient");
    row.grains = static_cast<std::int64_t>(cells.number("grains"));
    row.thickness = cells.number("thickness");
    row.constriction = cells.number("constriction");
    row.passed = cells.number("passed");
    row.moving = cells.number("moving");
    row.entered = cells.number("entered");
    row.ended = cells.number("ended") != 0;
    row.overlap = cells.number("overlap");
    return row;
}

} // namespace

std::vector<FilterRow> parse_filter_rows(std::string_view csv) {
    const std::vector<Cells> lines = parse_table(csv);
    std::vector<FilterRow> rows;
    rows.reserve(lines.size());
    std::ranges::transform(lines, std::back_inserter(rows), filter_row_of);
    return rows;
}

const std::vector<FilterRow>& shipped_filter_rows() {
    static const std::vector<FilterRow> rows = parse_filter_rows(shipped_filter_table());
    return rows;
}

} // namespace suffuse::atlas
