#include "suffuse/gradings/sheet_tables.hpp"

#include "suffuse/gradings/lexicon.hpp"
#include "suffuse/gradings/percentiles.hpp"
#include "suffuse/gradings/plain_titles.hpp"
#include "suffuse/gradings/sheet_header.hpp"
#include "suffuse/gradings/turned_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <iterator>
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
        const auto is_within = [&](std::size_t share) {
            return share > sizes[k] && share < end && header.headings[share].meaning == ShareMeaning::Passing;
        };
        if (std::ranges::none_of(columns_of_kind(header.headings, ColumnKind::Share), is_within)) {
            return {};
        }
        begins.push_back(k == 0 ? 0 : sizes[k]);
    }
    const auto has_same = [&](const SheetRow* row) { // a line for each sieve: the other size of it
        return number_at(sheet, *row, sizes[0] + 1) == number_at(sheet, *row, sizes[1] + 1);
    };
    const bool are_same =
        begins.size() == 2 && std::ranges::all_of(value_rows(sheet, header.row + header.lines), has_same);
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
        for (const SheetRow* row : value_rows(sheet, first_row)) {
            const auto size = number_at(sheet, *row, begin), share = number_at(sheet, *row, begin + 1);
            if (size && share) {
                points.emplace_back(*size, *share);
            }
        }
    }
    const auto rises = [](const auto& a, const auto& b) { return a.first < b.first && a.second <= b.second; };
    const auto falls = [](const auto& a, const auto& b) { return a.first > b.first && a.second >= b.second; };
    const auto is_all = [&points](const auto& in_order) {
        return std::ranges::adjacent_find(points, std::not_fn(in_order)) == points.end();
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

/// The tables that are next to each other in one; that itself where there is no second. One soil for each, or one curve
/// that goes on from table to table.
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
            part.is_hydrometer = names_hydrometer({{cell_at(*titles, begins[k])}, titles->place, false});
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

using Rows = std::vector<const SheetRow*>;

/// Whether a text has two letters side by side: a word, and no number in which a letter was typed for a digit.
bool has_word(std::string_view text) {
    const auto are_letters = [](char a, char b) {
        return std::isalpha(static_cast<unsigned char>(a)) != 0 && std::isalpha(static_cast<unsigned char>(b)) != 0;
    };
    return std::adjacent_find(text.begin(), text.end(), are_letters) != text.end();
}

/// The rows of one table among those of a sheet: from its first title to the last row before the next table's headings.
class TableCutter {
public:
    TableCutter(const Sheet& sheet, std::size_t first, std::size_t header, std::size_t end)
        : sheet_(sheet), first_(first), header_(header), end_(end) {}

    SheetTable cut() {
        table_.sheet.mark = sheet_.mark;
        for (std::size_t k = first_; k < end_; ++k) {
            table_.sheet.rows.push_back(sheet_.rows[k]);
        }
        read_titles();
        const auto header = find_sheet_header(table_.sheet);
        if (header) {
            table_.sheet.rows.clear();
            sizes_ = columns_of_kind(header->headings, ColumnKind::Size);
            shares_ = columns_of_kind(header->headings, ColumnKind::Share);
            sort_rows(first_ + header->row + header->lines, *header);
        }
        return std::move(table_);
    }

private:
    void read_titles() {
        Rows titles;
        for (std::size_t k = first_; k < header_; ++k) {
            titles.push_back(&sheet_.rows[k]);
            const std::string name = sample_named_in(sheet_.rows[k]);
            table_.name = name.empty() ? table_.name : name;
        }
        table_.dry = find_dry_mass(sheet_, titles);
        table_.unused_mass = table_.dry ? std::nullopt : find_unused_mass(sheet_, titles);
        for (std::size_t k = first_; k < end_ && k <= header_; ++k) {
            table_.is_hydrometer = table_.is_hydrometer || names_hydrometer(sheet_.rows[k]);
        }
    }

    [[nodiscard]] bool is_sieve(const SheetRow& row) const {
        const auto may_be_size = [&](std::size_t k) {
            return is_size(sheet_, row, k) || read_row_word(text_at(row, k)) != RowWord::None;
        };
        const bool has_size = std::ranges::any_of(sizes_, may_be_size) &&
                              std::ranges::all_of(sizes_, [&](std::size_t k) { // "Gs,2.70" is none
                                  return may_be_size(k) || is_blank(text_at(row, k));
                              });
        const bool has_none = std::ranges::all_of(sizes_, [&](std::size_t k) { return is_blank(text_at(row, k)); });
        return has_size || read_row_word(first_text(row)) != RowWord::None || (has_none && has_share(row));
    }

    /// A size with a share behind it, whatever stands before: "Sand,4.75,100" is of a sample of that name.
    [[nodiscard]] bool is_whole_sieve(const SheetRow& row) const {
        return std::ranges::any_of(shares_, [&](std::size_t share) {
            const auto end = std::ranges::lower_bound(sizes_, share);
            return end != sizes_.begin() && is_size(sheet_, row, *std::prev(end)) && number_at(sheet_, row, share);
        });
    }

    /// "Material finer than 0.063 mm by washing" in a column of masses is in the pan's place, and no result.
    [[nodiscard]] bool is_washed_mass(const SheetRow& row, const SheetHeader& header) const {
        const bool is_mass = std::ranges::any_of(shares_, [&](std::size_t k) {
            return header.headings[k].unit == ShareUnit::Mass && number_at(sheet_, row, k);
        });
        return is_mass && read_row_word(first_text(row)) == RowWord::Pan &&
               mentions(Topic::Washing, spaced_words(first_text(row))) &&
               std::ranges::none_of(row.cells, [](const SheetCell& cell) {
                   return cell.text.find('%') != std::string::npos;
               });
    }

    [[nodiscard]] bool has_share(const SheetRow& row) const {
        return std::ranges::any_of(shares_, [&](std::size_t k) { return number_at(sheet_, row, k).has_value(); });
    }

    /// Values go into the table, derived values and notes out of it. Below its last sieve a row without a share is a
    /// note; one with a number where the shares stand is a note only apart from the table, else a sieve that cannot be
    /// read, and an error.
    void sort_rows(std::size_t values, const SheetHeader& header) {
        for (std::size_t k = first_; k < values; ++k) {
            table_.sheet.rows.push_back(sheet_.rows[k]);
        }
        auto rows = find_derived_rows(sheet_, values, end_, [this, &header](const SheetRow& row) {
            return is_whole_sieve(row) || is_washed_mass(row, header);
        });
        const std::vector<bool>& derived = rows.are_derived;
        table_.notes.derived = std::move(rows.values);
        std::size_t last = values;
        for (std::size_t k = values; k < end_; ++k) {
            last = !sheet_.rows[k].is_comment && !derived[k - values] && is_sieve(sheet_.rows[k]) ? k + 1 : last;
        }
        bool is_apart = false, has_begun = false;
        for (std::size_t k = values; k < end_; ++k) {
            const SheetRow& row = sheet_.rows[k];
            if (derived[k - values]) {
                is_apart = k >= last;
                continue;
            }
            is_apart = is_apart || (k >= last && k > values && row.place.line > sheet_.rows[k - 1].place.line + 1);
            has_begun = has_begun || is_sieve(row); // a word below the headings belongs to them
            const bool is_of_samples = !has_begun && read_heading(first_text(row)).kind == ColumnKind::Sample;
            const std::string name = is_of_samples && shares_.size() == 1 ? sample_named_in(row) : "";
            if (!name.empty()) {
                table_.name = name;
            } else if (!row.is_comment && (is_of_samples || (has_begun && is_note(row, k >= last, is_apart)))) {
                table_.notes.others.push_back(row);
                is_apart = k >= last;
            } else {
                table_.sheet.rows.push_back(row);
            }
        }
    }

    [[nodiscard]] bool is_note(const SheetRow& row, bool is_below, bool is_apart) const {
        if (is_sieve(row)) {
            return false;
        }
        const auto count = std::ranges::count_if(row.cells, [](const SheetCell& cell) { return !is_blank(cell.text); });
        const bool is_worded = has_word(first_text(row));
        return is_below ? is_worded && (is_apart || !has_share(row)) : is_worded && count == 1;
    }

    const Sheet& sheet_;
    std::size_t first_, header_, end_;
    std::vector<std::size_t> sizes_, shares_;
    SheetTable table_;
};

/// Rows in which the tables of a sheet begin with their headings.
std::vector<std::size_t> find_headers(const Sheet& sheet) {
    std::vector<std::size_t> headers;
    const auto first = find_sheet_header(sheet);
    if (!first) {
        return headers;
    }
    headers.push_back(first->row);
    bool has_values = false;
    for (std::size_t k = first->row + first->lines; k < sheet.rows.size(); ++k) {
        const SheetRow& row = sheet.rows[k];
        if (row.is_comment) {
            continue;
        }
        if (has_values && !has_number(row) && is_complete_header(row)) {
            headers.push_back(k), has_values = false;
        }
        has_values = has_values || has_number(row);
    }
    return headers;
}

/// Where a table of something else begins, apart from the one above: headings of three columns at least, none of them a
/// number or a result of the curve, above a row of as many cells with a number. @return `end` where there is none
std::size_t find_other_table(const Sheet& sheet, std::size_t first, std::size_t end) {
    constexpr std::size_t least = 3;
    for (std::size_t k = first + 1; k + 1 < end; ++k) {
        const SheetRow &row = sheet.rows[k], &below = sheet.rows[k + 1], &above = sheet.rows[k - 1];
        const bool is_apart = above.is_comment || row.place.line > above.place.line + 1;
        const bool are_words = std::ranges::none_of(row.cells, [](const SheetCell& cell) {
            return is_blank(cell.text) || plain_number(cell.text, true) || read_derived_name(cell.text) ||
                   read_row_word(cell.text) != RowWord::None;
        });
        if (!row.is_comment && is_apart && are_words && has_number(below) && row.cells.size() >= least &&
            below.cells.size() == row.cells.size()) {
            return k;
        }
    }
    return end;
}

/// Titles of a table that is not the first: the rows behind what ends the one before it, above its headings. A number
/// stands in a title only where it is the dry mass.
std::size_t first_title(const Sheet& sheet, std::size_t header) {
    std::size_t first = header;
    while (first > 0 && !sheet.rows[first - 1].is_comment) {
        const SheetRow& row = sheet.rows[first - 1];
        const bool is_worded = !has_number(row) && std::ranges::none_of(row.cells, [](const SheetCell& cell) {
            return read_row_word(cell.text) != RowWord::None;
        });
        const bool is_title = is_worded || dry_mass_in(sheet, row);
        if (!is_title || !read_derived(sheet, row).empty()) {
            break;
        }
        --first;
    }
    return first;
}

} // namespace

std::vector<SheetTable> cut_tables(const Sheet& sheet, Problems& problems) {
    if (auto turned = turn_table(sheet, problems)) { // with the unit that its titles state
        std::vector<SheetTable> tables;
        tables.push_back(std::move(*turned));
        return tables;
    }
    const auto header = find_sheet_header(sheet);
    if (!header || !header->is_complete) {
        if (auto tables = read_percentiles(sheet, problems); !tables.empty()) {
            return tables;
        }
    }
    const auto headers = find_headers(sheet);
    if (headers.empty()) {
        std::vector<SheetTable> tables(1);
        tables.front().sheet = sheet;
        return tables;
    }
    std::vector<SheetTable> tables;
    std::vector<std::string> titles;
    std::size_t first = 0;
    StatedUnit unit;
    for (std::size_t k = 0; k < headers.size(); ++k) {
        unit = find_size_unit(sheet, first, headers[k], unit);
        const std::size_t end =
            k + 1 < headers.size() ? std::max(first_title(sheet, headers[k + 1]), headers[k] + 1) : sheet.rows.size();
        const std::size_t other = find_other_table(sheet, headers[k] + 1, end);
        if (other < end) {
            problems.warning(
                sheet_remark, sheet.rows[other].place, "skipped from here on: a table that holds no grading"
            );
        }
        titles.push_back(plain_name_above(sheet, first, headers[k]));
        for (SheetTable& part : split_side_by_side(TableCutter(sheet, first, headers[k], other).cut(), problems)) {
            part.size_unit = unit;
            tables.push_back(std::move(part));
        }
        first = end;
    }
    take_plain_names(titles, tables);
    return tables;
}

void remark_on_notes(const TableNotes& notes, Problems& problems) {
    constexpr std::size_t most = 8;
    std::vector<std::string> names, results;
    for (const SheetRow& row : notes.others) {
        if (names.size() < most && !is_blank(first_text(row))) {
            names.push_back(fmt::format("`{}`", first_text(row)));
        }
    }
    for (const DerivedValue& value : notes.derived) {
        if (value.kind == DerivedValue::Kind::Loss && value.value) { // has a remark of its own
            continue;
        }
        results.push_back(fmt::format("`{}`", value.name));
        if (std::ranges::count(results, results.back()) > 1) {
            results.pop_back();
        }
    }
    if (!names.empty()) {
        const std::size_t left = notes.others.size() - names.size();
        problems.warning(
            sheet_remark, notes.others.front().place,
            fmt::format(
                "skipped as notes because they are not sieves: {}{}", fmt::join(names, ", "),
                left > 0 ? fmt::format(" and {} more", left) : ""
            ),
            "begin notes with # to keep this quiet"
        );
    }
    if (!results.empty()) {
        problems.warning(
            sheet_remark, notes.derived.front().place,
            fmt::format("skipped as results because they are not sieves: {}", fmt::join(results, ", "))
        );
    }
}

} // namespace suffuse::gradings
