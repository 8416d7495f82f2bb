#include "suffuse/gradings/named_columns.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/gradings/lexicon.hpp"
#include "suffuse/gradings/sheet_header.hpp"
#include "suffuse/gradings/turned_table.hpp"
#include "suffuse/gradings/unnamed_shares.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace suffuse::gradings {

namespace {

/// Which shares are named, and by which option.
struct NamedShare {
    const char* option = "";
    NamedColumn column;
    ShareMeaning meaning = ShareMeaning::Passing;
};

class NamedColumnReader {
public:
    NamedColumnReader(const Sheet& sheet, const ReadingOptions& options, Problems& problems)
        : sheet_(sheet), options_(options), problems_(problems), width_(width_of(value_rows(sheet, 0))),
          size_(split_column(options.size)),
          lines_(split_lines(options.rows).value_or(std::pair{1, std::numeric_limits<int>::max()})) {}

    std::optional<SheetTable> read() {
        auto table = !choose_share() ? std::nullopt : size_.name == "across" ? read_across() : read_down();
        return table && apply_units(*table->columns) ? std::move(table) : std::nullopt;
    }

private:
    struct Located {
        std::size_t column = 0;
        std::optional<std::size_t> row; ///< of its heading
    };

    void complain(const std::string& what, const std::string& advice) {
        const auto rows = value_rows(sheet_, 0);
        problems_.error("E506", (rows.empty() ? sheet_.rows.front() : *rows.front()).place, what, advice);
    }

    /// One of four options says what the shares are.
    bool choose_share() {
        const std::array all{
            NamedShare{"passing", split_column(options_.passing), ShareMeaning::Passing},
            NamedShare{"retained", split_column(options_.retained), ShareMeaning::CumulativeRetained},
            NamedShare{"share", split_column(options_.share), ShareMeaning::OnSieve},
            NamedShare{"mass", split_column(options_.mass), ShareMeaning::OnSieve}};
        const auto is_given = [](const NamedShare& share) { return !share.column.name.empty(); };
        if (options_.size.empty() || std::ranges::count_if(all, is_given) != 1) {
            complain(
                "columns are named by `size` and one of `passing`, `retained`, `share` and `mass`",
                "as in --size 1:mm --passing 2"
            );
            return false;
        }
        share_ = *std::ranges::find_if(all, is_given);
        return true;
    }

    std::optional<Located> locate(const char* option, const std::string& name) {
        const auto number = io::number_of<std::size_t>(name);
        if (number && *number > 0 && *number <= width_) {
            return Located{*number - 1, {}};
        }
        for (std::size_t k = 0; k < sheet_.rows.size(); ++k) {
            for (std::size_t c = 0; c < sheet_.rows[k].cells.size(); ++c) {
                if (edit_distance(sheet_.rows[k].cells[c].text, name) == 0) {
                    return Located{c, k};
                }
            }
        }
        complain(
            fmt::format("{}: there is no column `{}`", option, name),
            fmt::format("a heading of the file, or a number from 1 to {}", width_)
        );
        return std::nullopt;
    }

    [[nodiscard]] bool has_share(const SheetRow& row) const {
        return std::ranges::any_of(shares_, [&](std::size_t k) { return number_at(sheet_, row, k).has_value(); });
    }

    [[nodiscard]] bool is_value(const SheetRow& row) const {
        return is_size(sheet_, row, size_column_) || read_row_word(text_at(row, size_column_)) != RowWord::None ||
               has_share(row) || has_numbers(row);
    }

    [[nodiscard]] bool is_within_lines(const SheetRow& row) const {
        return !row.is_comment && row.place.line >= lines_.first && row.place.line <= lines_.second;
    }

    /// Whether a row that cannot be read holds values nevertheless: a number in place of the size, and one of a share.
    [[nodiscard]] bool has_numbers(const SheetRow& row) const {
        constexpr std::string_view digits = "0123456789";
        const std::string& size = text_at(row, size_column_);
        const std::size_t number = size.find_first_not_of("<>~=+-. \u2264\u2265\u2248");
        return number != std::string::npos && is_digit(size[number]) &&
               std::ranges::any_of(shares_, [&](std::size_t k) {
                   return text_at(row, k).find_first_of(digits) != std::string::npos;
               });
    }

    /// Where the values begin: a size with a share, or what cannot be read right above.
    [[nodiscard]] std::size_t find_first_value(std::size_t from) const {
        const auto begin = sheet_.rows.begin() + static_cast<std::ptrdiff_t>(from);
        auto first = std::find_if(begin, sheet_.rows.end(), [this](const SheetRow& row) {
            return is_within_lines(row) && is_size(sheet_, row, size_column_) && has_share(row);
        });
        while (first != sheet_.rows.end() && first != begin && is_within_lines(*std::prev(first)) &&
               has_numbers(*std::prev(first))) {
            --first;
        }
        return static_cast<std::size_t>(first - sheet_.rows.begin());
    }

    /// Headings of the row that names a column, else of the last row without a number above the values.
    [[nodiscard]] std::vector<Heading> read_headings(std::optional<std::size_t>& row, std::size_t first) const {
        for (std::size_t k = first; !row && k-- > 0;) {
            const bool may_be = !has_number(sheet_.rows[k]) && sheet_.rows[k].cells.size() > 1;
            row = may_be ? std::optional(k) : row;
        }
        std::vector<Heading> headings;
        for (std::size_t c = 0; row && c < sheet_.rows[*row].cells.size(); ++c) {
            headings.push_back(read_heading(sheet_.rows[*row].cells[c].text));
        }
        if (row && *row + 1 < first) {
            take_unit_row(sheet_.rows[*row + 1], headings);
        }
        headings.resize(width_);
        return headings;
    }

    std::optional<SheetTable> read_down() {
        const bool is_all = share_.column.name == "all";
        const auto size = locate("size", size_.name);
        const auto share = !size || is_all ? size : locate(share_.option, share_.column.name);
        if (!share) {
            return std::nullopt;
        }
        if (!is_all && share->column == size->column) {
            complain(
                fmt::format("column {} is named twice: as size and as {}", size->column + 1, share_.option),
                "one column of sizes and another of shares"
            );
            return std::nullopt;
        }
        size_column_ = size->column;
        for (std::size_t k = 0; k < width_; ++k) {
            if (is_all ? k != size_column_ : k == share->column) {
                shares_.push_back(k);
            }
        }
        std::optional<std::size_t> header = size->row ? size->row : share->row;
        const std::size_t first = find_first_value(header ? *header + 1 : 0);
        if (first == sheet_.rows.size()) {
            complain(
                fmt::format("no line has a size in column {} and a number in that of the shares", size_column_ + 1),
                "look at the file: are these the columns?"
            );
            return std::nullopt;
        }
        const std::vector<Heading> headings = read_headings(header, first);
        std::vector<std::size_t> keys;
        for (std::size_t k = 0; k < headings.size(); ++k) {
            const bool is_used = k == size_column_ || (!is_all && std::ranges::find(shares_, k) != shares_.end());
            if (headings[k].kind == ColumnKind::Sample && !is_used) {
                keys.push_back(k);
            }
        }
        std::erase_if(shares_, [&](std::size_t k) {
            const auto numbers = std::ranges::count_if(value_rows(sheet_, first), [&](const SheetRow* row) {
                return number_at(sheet_, *row, k).has_value();
            });
            const std::string& heading = header ? text_at(sheet_.rows[*header], k) : text_at({}, k);
            const bool is_no_soil = headings[k].kind == ColumnKind::Sample || is_index(sheet_, first, k, heading);
            return is_all && (numbers < 2 || is_no_soil);
        });
        if (shares_.empty()) {
            complain(fmt::format("{}: no column has two numbers", share_.option), "name the column of shares");
            return std::nullopt;
        }
        return build(header, first, headings, keys);
    }

    /// Of one soil among several, by its heading; with its column where that is blank, or that of another, too.
    [[nodiscard]] std::string name_of(const SheetRow& header, std::size_t k) const {
        if (shares_.size() == 1) {
            return "";
        }
        const std::string& heading = text_at(header, k + 1);
        const auto same = std::ranges::count(header.cells.begin() + 1, header.cells.end(), heading, &SheetCell::text);
        const std::string column = fmt::format("column {}", shares_[k] + 1);
        return is_blank(heading) ? column : same > 1 ? fmt::format("{} ({})", heading, column) : heading;
    }

    SheetTable build(
        std::optional<std::size_t> header, std::size_t first, const std::vector<Heading>& headings,
        const std::vector<std::size_t>& keys
    ) {
        std::vector<std::size_t> taken{size_column_};
        taken.insert(taken.end(), shares_.begin(), shares_.end());
        taken.insert(taken.end(), keys.begin(), keys.end());
        const auto cut = [&taken](const SheetRow& row) {
            SheetRow part{{}, row.place, row.is_comment};
            for (const std::size_t k : taken) {
                part.cells.push_back(cell_at(row, k));
            }
            return part;
        };
        SheetTable table;
        table.sheet.mark = sheet_.mark;
        table.sheet.rows.push_back(cut(header ? sheet_.rows[*header] : SheetRow{{}, sheet_.rows[first].place, false}));
        for (const SheetRow* row : value_rows(sheet_, first)) {
            if (row->place.line > lines_.second) {
                break;
            }
            if (!is_value(*row)) {
                problems_.warning(columns_end, row->place, "the named columns are read down to this line");
                break;
            }
            table.sheet.rows.push_back(cut(*row));
        }
        GradingColumns columns;
        columns.first_row = 1;
        columns.size = {0, headings[size_column_].scale};
        columns.stated_unit = find_size_unit(sheet_, 0, first);
        for (std::size_t k = 0; k < shares_.size(); ++k) {
            const Heading& heading = headings[shares_[k]];
            columns.shares.push_back(
                {k + 1, {}, name_of(table.sheet.rows.front(), k), share_.meaning, heading.unit, true, heading.mass_unit}
            );
        }
        for (std::size_t k = 0; k < keys.size(); ++k) {
            columns.sample_key.push_back(1 + shares_.size() + k);
        }
        table.columns = std::move(columns);
        return table;
    }

    std::optional<SheetTable> read_across() {
        auto table = turn_table(sheet_, problems_);
        if (!table) {
            complain("size: no line has sizes in its columns", "name the column of sizes: --size 1:mm");
            return std::nullopt;
        }
        std::erase_if(table->columns->shares, [this](const ShareColumn& share) {
            return share_.column.name != "all" && share.name != share_.column.name;
        });
        if (table->columns->shares.empty()) {
            complain(
                fmt::format("{}: there is no line `{}`", share_.option, share_.column.name),
                "the name of a soil, or `all`"
            );
            return std::nullopt;
        }
        for (ShareColumn& share : table->columns->shares) {
            share.meaning = share_.meaning;
        }
        table->columns->stated_unit = table->size_unit;
        return table;
    }

    /// @return whether the units fit, which is reported otherwise
    bool apply_units(GradingColumns& columns) {
        const SizeScale scale = size_scale_of(size_.unit);
        const ShareUnit unit = share_.column.unit == "%" ? ShareUnit::Percent : share_unit_named(share_.column.unit);
        const bool is_mass = std::string_view(share_.option) == "mass";
        if ((!size_.unit.empty() && scale == SizeScale::Unknown) ||
            (!share_.column.unit.empty() && (unit == ShareUnit::Unknown || (is_mass && unit != ShareUnit::Mass)))) {
            complain(
                fmt::format("`{}` and `{}`: a unit does not fit", options_.size, share_.column.unit),
                "sizes in mm, um, cm, m, in, phi or no; shares in %, - or g/kg; masses in g, kg or mg"
            );
            return false;
        }
        columns.size.scale = scale == SizeScale::Unknown ? columns.size.scale : scale;
        for (ShareColumn& share : columns.shares) {
            share.is_named = true;
            share.is_of_largest = share.meaning == ShareMeaning::CumulativeRetained;
            share.unit = is_mass ? ShareUnit::Mass : unit == ShareUnit::Unknown ? share.unit : unit;
            if (unit == ShareUnit::Mass) {
                share.mass_unit = read_heading("mass (" + share_.column.unit + ")").mass_unit;
            }
        }
        return true;
    }

    const Sheet& sheet_;
    const ReadingOptions& options_;
    Problems& problems_;
    std::size_t width_; ///< of its longest row
    NamedColumn size_;
    std::pair<int, int> lines_;
    NamedShare share_;
    std::size_t size_column_ = 0;
    std::vector<std::size_t> shares_;
};

} // namespace

std::optional<SheetTable> read_named_columns(const Sheet& sheet, const ReadingOptions& options, Problems& problems) {
    return NamedColumnReader(sheet, options, problems).read();
}

} // namespace suffuse::gradings
