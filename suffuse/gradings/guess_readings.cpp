#include "suffuse/gradings/guess_readings.hpp"

#include "suffuse/gradings/column_content.hpp"
#include "suffuse/gradings/sheet_header.hpp"
#include "suffuse/gradings/turned_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace suffuse::gradings {

namespace {

constexpr std::size_t most_columns_tried = 40, most_sizes = 2, most_shares = 3;

/// What a column of a sheet may be.
struct ColumnNumbers {
    std::size_t first_row = 0; ///< with a size
    std::size_t sizes = 0, numbers = 0;
    std::set<std::string_view> different;
    SizeScale scale = SizeScale::Unknown;         ///< by a heading
    bool is_headed = false, is_share = false;     ///< by a heading: sizes, shares or masses
    bool have_units = true;                       ///< each size has its own
    bool is_no_size = false, is_no_share = false; ///< by a heading: a radius, a count, names of samples
    std::optional<ShareMeaning> meaning;          ///< of shares whose heading says whether they pass
    std::string heading;
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
            found.have_units = found.have_units && size_at(sheet, row, column)->notation != SizeNotation::Plain;
        } else if (found.sizes == 0) {
            const Heading heading = read_heading(text_at(row, column));
            const bool is_radius = names_no_diameter(heading, text_at(row, column));
            found.is_no_size = found.is_no_size || is_radius;
            found.is_no_share = found.is_no_share || heading.counts_grains || heading.kind == ColumnKind::Sample;
            found.heading = is_blank(text_at(row, column)) ? found.heading : text_at(row, column);
            found.is_headed = found.is_headed || heading.kind == ColumnKind::Size;
            found.is_share = found.is_share || heading.kind == ColumnKind::Share;
            const bool is_stated = heading.kind == ColumnKind::Share && heading.meaning <= ShareMeaning::Retained;
            found.meaning = is_stated ? heading.meaning : found.meaning;
            found.scale = heading.kind == ColumnKind::Size ? heading.scale : found.scale;
        }
        found.numbers += number_at(sheet, row, column) ? 1U : 0U;
    }
    return found;
}

/// The meanings that the numbers of a column leave, the surest first; all where they leave none.
void add_meanings(
    const std::string& size, const std::string& share, const std::optional<Amounts>& amounts, bool is_unit_open,
    std::vector<GuessedReading>& guesses
) {
    const PossibleMeanings possible = find_possible_meanings(amounts.value_or(Amounts{}));
    const bool is_any = amounts && may_be_shares(possible);
    ReadingOptions options;
    options.size = size;
    for (const auto& [member, fits] :
         {std::pair{&ReadingOptions::share, possible.adds_up || possible.on_sieve},
          {&ReadingOptions::passing, possible.passing},
          {&ReadingOptions::retained, possible.cumulative_retained},
          {&ReadingOptions::mass, false}}) {
        if (fits || !is_any) {
            ReadingOptions guess = options;
            guess.*member = share;
            guesses.push_back({std::move(guess), is_unit_open});
        }
    }
}

} // namespace

std::vector<GuessedReading> guess_readings(const Sheet& sheet) {
    std::vector<ColumnNumbers> columns;
    for (std::size_t k = 0; k < std::min(width_of(value_rows(sheet, 0)), most_columns_tried); ++k) {
        columns.push_back(look_at(sheet, k));
    }
    const auto unit_of = [&](std::size_t k) { // by the heading, else by a title
        const SizeScale stated = find_size_unit(sheet, 0, columns[k].first_row).scale;
        return columns[k].scale == SizeScale::Unknown ? stated : columns[k].scale;
    };
    const auto is_repeated = [&](std::size_t k) {
        return !columns[k].heading.empty() &&
               std::ranges::count(columns, columns[k].heading, &ColumnNumbers::heading) > 1;
    };
    std::vector<std::size_t> sizes;
    for (std::size_t k = 0; k < columns.size() && sizes.size() < most_sizes; ++k) {
        const bool may_be = columns[k].sizes > 1 && 2 * columns[k].different.size() > columns[k].sizes;
        if (may_be && (columns[k].have_units || columns[k].is_headed) && !columns[k].is_share &&
            !columns[k].is_no_size) {
            sizes.push_back(k);
        }
    }
    std::vector<GuessedReading> guesses;
    for (const std::size_t size : sizes) {
        const SizeScale scale = unit_of(size);
        const bool is_unit_open = scale == SizeScale::Unknown && !columns[size].have_units;
        std::size_t tried = 0;
        for (std::size_t k = 0; k < columns.size() && tried < most_shares; ++k) {
            const bool may_be = !columns[k].is_headed && !columns[k].is_no_share && !is_repeated(k);
            if (k != size && columns[k].numbers > 1 && may_be) {
                ++tried;
                std::vector<GuessedReading> own;
                add_meanings(
                    fmt::format("{}:{}", size + 1, scale_name(scale)), fmt::format("{}", k + 1),
                    amounts_in(sheet, columns[size].first_row, {size, scale}, k), is_unit_open, own
                );
                std::erase_if(own, [&](const GuessedReading& guess) { // what a heading says is not in question
                    const bool passes = !guess.options.passing.empty();
                    return columns[k].meaning && passes != (*columns[k].meaning == ShareMeaning::Passing);
                });
                guesses.insert(guesses.end(), own.begin(), own.end());
            }
        }
    }
    Problems unheard;
    const auto turned = turn_table(sheet, unheard);
    const bool has_unit =
        turned && (turned->columns->size.scale != SizeScale::Unknown || turned->size_unit.scale != SizeScale::Unknown);
    const bool have_units = turned && std::ranges::all_of(value_rows(turned->sheet, 1), [&](const SheetRow* row) {
                                const auto size = size_at(turned->sheet, *row, 0);
                                return !size || size->notation != SizeNotation::Plain;
                            });
    if (has_unit || have_units) {
        add_meanings("across", "all", std::nullopt, false, guesses);
    }
    return guesses;
}

} // namespace suffuse::gradings
