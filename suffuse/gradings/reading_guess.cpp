#include "suffuse/gradings/reading_guess.hpp"

#include "suffuse/gradings/column_content.hpp"
#include "suffuse/gradings/sheet_titles.hpp"
#include "suffuse/gradings/turned_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace suffuse::gradings {

namespace {

constexpr std::size_t most_columns_tried = 40, most_sizes = 2, most_shares = 3;

/// What a column of a sheet may be.
struct ColumnNumbers {
    std::size_t first_row = 0; ///< with a size
    std::size_t sizes = 0, numbers = 0;
    std::set<std::string_view> different;
    SizeScale scale = SizeScale::Unknown; ///< by a heading
    bool is_headed = false;
};

ColumnNumbers look_at(const Sheet& sheet, std::size_t column) {
    ColumnNumbers found;
    for (std::size_t k = 0; k < sheet.rows.size(); ++k) {
        const SheetRow& row = sheet.rows[k];
        if (row.is_comment) {
            continue;
        }
        if (is_size(sheet, row, column)) {
            found.first_row = found.sizes == 0 ? k : found.first_row;
            ++found.sizes, found.different.insert(text_at(row, column));
        } else if (found.sizes == 0) {
            const Heading heading = read_heading(text_at(row, column));
            found.is_headed = found.is_headed || heading.kind == ColumnKind::Size;
            found.scale = heading.kind == ColumnKind::Size ? heading.scale : found.scale;
        }
        found.numbers += number_at(sheet, row, column) ? 1U : 0U;
    }
    return found;
}

/// The meanings that the numbers of a column leave, the surest first; all where they leave none.
void add_meanings(
    const std::string& size, const std::string& share, const std::optional<Amounts>& amounts,
    std::vector<ReadingOptions>& guesses
) {
    const PossibleMeanings possible = find_possible_meanings(amounts.value_or(Amounts{}));
    const bool is_any = amounts && may_be_shares(possible);
    ReadingOptions options;
    options.size = size;
    for (const auto& [member, fits] :
         {std::pair{&ReadingOptions::share, possible.adds_up},
          {&ReadingOptions::passing, possible.passing},
          {&ReadingOptions::retained, possible.cumulative_retained},
          {&ReadingOptions::mass, false}}) {
        if (fits || !is_any) {
            ReadingOptions guess = options;
            guess.*member = share;
            guesses.push_back(std::move(guess));
        }
    }
}

} // namespace

std::vector<ReadingOptions> guess_readings(const Sheet& sheet) {
    std::vector<ColumnNumbers> columns;
    for (std::size_t k = 0; k < std::min(width_of(value_rows(sheet, 0)), most_columns_tried); ++k) {
        columns.push_back(look_at(sheet, k));
    }
    std::vector<std::size_t> sizes;
    for (const bool is_headed : {true, false}) {
        for (std::size_t k = 0; k < columns.size() && sizes.size() < most_sizes; ++k) {
            const bool may_be = columns[k].sizes > 1 && 2 * columns[k].different.size() > columns[k].sizes;
            if (may_be && columns[k].is_headed == is_headed) {
                sizes.push_back(k);
            }
        }
    }
    std::vector<ReadingOptions> guesses;
    for (const std::size_t size : sizes) {
        const SizeScale stated = find_size_unit(sheet, 0, columns[size].first_row).scale;
        const SizeScale scale = columns[size].scale == SizeScale::Unknown ? stated : columns[size].scale;
        std::size_t tried = 0;
        for (std::size_t k = 0; k < columns.size() && tried < most_shares; ++k) {
            if (k != size && columns[k].numbers > 1) {
                ++tried;
                add_meanings(
                    fmt::format("{}:{}", size + 1, scale_name(scale)), fmt::format("{}", k + 1),
                    amounts_in(sheet, columns[size].first_row, {size, scale}, k), guesses
                );
            }
        }
    }
    Problems unheard;
    if (turn_table(sheet, unheard)) {
        add_meanings("across", "all", std::nullopt, guesses);
    }
    return guesses;
}

} // namespace suffuse::gradings
