#include "suffuse/gradings/turned_table.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/gradings/numbered_samples.hpp"
#include "suffuse/gradings/sheet_header.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <set>

namespace suffuse::gradings {

namespace {

constexpr std::size_t least_sieves = 3; // two sizes in a row may be a number and its opening

/// The size that a heading is or holds; empty where it has none.
std::string size_in_heading(std::string_view text, bool may_be_plain) {
    if (plain_number(text, true)) {
        return may_be_plain ? std::string(trimmed(text)) : "";
    }
    const std::size_t open = text.find_first_of("([");
    const bool is_name = open != std::string_view::npos && !read_sieve_size(text.substr(0, open), SizeScale::Unknown);
    if (!is_name && read_sieve_size(text, SizeScale::Unknown)) { // "TP2 (0.5 m)" is a sample
        return std::string(trimmed(text));
    }
    return size_among_words(text);
}

/// "% < 20 mm", "< 20 mm (%)": without the unit of the share.
std::string without_percent(std::string_view text) {
    std::string plain;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const bool is_unit = text.substr(k, 3) == "(%)" || text.substr(k, 3) == "[%]";
        k += is_unit ? 2U : 0U;
        plain += is_unit || text[k] == '%' ? ' ' : text[k];
    }
    return std::string(trimmed(plain));
}

/// Whether a heading says which share it holds.
bool is_stated(const Heading& heading) {
    return heading.kind == ColumnKind::Share && heading.meaning != ShareMeaning::Cumulative &&
           heading.meaning != ShareMeaning::Unstated;
}

/// "(um)", "[mm]": without the brackets.
std::string plain_unit(std::string_view text) {
    text = trimmed(text);
    const bool is_bracketed = text.size() > 1 && (text.front() == '(' || text.front() == '[');
    return std::string(is_bracketed ? trimmed(text.substr(1, text.size() - 2)) : text);
}

/// The row in which the sieves stand, their columns, and what its first cell says of them.
struct SieveRowAcross {
    std::size_t row = 0;
    std::vector<std::size_t> columns;
    std::vector<std::string> sizes;
    Heading label;
    std::vector<std::string> headings; ///< of all columns
    bool are_passing = false;          ///< "< 20 mm", "Passing 2 mm (%)": what passes them
};

class TableTurner {
public:
    TableTurner(const Sheet& sheet, Problems& problems) : sheet_(sheet), problems_(problems) {}

    std::optional<SheetTable> turn() {
        for (std::size_t k = 0; k < std::min(sheet_.rows.size(), most_titles); ++k) {
            if (!sheet_.rows[k].is_comment && read_sieves(k) && has_samples()) {
                return build();
            }
        }
        return std::nullopt;
    }

private:
    /// Sizes in the cells of a row: with units, or plain under a word for sieves or samples, of falling or rising size.
    bool read_sieves(std::size_t row_number) {
        const SheetRow& row = sheet_.rows[row_number];
        const bool has_label = !row.cells.empty() && !is_size(sheet_, row, 0); // "4.75 mm" names its unit, too
        across_ = {row_number, {}, {}, {}, headings_of(row_number)};
        const bool is_result = has_label && read_derived_name(across_.headings.front()); // "Dmax (mm)"
        across_.label = has_label && !is_result ? read_heading(across_.headings.front()) : Heading{};
        const bool is_sample = across_.label.kind == ColumnKind::Sample; // whose meters are those of a depth
        if (across_.label.scale == SizeScale::Unknown || (is_sample && across_.label.scale == SizeScale::Meters)) {
            across_.label.scale = scale_next_to(row);
        }
        std::vector<double> diameters;
        const auto finer = [&row](std::size_t k) { // "% < 20 mm"
            const SizeText text = split_size_text(without_percent(row.cells[k].text));
            return text.sense == SizeSense::Finer && read_row_word(row.cells[k].text) == RowWord::None
                       ? std::optional(text.text)
                       : std::nullopt;
        };
        std::size_t passing = 0;
        for (std::size_t k = 0; k < row.cells.size(); ++k) {
            passing += finer(k) ? 1U : 0U;
        }
        across_.are_passing = passing > 1; // there is one pan
        const bool is_labeled = across_.label.kind == ColumnKind::Size || across_.label.kind == ColumnKind::Sample;
        for (std::size_t k = 0; k < row.cells.size(); ++k) {
            const std::string& cell = row.cells[k].text;
            const auto passed = across_.are_passing ? finer(k) : std::nullopt;
            if (read_row_word(cell) != RowWord::None || (!passed && split_size_text(cell).sense == SizeSense::Finer)) {
                across_.columns.push_back(k), across_.sizes.push_back(cell); // the pan stands among them
                continue;
            }
            const std::string text = size_in_heading(passed.value_or(cell), is_labeled);
            const auto size = read_sieve_size(text, across_.label.scale, commas_are_decimal(sheet_));
            if (!size) {
                continue;
            }
            across_.columns.push_back(k), across_.sizes.push_back(text);
            diameters.push_back(size->diameter);
        }
        const bool falls = std::ranges::is_sorted(diameters, std::greater_equal{});
        const bool rises = std::ranges::is_sorted(diameters, std::less_equal{});
        return diameters.size() >= least_sieves && (falls || rises);
    }

    /// What heads each column: in the row of sieves, else right above it: "Borehole,Depth,Passing,," and ",,#4,#200".
    [[nodiscard]] std::vector<std::string> headings_of(std::size_t row) const {
        const SheetRow &own = sheet_.rows[row], &above = goes_on(row) ? sheet_.rows[row - 1] : own;
        std::vector<std::string> headings;
        for (std::size_t k = 0; k < own.cells.size() || !text_at(above, k).empty(); ++k) {
            headings.push_back(text_at(own, k).empty() ? text_at(above, k) : text_at(own, k));
        }
        return headings;
    }

    /// Whether a row goes on with headings right above it: its first cell has none.
    [[nodiscard]] bool goes_on(std::size_t row) const {
        return row > 0 && !sheet_.rows[row - 1].is_comment && text_at(sheet_.rows[row], 0).empty() &&
               sheet_.rows[row - 1].place.line + 1 == sheet_.rows[row].place.line;
    }

    /// "Sieve,um,2000,850": the unit in a cell of its own before the sizes.
    [[nodiscard]] SizeScale scale_next_to(const SheetRow& row) const {
        for (std::size_t k = 1; k < row.cells.size() && !is_size(sheet_, row, k); ++k) {
            const std::string plain = plain_unit(row.cells[k].text);
            if (size_scale_of(plain) != SizeScale::Unknown) {
                return size_scale_of(plain);
            }
        }
        return SizeScale::Unknown;
    }

    [[nodiscard]] bool is_sieve(std::size_t column) const {
        return std::ranges::find(across_.columns, column) != across_.columns.end();
    }

    [[nodiscard]] bool is_sample(const SheetRow& row) const {
        const auto numbers = std::ranges::count_if(across_.columns, [&](std::size_t k) {
            return number_at(sheet_, row, k).has_value() && size_in_heading(text_at(row, k), false).empty();
        });
        return !row.is_comment && numbers > 1;
    }

    /// Rows of numbers below. Where these begin with sizes, what is above the others are samples or their depths.
    bool has_samples() {
        samples_.clear(), others_.clear();
        bool begin_with_sizes = true;
        const std::size_t first = across_.row + 1;
        const auto derived = find_derived_rows(sheet_, first, sheet_.rows.size(), [this](const SheetRow& row) {
            return is_sample(row);
        });
        derived_ = derived.values;
        for (std::size_t k = first; k < sheet_.rows.size(); ++k) {
            const SheetRow& row = sheet_.rows[k];
            if (derived.are_derived[k - first]) {
                continue;
            }
            if (is_sample(row)) {
                samples_.push_back(&row);
                begin_with_sizes = begin_with_sizes && across_.columns.front() > 0 && is_size(sheet_, row, 0);
            } else if (!row.is_comment) {
                others_.push_back(row);
            }
        }
        const bool has_no_label = across_.columns.front() > 0 && is_blank(text_at(sheet_.rows[across_.row], 0));
        return !samples_.empty() &&
               !(begin_with_sizes && (across_.label.kind == ColumnKind::Size || has_no_label ||
                                      numbers_samples(sheet_, across_.row, across_.columns, samples_)));
    }

    /// What the shares are: by the words of the rows, of the sieves' headings, or of the titles.
    [[nodiscard]] Heading find_meaning() const {
        const SheetRow& sieves = sheet_.rows[across_.row];
        Heading heading = read_heading(sieves.cells[across_.columns.front()].text);
        if (heading.kind == ColumnKind::Tare) { // "Sieve_2000um_g": of many sieves, what each keeps
            heading.kind = ColumnKind::Share, heading.meaning = ShareMeaning::Retained;
        }
        if (across_.are_passing && !is_stated(heading)) {
            heading.kind = ColumnKind::Share, heading.meaning = ShareMeaning::Passing;
        }
        if (is_stated(heading)) {
            heading.scale = SizeScale::Unknown;
            return heading;
        }
        for (std::size_t k = 0; k <= across_.row; ++k) {
            for (const SheetCell& cell : sheet_.rows[k].cells) {
                heading = read_heading(cell.text);
                if (is_stated(heading) && heading.unit != ShareUnit::Unknown && !read_derived_name(cell.text)) {
                    return heading;
                }
            }
        }
        heading = {};
        heading.kind = ColumnKind::Share, heading.meaning = ShareMeaning::Unstated;
        return heading;
    }

    /// Columns of names, boreholes and depths; else the first that is no sieve's.
    [[nodiscard]] std::vector<std::size_t> find_keys() const {
        std::vector<std::size_t> keys, others;
        for (std::size_t k = 0; k < across_.headings.size(); ++k) {
            if (!is_sieve(k) && !read_derived_name(across_.headings[k])) {
                (read_heading(across_.headings[k]).kind == ColumnKind::Sample ? keys : others).push_back(k);
            }
        }
        return !keys.empty() || others.empty() ? keys : std::vector<std::size_t>{others.front()};
    }

    std::string name_of(const SheetRow& row, const std::vector<std::size_t>& keys) {
        std::string name;
        for (const std::size_t k : keys) {
            append_word(name, text_at(row, k));
        }
        name = name.empty() ? fmt::format("line {}", row.place.line) : name;
        if (!names_.insert(name).second) {
            name += fmt::format(" (line {})", row.place.line);
        }
        return name;
    }

    /// What stands beyond the last heading is of no sieve, and no row may lose it.
    void check_widths() {
        const std::size_t columns = across_.headings.size();
        for (const SheetRow* row : samples_) {
            if (row->cells.size() > columns) {
                problems_.error(
                    "E502", row->place,
                    fmt::format("{} values where the header names {} columns", row->cells.size(), columns),
                    "one value for each column; where numbers have a decimal comma, columns are separated by ;"
                );
            }
        }
    }

    void check_diameters() {
        const SheetRow& heads = sheet_.rows[across_.row];
        if (across_.label.kind == ColumnKind::Size && names_no_diameter(across_.label, across_.headings.front())) {
            complain_about_diameters(heads.cells.front().place, across_.headings.front(), problems_);
        }
    }

    /// A page may repeat the sieves; other sieves would be those of the samples below them.
    void check_second_heads() {
        const SheetRow& heads = sheet_.rows[across_.row];
        for (const SheetRow& row : others_) {
            const auto sizes = std::ranges::count_if(row.cells, [](const SheetCell& cell) {
                return !size_in_heading(cell.text, false).empty();
            });
            const bool is_repeated = std::ranges::all_of(across_.columns, [&](std::size_t k) {
                return text_at(row, k) == heads.cells[k].text;
            });
            if (sizes >= static_cast<std::ptrdiff_t>(least_sieves) && !is_repeated) {
                problems_.error(
                    "E502", row.place, "a second row of sieves that differs from the first",
                    "keep each table with its sieves in a file of its own"
                );
            }
        }
    }

    /// Rows of one sample that are named as passing and retained: "Passing (%),100,98". Those of the surest meaning.
    [[nodiscard]] std::vector<std::pair<const SheetRow*, Heading>> rows_by_meaning() const {
        std::vector<std::pair<const SheetRow*, Heading>> rows;
        for (const SheetRow* row : samples_) {
            Heading heading = read_heading(text_at(*row, 0));
            if (across_.columns.front() > 0 && is_stated(heading)) {
                rows.emplace_back(row, std::move(heading));
            }
        }
        const auto meaning_of = [](const auto& row) { return row.second.meaning; };
        const auto surest = std::ranges::min_element(rows, {}, meaning_of);
        const ShareMeaning meaning = surest == rows.end() ? ShareMeaning::Passing : meaning_of(*surest);
        std::erase_if(rows, [&](const auto& row) { return meaning_of(row) != meaning; });
        return rows;
    }

    SheetTable build() {
        SheetTable table;
        table.sheet.mark = sheet_.mark;
        GradingColumns columns;
        columns.first_row = 1, columns.size.scale = across_.label.scale;
        const Heading meaning = find_meaning();
        const auto named = rows_by_meaning();
        const auto keys = named.empty() ? find_keys() : std::vector<std::size_t>{};
        const SheetRow& heads = sheet_.rows[across_.row];
        check_widths();
        check_second_heads();
        check_diameters();
        SheetRow first{{heads.cells.front()}, heads.place, false};
        std::vector<const SheetRow*> taken;
        for (const SheetRow* row : samples_) {
            const auto own = std::ranges::find(named, row, &std::pair<const SheetRow*, Heading>::first);
            if (!named.empty() && own == named.end()) {
                table.notes.others.push_back(*row);
                continue;
            }
            const Heading& heading = own == named.end() ? meaning : own->second;
            const std::string name = own == named.end() ? name_of(*row, keys) : heading.rest;
            columns.shares.push_back(
                {first.cells.size(), {}, name, heading.meaning, heading.unit, is_stated(heading), heading.mass_unit}
            );
            columns.shares.back().counts_grains = heading.counts_grains;
            first.cells.push_back({name, row->place, false});
            taken.push_back(row);
        }
        table.sheet.rows.push_back(std::move(first));
        for (std::size_t k = 0; k < across_.columns.size(); ++k) {
            const SheetCell& head = heads.cells[across_.columns[k]];
            SheetRow line{{head}, head.place, false};
            line.cells.back().text = across_.sizes[k];
            for (const SheetRow* row : taken) {
                line.cells.push_back(cell_at(*row, across_.columns[k]));
            }
            table.sheet.rows.push_back(std::move(line));
        }
        add_derived(taken, table);
        for (const SheetRow* title : value_rows(sheet_, 0, across_.row - (goes_on(across_.row) ? 1U : 0U))) {
            table.notes.others.push_back(*title);
        }
        table.notes.others.insert(table.notes.others.end(), others_.begin(), others_.end());
        table.columns = std::move(columns);
        table.size_unit = find_size_unit(sheet_, 0, across_.row + 1);
        remark(taken.size(), keys);
        return table;
    }

    /// "D10", "Gravel %" next to the sieves: of the sample of the row; below all samples: of the only one.
    void add_derived(const std::vector<const SheetRow*>& rows, SheetTable& table) {
        table.notes.derived = std::move(derived_);
        for (DerivedValue& value : table.notes.derived) {
            value.column = std::string::npos;
        }
        for (std::size_t k = 0; k < rows.size(); ++k) {
            for (DerivedValue value : read_derived_below(sheet_, sheet_.rows[across_.row], *rows[k])) {
                if (!is_sieve(value.column) && value.value && value.kind != DerivedValue::Kind::Other) {
                    value.column = k + 1;
                    table.notes.derived.push_back(std::move(value));
                }
            }
        }
    }

    void remark(std::size_t samples, const std::vector<std::size_t>& keys) {
        std::vector<std::string> unread;
        const SheetRow& row = sheet_.rows[across_.row];
        for (std::size_t k = 0; k < across_.headings.size(); ++k) {
            const std::string& heading = across_.headings[k];
            const bool is_read = is_sieve(k) || std::ranges::find(keys, k) != keys.end() || (keys.empty() && k == 0);
            const auto derived = read_derived_name(heading);
            const bool is_compared = derived && derived->kind != DerivedValue::Kind::Other;
            const bool is_unit = size_scale_of(plain_unit(heading)) != SizeScale::Unknown;
            if (!is_unit && !is_read && !is_blank(heading) && !is_compared) {
                unread.push_back(fmt::format("`{}`", heading));
            }
        }
        problems_.warning(
            sheet_remark, row.place,
            fmt::format(
                "the sieves are in columns, and each line is a sample: {} sieves, {} {}{}{}", across_.columns.size(),
                samples, samples == 1 ? "sample" : "samples",
                unread.empty() ? "" : "; not read: ", fmt::join(unread, ", ")
            )
        );
    }

    const Sheet& sheet_;
    Problems& problems_;
    SieveRowAcross across_;
    std::vector<const SheetRow*> samples_;
    std::vector<SheetRow> others_;
    std::vector<DerivedValue> derived_;
    std::set<std::string> names_;
};

} // namespace

std::optional<SheetTable> turn_table(const Sheet& sheet, Problems& problems) {
    return TableTurner(sheet, problems).turn();
}

} // namespace suffuse::gradings
