#include "suffuse/io/grading_columns.hpp"

#include "suffuse/base/units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace suffuse::io {

namespace {

constexpr std::size_t most_columns = 2000, most_titles = 60;

bool commas_are_decimal(const Sheet& sheet) {
    return sheet.mark != ',';
}

/// A size in the cell, of a notation that needs no scale or as a plain number.
bool is_size(const Sheet& sheet, const SheetRow& row, std::size_t column) {
    return read_sieve_size(text_at(row, column), SizeScale::Unknown, commas_are_decimal(sheet)).has_value();
}

struct Header {
    std::size_t row = 0;
    std::vector<Heading> headings;
    bool is_complete = false; ///< a size and a share
};

bool has_kind(const std::vector<Heading>& headings, ColumnKind kind) {
    return std::ranges::any_of(headings, [kind](const Heading& heading) { return heading.kind == kind; });
}

/// A row of headings: one says size, and no cell of it is one.
std::optional<Header> read_header(const Sheet& sheet, std::size_t row) {
    Header header{row, {}, false};
    bool has_size = false;
    for (const SheetCell& cell : sheet.rows[row].cells) {
        header.headings.push_back(read_heading(cell.text));
        has_size = has_size || header.headings.back().kind == ColumnKind::Size;
    }
    const bool has_share = has_kind(header.headings, ColumnKind::Share) || has_kind(header.headings, ColumnKind::Gross);
    header.is_complete = has_size && has_share;
    return has_size && header.headings.size() > 1 ? std::optional(std::move(header)) : std::nullopt;
}

/// The first complete row of headings, else the first with a size; a comment counts where no other line does.
std::optional<Header> find_header(const Sheet& sheet) {
    std::optional<Header> best;
    for (const bool in_comments : {false, true}) {
        const std::size_t end = std::min(sheet.rows.size(), most_titles);
        for (std::size_t k = 0; k < end; ++k) {
            if (sheet.rows[k].is_comment != in_comments) {
                continue;
            }
            const bool is_value = !in_comments && sheet.rows[k].cells.size() > 1 && is_size(sheet, sheet.rows[k], 0) &&
                                  number_at(sheet, sheet.rows[k], 1);
            auto header = is_value ? std::nullopt : read_header(sheet, k);
            if (header && header->is_complete) {
                return header;
            }
            if (header && !best && !in_comments) {
                best = std::move(header);
            }
        }
        if (best) {
            return best;
        }
    }
    return best;
}

/// "mm,%": a row without a number, in which every cell is a unit.
bool take_unit_row(const SheetRow& row, std::vector<Heading>& headings) {
    std::vector<Heading> units;
    for (std::size_t k = 0; k < headings.size(); ++k) {
        const std::string& text = text_at(row, k);
        const std::string bracketed = text.starts_with('[') || text.starts_with('(') ? text : "(" + text + ")";
        units.push_back(read_heading("x " + bracketed));
        const bool is_unit = units.back().unit != ShareUnit::Unknown || units.back().scale != SizeScale::Unknown;
        if ((!is_unit && !is_blank(text)) || text.find_first_of("0123456789") != std::string::npos) {
            return false;
        }
    }
    for (std::size_t k = 0; k < headings.size(); ++k) {
        headings[k].unit = units[k].unit == ShareUnit::Unknown ? headings[k].unit : units[k].unit;
        headings[k].scale = units[k].scale == SizeScale::Unknown ? headings[k].scale : units[k].scale;
    }
    return true;
}

class ColumnFinder {
public:
    ColumnFinder(const Sheet& sheet, Problems& problems) : sheet_(sheet), problems_(problems) {}

    std::optional<GradingColumns> find() {
        if (const auto header = find_header(sheet_)) {
            return by_header(*header);
        }
        return by_numbers();
    }

private:
    std::optional<GradingColumns> by_header(const Header& header) {
        header_ = &sheet_.rows[header.row];
        headings_ = header.headings;
        found_.first_row = header.row + 1;
        if (found_.first_row < sheet_.rows.size() && take_unit_row(sheet_.rows[found_.first_row], headings_)) {
            ++found_.first_row;
        }
        tell_titles(header.row);
        if (!check_units() || !choose_size() || !choose_shares()) {
            return std::nullopt;
        }
        tell_unread();
        return found_;
    }

    /// Titles and notes above the headings.
    void tell_titles(std::size_t header_row) {
        for (std::size_t k = 0; k < header_row; ++k) {
            if (!sheet_.rows[k].is_comment) {
                problems_.warning(
                    sheet_remark, sheet_.rows[k].place,
                    fmt::format("passed over as a title: the columns are named in line {}", header_->place.line),
                    "begin titles with # to keep this quiet"
                );
            }
        }
    }

    /// Units in brackets that no size and no share has.
    bool check_units() {
        bool is_good = true;
        for (std::size_t k = 0; k < headings_.size(); ++k) {
            const Heading& heading = headings_[k];
            const bool is_size = heading.kind == ColumnKind::Size;
            const bool is_share = heading.kind == ColumnKind::Share && heading.meaning == ShareMeaning::Passing;
            if (is_share && heading.unit == ShareUnit::Mass) {
                complain_about_unit(
                    k, "is a mass, a share is expected",
                    "name it `mass retained on sieve [g]` if it is what sieves keep"
                );
                is_good = false;
            }
            if ((is_size || is_share) && !heading.own_unit.empty()) {
                try {
                    parse_quantity("1 " + heading.own_unit, is_size ? dimension::length : dimension::none);
                } catch (const UnitError& problem) {
                    const bool is_unit =
                        std::string_view(problem.what()).find("unknown") == std::string_view::npos &&
                        std::string_view(problem.what()).find("not a unit") == std::string_view::npos &&
                        heading.own_unit.find(' ') == std::string::npos;
                    if (is_unit) {
                        complain_about_unit(k, problem.what(), problem.help);
                        is_good = false;
                    }
                }
            }
        }
        return is_good;
    }

    void complain_about_unit(std::size_t column, const std::string& what, const std::string& advice) {
        const SheetCell& cell = header_->cells[column];
        problems_.error("E506", cell.place, fmt::format("the column `{}`: {}", cell.text, what), advice);
    }

    /// How sure a column is to hold the sizes; 0: it holds none.
    int rank_of_size(std::size_t column) const {
        const Heading& heading = headings_[column];
        if (heading.kind != ColumnKind::Size) {
            return 0;
        }
        std::size_t sizes = 0, others = 0;
        for (std::size_t k = found_.first_row; k < sheet_.rows.size() && k < found_.first_row + most_titles; ++k) {
            const SheetRow& row = sheet_.rows[k];
            if (!row.is_comment && !is_blank(text_at(row, column)) &&
                read_row_word(text_at(row, column)) == RowWord::None) {
                ++(is_size(sheet_, row, column) ? sizes : others);
            }
        }
        const bool is_metric = heading.scale == SizeScale::Millimeters || heading.scale == SizeScale::Micrometers ||
                               heading.scale == SizeScale::Meters || heading.scale == SizeScale::Centimeters;
        const bool is_nominal = heading.scale == SizeScale::SieveNumber || heading.scale == SizeScale::Inches;
        const bool names_sieve_alone = plain_words(header_->cells[column].text).find("sieve") != std::string::npos;
        return sizes < others ? 1 : is_metric ? 5 : is_nominal ? 2 : names_sieve_alone ? 3 : 4;
    }

    bool choose_size() {
        std::size_t best = headings_.size();
        int best_rank = 0;
        for (std::size_t k = 0; k < headings_.size(); ++k) {
            const int rank = rank_of_size(k);
            if (rank > 0 && rank == best_rank) {
                problems_.error(
                    "E506", header_->cells[k].place,
                    fmt::format("`{}` and `{}` mean the same", header_->cells[best].text, header_->cells[k].text),
                    "leave one of the two columns, or give the other one a name that is not read"
                );
                return false;
            }
            if (rank > best_rank) {
                best = k, best_rank = rank;
            }
        }
        found_.size = {best, headings_[best].scale};
        return true;
    }

    [[nodiscard]] std::vector<std::size_t> columns_of(ColumnKind kind, std::optional<ShareMeaning> meaning = {}) const {
        std::vector<std::size_t> columns;
        for (std::size_t k = 0; k < headings_.size(); ++k) {
            if (headings_[k].kind == kind && (!meaning || headings_[k].meaning == *meaning)) {
                columns.push_back(k);
            }
        }
        return columns;
    }

    bool choose_shares() {
        for (const ShareMeaning meaning :
             {ShareMeaning::Passing, ShareMeaning::CumulativeRetained, ShareMeaning::OnSieve, ShareMeaning::Retained,
              ShareMeaning::Cumulative}) {
            const auto columns = columns_of(ColumnKind::Share, meaning);
            if (!columns.empty()) {
                return take_shares(columns);
            }
        }
        const auto gross = columns_of(ColumnKind::Gross), tare = columns_of(ColumnKind::Tare);
        if (!gross.empty()) {
            return take_weighings(gross, tare);
        }
        return take_unnamed();
    }

    /// One column, or one for each soil; of percents rather than of masses.
    bool take_shares(std::vector<std::size_t> columns) {
        const auto is_percent = [this](std::size_t k) { return headings_[k].unit != ShareUnit::Mass; };
        if (columns.size() > 1 && std::ranges::count_if(columns, is_percent) == 1) {
            columns = {*std::ranges::find_if(columns, is_percent)};
        }
        std::set<std::string> names;
        for (const std::size_t k : columns) {
            const std::string& name = headings_[k].rest;
            if (columns.size() > 1 && (name.empty() || !names.insert(name).second)) {
                const std::size_t other = k == columns.front() ? columns[1] : columns.front();
                problems_.error(
                    "E506", header_->cells[std::max(k, other)].place,
                    fmt::format(
                        "`{}` and `{}` mean the same", header_->cells[std::min(k, other)].text,
                        header_->cells[std::max(k, other)].text
                    ),
                    "leave one of the two columns; where each is a soil, put its name into the heading: `TP1 passing "
                    "[%]`"
                );
                return false;
            }
            found_.shares.push_back(
                {k, {}, columns.size() > 1 ? name : "", headings_[k].meaning, headings_[k].unit, true}
            );
        }
        find_sample_key();
        return true;
    }

    bool take_weighings(const std::vector<std::size_t>& gross, const std::vector<std::size_t>& tare) {
        if (gross.size() != 1 || tare.size() != 1) {
            problems_.error(
                "E506", header_->cells[gross.front()].place,
                fmt::format("{} of sieves with soil and {} of empty sieves", gross.size(), tare.size()),
                "one column of each, as in `mass of sieve [g],mass of sieve + soil [g]`"
            );
            return false;
        }
        found_.shares.push_back({gross.front(), tare.front(), "", ShareMeaning::OnSieve, ShareUnit::Mass, true});
        find_sample_key();
        return true;
    }

    void find_sample_key() {
        for (std::size_t k = 0; k < headings_.size(); ++k) {
            if (headings_[k].kind == ColumnKind::Sample) {
                found_.sample_key.push_back(k);
            }
        }
    }

    /// Columns whose headings say neither: soils, where their numbers rise or fall with the size throughout.
    bool take_unnamed() {
        for (std::size_t k = 0; k < headings_.size(); ++k) {
            const bool may_be = headings_[k].kind == ColumnKind::Other ||
                                (headings_[k].kind == ColumnKind::Sample && !headings_[k].rest.empty());
            if (may_be && is_cumulative_in(found_.size.index, k)) {
                found_.shares.push_back(
                    {k, {}, header_->cells[k].text, ShareMeaning::Cumulative, headings_[k].unit, false}
                );
            }
        }
        if (found_.shares.empty()) {
            problems_.error(
                "E506", header_->place,
                "a grading curve needs a column of sizes and one of percent passing, and `passing` is missing",
                expected_header
            );
            return false;
        }
        for (std::size_t k = 0; k < headings_.size(); ++k) {
            const bool is_share =
                std::ranges::any_of(found_.shares, [k](const auto& share) { return share.index == k; });
            if (headings_[k].kind == ColumnKind::Sample && !is_share) {
                found_.sample_key.push_back(k);
            }
        }
        if (found_.shares.size() == 1) {
            tell_meaning(found_.shares.front().index);
        } else {
            problems_.warning(
                sheet_remark, header_->place,
                fmt::format(
                    "{} columns are read as cumulative shares, each of a soil of its own, for their numbers rise or "
                    "fall throughout",
                    found_.shares.size()
                )
            );
        }
        return true;
    }

    void tell_meaning(std::size_t column) {
        problems_.warning(
            sheet_remark, header_ != nullptr ? place_at(*header_, column) : sheet_.rows[found_.first_row].place,
            fmt::format("column {} is read as a cumulative share, for its numbers rise or fall throughout", column + 1),
            "name it `passing [%]` to say so"
        );
    }

    /// Numbers from 0 to 100 that rise, or fall, as the sizes do, whether these rise or fall.
    bool is_cumulative_in(std::size_t size, std::size_t share) const {
        std::vector<std::pair<double, double>> points;
        for (std::size_t k = found_.first_row; k < sheet_.rows.size(); ++k) {
            const SheetRow& row = sheet_.rows[k];
            if (row.is_comment || is_blank(text_at(row, share)) || read_row_word(text_at(row, size)) != RowWord::None) {
                continue;
            }
            const auto d = read_sieve_size(text_at(row, size), found_.size.scale, commas_are_decimal(sheet_));
            const auto value = number_at(sheet_, row, share);
            if (!d || !value || !(*value >= 0 && *value <= 100.5)) {
                return false;
            }
            points.emplace_back(d->diameter, *value);
        }
        if (found_.size.scale != SizeScale::SieveNumber) {
            std::ranges::stable_sort(points, {}, &std::pair<double, double>::first);
        }
        const auto falls = [](const auto& a, const auto& b) { return b.second < a.second - 0.1; };
        const auto rises = [](const auto& a, const auto& b) { return b.second > a.second + 0.1; };
        const bool never_falls = std::ranges::adjacent_find(points, falls) == points.end();
        const bool never_rises = std::ranges::adjacent_find(points, rises) == points.end();
        return points.size() > 1 && never_falls != never_rises;
    }

    /// No heading: two columns of numbers, of which one can be the sizes alone.
    std::optional<GradingColumns> by_numbers() {
        for (found_.first_row = 0; found_.first_row < sheet_.rows.size(); ++found_.first_row) {
            const SheetRow& row = sheet_.rows[found_.first_row];
            if (!row.is_comment && row.cells.size() == 2 && number_at(sheet_, row, 1) && is_size(sheet_, row, 0)) {
                break;
            }
        }
        const bool has_rows = found_.first_row < sheet_.rows.size();
        const auto all_of_two = [this](const SheetRow& row) { return row.is_comment || row.cells.size() == 2; };
        const bool are_two = has_rows && std::all_of(
                                             sheet_.rows.begin() + static_cast<std::ptrdiff_t>(found_.first_row),
                                             sheet_.rows.end(), all_of_two
                                         );
        const bool first = are_two && may_be_sizes(0, 1), second = are_two && may_be_sizes(1, 0);
        if (first == second) {
            complain_about_header(are_two);
            return std::nullopt;
        }
        found_.size = {first ? 0U : 1U, SizeScale::Unknown};
        found_.shares.push_back({first ? 1U : 0U, {}, "", ShareMeaning::Cumulative, ShareUnit::Unknown, false});
        for (std::size_t k = 0; k < found_.first_row; ++k) {
            if (!sheet_.rows[k].is_comment) {
                if (!is_title(sheet_.rows[k])) {
                    complain_about_header(false);
                    return std::nullopt;
                }
                problems_.warning(
                    sheet_remark, sheet_.rows[k].place, "passed over: it is no row of two numbers",
                    "name the columns in it: `d [mm],passing [%]`"
                );
            }
        }
        problems_.warning(
            sheet_remark, sheet_.rows[found_.first_row].place,
            fmt::format(
                "no names of columns: the {} is read as the size in mm, the other as a cumulative share",
                first ? "first" : "second"
            ),
            "begin with a line `d [mm],passing [%]` to say so"
        );
        return found_;
    }

    /// One cell, or the names that a plotting program gives: nothing that could say of which kind or unit a column is.
    static bool is_title(const SheetRow& row) {
        return row.cells.size() == 1 || std::ranges::all_of(row.cells, [](const SheetCell& cell) {
                   return cell.text.size() < 2; // x, y
               });
    }

    /// Sizes each once, shares from near nothing to 100 (or to 1).
    bool may_be_sizes(std::size_t size, std::size_t share) {
        found_.size = {size, SizeScale::Unknown};
        std::set<double> sizes;
        double most = 0;
        std::size_t rows = 0;
        for (std::size_t k = found_.first_row; k < sheet_.rows.size(); ++k) {
            const SheetRow& row = sheet_.rows[k];
            if (row.is_comment) {
                continue;
            }
            const auto d = read_sieve_size(text_at(row, size), SizeScale::Unknown, commas_are_decimal(sheet_));
            const auto value = number_at(sheet_, row, share);
            if (!d || !value || !(d->diameter > 0)) {
                return false;
            }
            sizes.insert(d->diameter), most = std::max(most, *value), ++rows;
        }
        const bool ends_full = (most >= 90 && most <= 100.1) || (most >= 0.9 && most <= 1.001);
        return rows > 1 && sizes.size() == rows && ends_full && is_cumulative_in(size, share);
    }

    void complain_about_header(bool are_two_columns) {
        const auto first = std::ranges::find_if(sheet_.rows, [](const SheetRow& row) { return !row.is_comment; });
        problems_.error(
            "E506", first != sheet_.rows.end() ? first->place : sheet_.rows.front().place,
            are_two_columns ? "no names of columns, and the numbers do not say which are the sizes"
                            : "a grading curve needs a column of sizes and one of percent passing, and `d` is missing",
            expected_header
        );
    }

    void tell_unread() {
        std::vector<std::string> unread;
        for (std::size_t k = 0; k < headings_.size(); ++k) {
            const bool is_share = std::ranges::any_of(found_.shares, [k](const auto& share) {
                return share.index == k || share.tare == k;
            });
            const bool is_key = std::ranges::find(found_.sample_key, k) != found_.sample_key.end();
            if (!is_share && !is_key && k != found_.size.index && !header_->cells[k].text.empty()) {
                unread.push_back(fmt::format("`{}`", header_->cells[k].text));
            }
        }
        if (!unread.empty()) {
            problems_.warning(
                sheet_remark, header_->place,
                fmt::format(
                    "sizes are read from `{}`, shares from `{}`; not read: {}", header_->cells[found_.size.index].text,
                    header_->cells[found_.shares.front().index].text, fmt::join(unread, ", ")
                )
            );
        }
    }

    const Sheet& sheet_;
    Problems& problems_;
    const SheetRow* header_ = nullptr;
    std::vector<Heading> headings_;
    GradingColumns found_;
};

} // namespace

const std::string& text_at(const SheetRow& row, std::size_t column) {
    static const std::string none;
    return column < row.cells.size() ? row.cells[column].text : none;
}

Place place_at(const SheetRow& row, std::size_t column) {
    return column < row.cells.size() ? row.cells[column].place : row.place;
}

bool is_blank(std::string_view text) {
    const std::string_view plain = trimmed(text);
    return plain.empty() || plain == "-" || plain == "--" || plain == "\u2013" || plain == "\u2014" || plain == "n/a" ||
           plain == "N/A";
}

std::optional<double> number_at(const Sheet& sheet, const SheetRow& row, std::size_t column) {
    std::string_view text = trimmed(text_at(row, column));
    while (!text.empty() && (text.back() == '%' || std::isalpha(static_cast<unsigned char>(text.back())) != 0)) {
        text = trimmed(text.substr(0, text.size() - 1));
    }
    const bool is_quoted = column < row.cells.size() && row.cells[column].is_quoted;
    return plain_number(text, commas_are_decimal(sheet) || is_quoted);
}

std::optional<GradingColumns> find_grading_columns(const Sheet& sheet, Problems& problems) {
    for (std::size_t k = 0; k < sheet.rows.size() && k < most_titles; ++k) {
        if (sheet.rows[k].cells.size() > most_columns) {
            problems.error(
                "E506", {sheet.rows[k].place.source, sheet.rows[k].place.line, 1, 1},
                fmt::format(
                    "{} columns, and a table of gradings has at most {}", sheet.rows[k].cells.size(), most_columns
                ),
                "is this the file that you meant? Write a line for each sieve"
            );
            return std::nullopt;
        }
    }
    return ColumnFinder(sheet, problems).find();
}

} // namespace suffuse::io
