#include "suffuse/gradings/numbered_samples.hpp"

#include "suffuse/gradings/heading.hpp"
#include "suffuse/gradings/sheet_values.hpp"

#include <algorithm>
#include <functional>

namespace suffuse::gradings {

namespace {

/// Another row heads the sizes: "d [mm],BH1,BH2" above, with a heading for each column, or "Sieve (mm)" below.
bool are_sizes_headed(
    const Sheet& sheet, std::size_t row, const std::vector<std::size_t>& columns, const SheetRow* first_value
) {
    for (std::size_t k = 0; k < sheet.rows.size() && &sheet.rows[k] != first_value; ++k) {
        const SheetRow& other = sheet.rows[k];
        const bool heads_columns = k > row || std::ranges::none_of(columns, [&other](std::size_t column) {
                                       return is_blank(text_at(other, column));
                                   });
        if (k != row && !other.is_comment && heads_columns &&
            read_heading(text_at(other, 0)).kind == ColumnKind::Size) {
            return true;
        }
    }
    return false;
}

/// A heading of depths and numbers without a unit, or in meters: "Depth (m),1.5,3.0", "Depth,1.5 m,3.0 m".
bool may_be_depths(const SheetRow& row, const std::vector<std::size_t>& columns) {
    return read_heading(text_at(row, 0)).names_depth && std::ranges::all_of(columns, [&row](std::size_t k) {
               const std::string& text = text_at(row, k);
               return plain_number(text, true) || read_heading("x " + text).scale == SizeScale::Meters;
           });
}

/// The first column rises or falls throughout, and all others with it or against it: shares that follow sizes.
bool follow_first_column(
    const Sheet& sheet, const std::vector<std::size_t>& columns, const std::vector<const SheetRow*>& values
) {
    const auto is_sorted = [&](std::size_t column, const auto& in_order) {
        const auto is_out = [&](const SheetRow* a, const SheetRow* b) {
            const auto above = number_at(sheet, *a, column), below = number_at(sheet, *b, column);
            return above && below && !in_order(*above, *below);
        };
        return std::ranges::adjacent_find(values, is_out) == values.end();
    };
    const auto all_are = [&](const auto& in_order) {
        return std::ranges::all_of(columns, [&](std::size_t k) { return is_sorted(k, in_order); });
    };
    return (is_sorted(0, std::less{}) || is_sorted(0, std::greater{})) &&
           (all_are(std::less_equal{}) || all_are(std::greater_equal{}));
}

} // namespace

bool numbers_samples(
    const Sheet& sheet, std::size_t row, const std::vector<std::size_t>& columns,
    const std::vector<const SheetRow*>& values
) {
    constexpr std::size_t least_sieves = 4; // fewer samples may become finer with the depth by chance
    return are_sizes_headed(sheet, row, columns, values.front()) ||
           (values.size() >= least_sieves && may_be_depths(sheet.rows[row], columns) &&
            follow_first_column(sheet, columns, values));
}

} // namespace suffuse::gradings
