#include "suffuse/gradings/sheet_tables.hpp"

#include "suffuse/gradings/percentiles.hpp"
#include "suffuse/gradings/sheet_header.hpp"
#include "suffuse/gradings/sheet_titles.hpp"
#include "suffuse/gradings/tables_side_by_side.hpp"
#include "suffuse/gradings/turned_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace suffuse::gradings {

namespace {

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
            sort_rows(first_ + header->row + header->lines);
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
            const auto size =
                std::ranges::find_if(sizes_.rbegin(), sizes_.rend(), [share](std::size_t k) { return k < share; });
            return size != sizes_.rend() && is_size(sheet_, row, *size) && number_at(sheet_, row, share).has_value();
        });
    }

    [[nodiscard]] bool has_share(const SheetRow& row) const {
        return std::ranges::any_of(shares_, [&](std::size_t k) { return number_at(sheet_, row, k).has_value(); });
    }

    /// Values go into the table, derived values and notes out of it. Below its last sieve a row without a share is a
    /// note; one with a number where the shares stand is a note only apart from the table, else a sieve that cannot be
    /// read, and an error.
    void sort_rows(std::size_t values) {
        for (std::size_t k = first_; k < values; ++k) {
            table_.sheet.rows.push_back(sheet_.rows[k]);
        }
        auto rows =
            find_derived_rows(sheet_, values, end_, [this](const SheetRow& row) { return is_whole_sieve(row); });
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
            if (!row.is_comment && has_begun && is_note(row, k >= last, is_apart)) {
                table_.notes.others.push_back(&row);
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
        for (SheetTable& part : split_side_by_side(TableCutter(sheet, first, headers[k], other).cut(), problems)) {
            part.size_unit = unit;
            tables.push_back(std::move(part));
        }
        first = end;
    }
    return tables;
}

void remark_on_notes(const TableNotes& notes, Problems& problems) {
    constexpr std::size_t most = 8;
    std::vector<std::string> names;
    for (const SheetRow* row : notes.others) {
        if (names.size() < most && !is_blank(first_text(*row))) {
            names.push_back(fmt::format("`{}`", first_text(*row)));
        }
    }
    if (!names.empty()) {
        const std::size_t left = notes.others.size() - names.size();
        problems.warning(
            sheet_remark, notes.others.front()->place,
            fmt::format(
                "skipped as notes because they are not sieves: {}{}", fmt::join(names, ", "),
                left > 0 ? fmt::format(" and {} more", left) : ""
            ),
            "begin notes with # to keep this quiet"
        );
    }
    names.clear();
    for (const DerivedValue& value : notes.derived) {
        if (std::ranges::find(names, fmt::format("`{}`", value.name)) == names.end()) {
            names.push_back(fmt::format("`{}`", value.name));
        }
    }
    if (!names.empty()) {
        problems.warning(
            sheet_remark, notes.derived.front().place,
            fmt::format("skipped as results because they are not sieves: {}", fmt::join(names, ", "))
        );
    }
}

} // namespace suffuse::gradings
