#include "suffuse/gradings/unnamed_columns.hpp"

#include "suffuse/gradings/column_content.hpp"
#include "suffuse/gradings/derived_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace suffuse::gradings {

namespace {

class UnnamedColumns {
public:
    UnnamedColumns(const Sheet& sheet, Problems& problems) : sheet_(sheet), problems_(problems) {}

    /// No heading: two columns of numbers, of which one can be the sizes alone.
    std::optional<GradingColumns> find() {
        for (found_.first_row = 0; found_.first_row < sheet_.rows.size(); ++found_.first_row) {
            const SheetRow& row = sheet_.rows[found_.first_row];
            if (!row.is_comment && row.cells.size() == 2 && number_at(sheet_, row, 1) && is_size(sheet_, row, 0)) {
                break;
            }
        }
        const bool has_rows = found_.first_row < sheet_.rows.size();
        const auto all_of_two = [](const SheetRow& row) { return row.is_comment || row.cells.size() == 2; };
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
        found_.is_headed = false;
        found_.shares.push_back({first ? 1U : 0U, {}, "", ShareMeaning::Cumulative, ShareUnit::Unknown, false});
        for (std::size_t k = 0; k < found_.first_row; ++k) {
            if (!sheet_.rows[k].is_comment) {
                if (!is_title(sheet_.rows[k])) {
                    complain_about_header(false);
                    return std::nullopt;
                }
                problems_.warning(
                    sheet_remark, sheet_.rows[k].place, "skipped: it is not a row of two numbers",
                    "name the columns in it: `d [mm],passing [%]`"
                );
            }
        }
        problems_.warning(
            sheet_remark, sheet_.rows[found_.first_row].place,
            fmt::format(
                "no column headings: the {} is read as the size in mm, the other as a cumulative share",
                first ? "first" : "second"
            ),
            "begin with a line `d [mm],passing [%]` to say so"
        );
        return found_;
    }

private:
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
        const auto amounts = amounts_in(sheet_, found_.first_row, found_.size, share);
        const auto possible = find_possible_meanings(amounts.value_or(Amounts{}));
        return rows > 1 && sizes.size() == rows && ends_full && (possible.passing || possible.cumulative_retained);
    }

    /// "clay,silt,sand": their bounds differ between standards. @return whether the row has such headings
    bool complain_about_classes(const SheetRow& row) {
        std::vector<std::string> classes;
        for (const SheetCell& cell : row.cells) {
            const auto derived = read_derived_name(cell.text);
            const bool is_class =
                derived && (derived->kind == DerivedValue::Kind::Gravel || derived->kind == DerivedValue::Kind::Sand ||
                            derived->kind == DerivedValue::Kind::Silt || derived->kind == DerivedValue::Kind::Clay ||
                            derived->kind == DerivedValue::Kind::Fines || derived->kind == DerivedValue::Kind::Cobbles);
            if (is_class) {
                classes.push_back(cell.text);
            }
        }
        if (classes.size() < 2) {
            return false;
        }
        const std::string last = classes.back();
        classes.pop_back();
        problems_.error(
            "E506", row.place,
            fmt::format("shares of {} and {} are no curve: their sizes are missing", fmt::join(classes, ", "), last),
            "write the curve: `d [mm],passing [%]` with the upper bound of each class by its standard, as 0.002, 0.063 "
            "and 2 mm"
        );
        return true;
    }

    void complain_about_header(bool are_two_columns) {
        const auto first = std::ranges::find_if(sheet_.rows, [](const SheetRow& row) { return !row.is_comment; });
        if (first != sheet_.rows.end() && complain_about_classes(*first)) {
            return;
        }
        problems_.error(
            "E506", first != sheet_.rows.end() ? first->place : sheet_.rows.front().place,
            are_two_columns ? "no column headings, and the numbers do not show which are the sizes"
                            : "a grading curve needs a column of sizes and one of percent passing, and `d` is missing",
            expected_header
        );
    }

    const Sheet& sheet_;
    Problems& problems_;
    GradingColumns found_;
};

} // namespace

std::optional<GradingColumns> find_unnamed_columns(const Sheet& sheet, Problems& problems) {
    return UnnamedColumns(sheet, problems).find();
}

} // namespace suffuse::gradings
