#include "suffuse/atlas/row.hpp"

#include "suffuse/atlas/table.hpp"
#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <string>

namespace suffuse::atlas {
namespace {

Threshold threshold_of(const Cells& cells, const std::string& name) {
    return {cells.optional(name), cells.number(name + "_at_most") != 0};
}

/// That of `words` whose name the cell has.
template <class Word>
Word one_of(const Cells& cells, std::string_view column, std::initializer_list<Word> words) {
    for (const Word word : words) {
        if (cells.text(column) == name_of(word)) {
            return word;
        }
    }
    throw CaseError(fmt::format("atlas, line {}: {} = {} is not known", cells.line(), column, cells.text(column)));
}

Row row_of(const Cells& cells) {
    Row row;
    row.size_ratio = cells.number("ratio");
    row.fines_content = cells.number("fines");
    row.seed = static_cast<int>(cells.number("seed"));
    row.density = one_of(cells, "density", {Density::Loose, Density::Medium, Density::Dense});
    row.flow = one_of(cells, "flow", {Flow::Up, Flow::Level});
    row.grains = static_cast<std::int64_t>(cells.number("grains"));
    row.porosity = cells.number("porosity");
    row.alpha = cells.number("alpha");
    row.heave = cells.optional("i_c");
    row.moves_1 = threshold_of(cells, "i1");
    row.moves_10 = threshold_of(cells, "i10");
    row.moves_50 = threshold_of(cells, "i50");
    row.drag_share = cells.number("drag_share");
    row.load_bearing = cells.number("load_bearing");
    row.sifting = cells.number("sifting");
    return row;
}

} // namespace

const char* name_of(Density density) {
    switch (density) {
    case Density::Loose:
        return "loose";
    case Density::Medium:
        return "medium";
    case Density::Dense:
        break;
    }
    return "dense";
}

const char* name_of(Flow flow) {
    return flow == Flow::Up ? "up" : "level";
}

double heave_gradient(const Row& row) {
    constexpr double buoyant = 1.65; // Gs - 1
    return row.heave.value_or(buoyant * (1 - row.porosity));
}

double last_gradient(const Row& row) {
    constexpr double upward = 1.2, level = 0.9; // validation/atlas.toml
    return row.flow == Flow::Up ? std::min(upward, heave_gradient(row)) : level;
}

std::vector<Row> parse_rows(std::string_view csv) {
    const std::vector<Cells> lines = parse_table(csv);
    std::vector<Row> rows;
    rows.reserve(lines.size());
    std::ranges::transform(lines, std::back_inserter(rows), row_of);
    return rows;
}

const std::vector<Row>& shipped_rows() {
    static const std::vector<Row> rows = parse_rows(shipped_table());
    return rows;
}

} // namespace suffuse::atlas
