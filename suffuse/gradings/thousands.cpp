#include "suffuse/gradings/thousands.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/base/units.hpp"
#include "suffuse/gradings/lexicon.hpp"
#include "suffuse/gradings/sheet_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

namespace suffuse::gradings {

namespace {

/// The digits and marks that a cell begins with; empty where it is no number, with a unit or without.
std::string digits_in(std::string_view text) {
    text = trimmed(text);
    const std::size_t end = std::min(text.find_first_not_of("0123456789.,"), text.size());
    const std::string_view digits = text.substr(0, end), unit = trimmed(text.substr(end));
    const bool is_number = !digits.empty() && is_digit(digits.back()) &&
                           (unit.empty() || unit == "%" || size_scale_of(unit) != SizeScale::Unknown ||
                            share_unit_named(std::string(unit)) != ShareUnit::Unknown);
    return std::string(is_number ? digits : std::string_view{});
}

/// "1,250", "1,250,000": one to three digits that do not begin with 0, then three behind each of one mark. @return the
/// mark, or 0
char mark_of_groups(std::string_view digits) {
    const std::size_t at = digits.find_first_of(".,");
    if (at == std::string_view::npos || at == 0 || at > 3 || digits[0] == '0' || (digits.size() - at) % 4 != 0) {
        return 0;
    }
    for (std::size_t k = at; k < digits.size(); ++k) {
        const bool is_mark = (k - at) % 4 == 0;
        if (is_mark ? digits[k] != digits[at] : !is_digit(digits[k])) {
            return 0;
        }
    }
    return digits[at];
}

char other(char mark) {
    return mark == ',' ? '.' : ',';
}

/// The decimal sign of a number that can be read in one way alone; 0 of others.
char sign_in(std::string_view digits) {
    const std::size_t last = digits.find_last_of(".,");
    if (last == std::string_view::npos) {
        return 0;
    }
    const char mark = mark_of_groups(digits);
    if (mark != 0) {
        return digits.find(mark) == last ? 0 : other(mark);
    }
    const std::string_view whole = digits.substr(0, last);
    const bool is_decimal =
        whole.find_first_of(".,") == std::string_view::npos || mark_of_groups(whole) == other(digits[last]);
    return is_decimal ? digits[last] : 0; // 12.05.2026 is neither
}

/// "20 000 um" without the blanks between its groups of three digits; empty where it has none, or is no number.
std::string without_blanks(std::string_view text) {
    std::string plain(text);
    for (const std::string_view blank : {"\u00a0", "\u202f", "\u2009"}) {
        for (std::size_t at = plain.find(blank); at != std::string::npos; at = plain.find(blank)) {
            plain.replace(at, blank.size(), " ");
        }
    }
    std::string joined = plain;
    for (std::size_t at = joined.find(' '); at != std::string::npos && at > 0; at = joined.find(' ', at)) {
        const std::size_t end = std::min(joined.find_first_not_of("0123456789", at + 1), joined.size());
        if (!is_digit(joined[at - 1]) || end != at + 4) {
            break;
        }
        joined.erase(at, 1);
    }
    const std::size_t blank = plain.find_first_not_of("0123456789");
    const bool begins_with_group = blank != std::string::npos && blank > 0 && blank < 4 && plain[0] != '0';
    return joined != plain && begins_with_group && !digits_in(joined).empty() ? joined : "";
}

/// The number of a cell in one of two readings.
std::optional<double> number_in(std::string_view text, bool is_thousands) {
    std::string digits = digits_in(split_size_text(text).text);
    if (const char mark = mark_of_groups(digits); mark != 0 && is_thousands) {
        std::erase(digits, mark);
    }
    return plain_number(digits, true);
}

/// What each reading of one column says.
class ThousandsJudge {
public:
    ThousandsJudge(const SheetTable& table) : table_(table), rows_(value_rows(table.sheet, table.columns->first_row)) {}

    /// Whether sizes rise or fall throughout.
    [[nodiscard]] bool is_ordered(std::size_t column, bool is_thousands) const {
        std::vector<double> values;
        for (const SheetRow* row : rows_) {
            if (const auto value = number_in(text_at(*row, column), is_thousands)) {
                values.push_back(*value);
            }
        }
        return std::ranges::is_sorted(values) || std::ranges::is_sorted(values, std::greater{});
    }

    /// Whether sizes with marks could be read as thousands: in mm they would be wider than anything that is sieved.
    [[nodiscard]] bool may_be_thousands(const SizeColumn& size) const {
        constexpr double widest = 0.1; // [m]
        const SizeScale scale = size.scale == SizeScale::Unknown ? table_.columns->stated_unit.scale : size.scale;
        return scale != SizeScale::Phi && std::ranges::none_of(rows_, [&](const SheetRow* row) {
                   const SizeText text = split_size_text(text_at(*row, size.index));
                   const auto diameter = read_sieve_size(text.text, scale, true);
                   return diameter && mark_of_groups(digits_in(text.text)) != 0 && 1e3 * diameter->diameter > widest;
               });
    }

    /// Whether totals are the sums above them, cumulative numbers go one way, and no sieve weighs less than empty.
    [[nodiscard]] bool fits(const ShareColumn& share, bool is_thousands) const {
        constexpr double lost = 0.01; // of a mass, in sieving
        const bool is_cumulative =
            share.meaning == ShareMeaning::Passing || share.meaning == ShareMeaning::CumulativeRetained;
        bool is_good = !is_cumulative || !table_.columns->sample_key.empty() || is_ordered(share.index, is_thousands);
        double sum = 0, held = 0;
        for (const SheetRow* row : rows_) {
            const auto value = number_in(text_at(*row, share.index), is_thousands);
            const auto tare = share.tare ? number_in(text_at(*row, *share.tare), is_thousands) : 0;
            if (!value || !tare) {
                continue;
            }
            const bool is_total = read_row_word(text_at(*row, table_.columns->size.index)) == RowWord::Total;
            is_good = is_good && *value >= *tare;
            is_good = is_good && (!is_total || is_cumulative || std::abs(*value - sum) <= lost * sum);
            sum = is_total ? 0 : sum + *value - *tare;
            held = std::max(held, is_cumulative ? *value : sum);
        }
        return is_good && (!has_dry_mass(share) || may_be_of_dry_mass(held, share));
    }

    /// Whether a title states the mass that the column is part of.
    [[nodiscard]] bool has_dry_mass(const ShareColumn& share) const {
        return table_.dry && share.unit == ShareUnit::Mass && table_.columns->shares.size() == 1;
    }

private:
    [[nodiscard]] bool may_be_of_dry_mass(double held, const ShareColumn& share) const {
        constexpr double least = 0.002, most = 1.02; // what sieves hold; a thousandth is the other reading
        const double mass = held * parse_quantity(fmt::format("1 {}", share.mass_unit), dimension::mass);
        return mass >= least * *table_.dry && mass <= most * *table_.dry;
    }

    const SheetTable& table_;
    std::vector<const SheetRow*> rows_;
};

/// The thousands of one table.
class ThousandsSettler {
public:
    ThousandsSettler(SheetTable& table, char sign, Problems& problems)
        : table_(table), sign_(sign), problems_(problems) {}

    void settle() {
        const GradingColumns& columns = *table_.columns;
        settle_sizes(columns.size);
        if (columns.upper) {
            settle_sizes({*columns.upper, columns.size.scale});
        }
        for (const ShareColumn& share : columns.shares) {
            settle_shares(share);
        }
    }

private:
    [[nodiscard]] std::optional<GroupedNumber> grouped(std::size_t column) const {
        return find_grouped(table_.sheet, table_.columns->first_row, column);
    }

    void settle_sizes(const SizeColumn& size) {
        const auto found = grouped(size.index);
        if (!found) {
            return;
        }
        const ThousandsJudge judge(table_);
        const bool may_be_thousands = judge.may_be_thousands(size);
        if (may_be_thousands || sign_ == 0) { // else two marks are decimal ones, an error of its own
            const bool thousands = judge.is_ordered(size.index, true), decimals = judge.is_ordered(size.index, false);
            settle_column(size.index, *found, thousands, decimals, may_be_thousands, "the order of the sizes");
        }
    }

    /// Percents of a thousand are none; masses that all have marks give the same curve in both readings.
    void settle_shares(const ShareColumn& share) {
        const bool may_be_large = share.unit == ShareUnit::Mass || share.unit == ShareUnit::Count ||
                                  share.unit == ShareUnit::PerMille || share.tare;
        const auto own = grouped(share.index), tare = share.tare ? grouped(*share.tare) : std::nullopt;
        if (!may_be_large || (!own && !tare)) {
            return;
        }
        const ThousandsJudge judge(table_);
        const bool thousands = judge.fits(share, true), decimals = judge.fits(share, false);
        const bool is_mixed = (own && own->has_plain) || (tare && tare->has_plain) || (share.tare && !(own && tare)) ||
                              judge.has_dry_mass(share);
        if (own) {
            settle_column(share.index, *own, thousands, decimals, is_mixed, "the other numbers of the table");
        }
        if (tare) {
            settle_column(*share.tare, *tare, thousands, decimals, is_mixed, "the other numbers of the table");
        }
    }

    /// @param is_open whether a reading must be chosen where both are possible
    void settle_column(
        std::size_t column, const GroupedNumber& found, bool thousands, bool decimals, bool is_open, const char* why
    ) {
        if (sign_ == found.mark || (sign_ == 0 && (thousands == decimals ? !is_open : decimals))) {
            return; // a decimal sign
        }
        if (sign_ == 0 && thousands == decimals) {
            const std::size_t first = table_.columns->first_row;
            const std::string heading = first > 0 ? text_at(table_.sheet.rows[first - 1], column) : "";
            problems_.error(
                "E502", found.cell.place,
                fmt::format(
                    "{}\"{}\" may be {} or {}", heading.empty() ? "" : fmt::format("column `{}`: ", heading),
                    found.cell.text, found.plain(true), found.plain(false)
                ),
                fmt::format(
                    "write {} if the mark is between thousands, else {}, and likewise below", found.plain(true),
                    found.plain(false)
                )
            );
            return;
        }
        problems_.warning(
            sheet_remark, found.cell.place,
            fmt::format(
                "\"{}\" is read as {}, likewise below: {}", found.cell.text, found.plain(true),
                sign_ != 0 ? fmt::format("other numbers have a decimal {}", sign_ == '.' ? "point" : "comma")
                           : fmt::format("by {}", why)
            )
        );
        join_groups(table_.sheet, table_.columns->first_row, column, found.mark);
    }

    SheetTable& table_;
    char sign_;
    Problems& problems_;
};

} // namespace

double GroupedNumber::value(bool is_thousands) const {
    return number_in(cell.text, is_thousands).value_or(0);
}

std::string GroupedNumber::plain(bool is_thousands) const {
    return fmt::format("{:.12g}", value(is_thousands));
}

char find_decimal_sign(const Sheet& sheet) {
    bool has_point = false, has_comma = false;
    for (const SheetRow* row : value_rows(sheet, 0)) {
        for (const SheetCell& cell : row->cells) {
            const char sign = row->cells.size() > 1 ? sign_in(digits_in(split_size_text(cell.text).text)) : '\0';
            has_point = has_point || sign == '.', has_comma = has_comma || sign == ',';
        }
    }
    return has_point == has_comma ? '\0' : has_point ? '.' : ',';
}

std::optional<GroupedNumber> find_grouped(const Sheet& sheet, std::size_t first_row, std::size_t column) {
    std::optional<GroupedNumber> found;
    bool has_plain = false;
    std::string signs;
    for (const SheetRow* row : value_rows(sheet, first_row)) {
        const std::string digits = digits_in(split_size_text(text_at(*row, column)).text);
        const char mark = mark_of_groups(digits);
        signs += sign_in(digits);
        if (mark == ',' || (mark == '.' && sheet.mark != ',')) { // who separates by commas has decimal points
            found = found ? found : GroupedNumber{row->cells[column], mark};
        }
        has_plain = has_plain || (mark == 0 && plain_number(digits, true).value_or(0) != 0);
    }
    if (!found || signs.find(found->mark) != std::string::npos) {
        return std::nullopt;
    }
    found->has_plain = has_plain;
    return found;
}

void join_groups(Sheet& sheet, std::size_t first_row, std::size_t column, char mark) {
    for (std::size_t k = first_row; k < sheet.rows.size(); ++k) {
        if (column < sheet.rows[k].cells.size()) {
            std::string& text = sheet.rows[k].cells[column].text;
            if (mark_of_groups(digits_in(split_size_text(text).text)) == mark) {
                std::erase(text, mark);
            }
        }
    }
}

void join_sure_groups(Sheet& sheet) {
    for (SheetRow& row : sheet.rows) {
        for (SheetCell& cell : row.cells) {
            const bool may_be = !row.is_comment && sheet.mark != ' ' && sheet.mark != wide_blanks;
            const std::string joined = may_be ? without_blanks(cell.text) : "";
            cell.text = joined.empty() ? cell.text : joined;
        }
    }
    const char sign = find_decimal_sign(sheet);
    for (SheetRow& row : sheet.rows) {
        for (SheetCell& cell : row.cells) {
            const std::string digits = digits_in(split_size_text(cell.text).text);
            if (sign != 0 && sign_in(digits) == sign && digits.find(other(sign)) != std::string::npos) {
                std::erase(cell.text, other(sign));
            }
        }
    }
}

void settle_thousands(const Sheet& sheet, std::vector<SheetTable>& tables, Problems& problems) {
    const char sign = find_decimal_sign(sheet);
    for (SheetTable& table : tables) {
        ThousandsSettler(table, sign, problems).settle();
    }
}

} // namespace suffuse::gradings
