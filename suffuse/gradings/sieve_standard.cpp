#include "suffuse/gradings/sieve_standard.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/gradings/column_content.hpp"
#include "suffuse/gradings/lexicon.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::gradings {

namespace {

bool has_sieve_numbers(const SheetTable& table) {
    const GradingColumns& columns = *table.columns;
    const SizeScale scale = judge_plain_sizes(table.sheet, columns).scale;
    return std::ranges::any_of(value_rows(table.sheet, columns.first_row), [&](const SheetRow* row) {
        const auto size = size_at(table.sheet, *row, columns.size.index, scale);
        return size && size->notation == SizeNotation::SieveNumber;
    });
}

/// The first cell, of comments too, with a word of the topic; null where there is none.
const SheetCell* find_cell(const Sheet& sheet, Topic topic) {
    for (const SheetRow& row : sheet.rows) {
        for (const SheetCell& cell : row.cells) {
            if (mentions(topic, spaced_words(cell.text))) {
                return &cell;
            }
        }
    }
    return nullptr;
}

} // namespace

void check_sieve_standard(const Sheet& sheet, const std::vector<SheetTable>& tables, Problems& problems) {
    if (std::ranges::none_of(tables, has_sieve_numbers) || find_cell(sheet, Topic::AstmSieves) != nullptr) {
        return;
    }
    if (const SheetCell* const other = find_cell(sheet, Topic::OtherSieves)) {
        problems.error(
            "E506", other->place,
            fmt::format(
                "`{}` are sieves of another standard than ASTM E11, and their numbers have other openings",
                trimmed(other->text)
            ),
            "write the openings in mm, in a column `d [mm]`; if the numbers are those of ASTM E11, name the column `US "
            "mesh`"
        );
    } else if (const SheetCell* const mesh = find_cell(sheet, Topic::Mesh)) {
        problems.warning(
            sheet_remark, mesh->place, "mesh numbers are read as sieves of ASTM E11",
            "name the column `US mesh` to say so; of sieves of BS 410 or Tyler give the openings in mm"
        );
    }
}

} // namespace suffuse::gradings
