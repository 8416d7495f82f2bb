#include "suffuse/io/grading_rows.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/base/units.hpp"
#include "suffuse/io/plain_sizes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>

namespace suffuse::io {

namespace {

/// "1,000" between quotes may be a thousand or one.
bool may_be_thousands(std::string_view text) {
    const std::size_t comma = text.find(',');
    return comma != std::string_view::npos && comma > 0 && comma < 4 && text[0] != '0' && text.size() == comma + 4;
}

class RowReader {
public:
    RowReader(const Sheet& sheet, GradingColumns columns, Problems& problems)
        : sheet_(sheet), columns_(std::move(columns)), problems_(problems) {
        const PlainSizes sizes = judge_plain_sizes(sheet, columns_);
        const SizeScale found = sizes.scale;
        mixes_units_ = sizes.mix_units;
        if (found != columns_.size.scale) {
            tell(
                sheet_.rows[columns_.first_row].place,
                found == SizeScale::SieveNumber
                    ? "plain sizes are read as sieve numbers of ASTM E11, for only so do they go with the shares"
                    : "plain sizes are read in mm, for no sieve has a broken number",
                "name the column `d [mm]` or `sieve no.` to say so"
            );
            columns_.size.scale = found;
        }
        has_points_ = std::ranges::any_of(sheet_.rows, [this](const SheetRow& row) { return has_point(row); });
        for (ShareColumn& share : columns_.shares) {
            decide_unit(share);
        }
    }

    std::optional<std::vector<SievedSoil>> read() {
        for (std::size_t k = columns_.first_row; k < sheet_.rows.size(); ++k) {
            if (sheet_.rows[k].is_comment) {
                tell_comment(sheet_.rows[k]);
            } else {
                read_row(sheet_.rows[k]);
            }
        }
        tell_skipped();
        return is_good_ ? std::optional(std::move(soils_)) : std::nullopt;
    }

private:
    void tell(const Place& place, const std::string& what, const std::string& advice = {}) {
        problems_.warning(sheet_remark, place, what, advice);
    }

    void complain(const Place& place, const std::string& what, const std::string& advice) {
        problems_.error("E502", place, what, advice);
        is_good_ = false;
    }

    [[nodiscard]] bool has_point(const SheetRow& row) const {
        const auto has = [&](std::size_t column) {
            const std::string& text = text_at(row, column);
            const std::size_t at = text.find('.');
            return at != std::string::npos && at + 1 < text.size() && is_digit(text[at + 1]) &&
                   (at == 0 || is_digit(text[at - 1]));
        };
        return !row.is_comment && (has(columns_.size.index) || has(columns_.shares.front().index));
    }

    /// Shares without a unit are fractions where none is above 1.
    void decide_unit(ShareColumn& share) {
        if (share.unit != ShareUnit::Unknown) {
            return;
        }
        share.unit = ShareUnit::Percent;
        constexpr double least_end = 0.5; // a curve of percents that ends below is refused later on
        double most = 0;
        const SheetRow* at = nullptr;
        for (std::size_t k = columns_.first_row; k < sheet_.rows.size(); ++k) {
            const auto value = number_at(sheet_, sheet_.rows[k], share.index);
            const bool has_percent = text_at(sheet_.rows[k], share.index).find('%') != std::string::npos;
            if (has_percent || (value && *value > 1.0000001)) {
                return;
            }
            if (value && *value > most) {
                most = *value, at = &sheet_.rows[k];
            }
        }
        if (most > least_end && at != nullptr) {
            share.unit = ShareUnit::Fraction;
            tell(
                place_at(*at, share.index),
                fmt::format("shares are read as fractions of 1, for none is above {:.4g}", most),
                "name the column `passing [-]` to say so"
            );
        }
    }

    /// `# 4`, with a blank, is a comment, and may have been meant as a sieve.
    void tell_comment(const SheetRow& row) {
        if (!row.cells.empty() && row.cells.size() > 1 && !row.cells[0].text.empty() &&
            is_digit(row.cells[0].text[0])) {
            tell(
                row.place, "passed over as a comment",
                "where this is a sieve, write its # without a blank behind it: #4"
            );
        }
    }

    void read_row(const SheetRow& row) {
        if (row.cells.size() > width()) {
            return complain(
                row.place, fmt::format("{} values where the header names {} columns", row.cells.size(), width()),
                sheet_.mark == ','
                    ? "one value for each column; where numbers have a decimal comma, columns are separated by ; as "
                      "in 0,063;12,5, the header too"
                    : "one value for each column"
            );
        }
        const std::string& word = word_of(row);
        const bool is_empty = std::ranges::all_of(columns_.shares, [&row](const ShareColumn& share) {
            return is_blank(text_at(row, share.index));
        });
        switch (read_row_word(word)) {
        case RowWord::Pan:
            return read_pan(row, word);
        case RowWord::Total:
            return read_total(row, word);
        case RowWord::None:
            break;
        }
        if (is_blank(text_at(row, columns_.size.index)) && is_empty) {
            return tell(row.place, "passed over: it has no size and no share");
        }
        const auto diameter = read_size(row);
        if (!diameter) {
            return;
        }
        if (is_empty) {
            skipped_.push_back(trimmed_text(word));
            skipped_place_ = skipped_.size() == 1 ? row.place : skipped_place_;
            return;
        }
        if (*diameter == 0 && take_zero(row)) {
            return;
        }
        for (const ShareColumn& share : columns_.shares) {
            if (!is_blank(text_at(row, share.index))) {
                take(row, share, *diameter);
            }
        }
    }

    /// What stands in place of the size; in a column before it where that cell is empty: "Total,,100".
    [[nodiscard]] const std::string& word_of(const SheetRow& row) const {
        const std::string& own = text_at(row, columns_.size.index);
        const auto first = std::ranges::find_if(row.cells, [](const SheetCell& cell) { return !is_blank(cell.text); });
        const bool is_elsewhere = is_blank(own) && first != row.cells.end();
        return is_elsewhere ? first->text : own;
    }

    static std::string trimmed_text(const std::string& text) { return std::string(trimmed(text)); }

    /// Columns of the header, or of the first row where there is none.
    [[nodiscard]] std::size_t width() const {
        std::size_t most = columns_.first_row > 0 ? 0 : sheet_.rows.front().cells.size();
        for (std::size_t k = 0; k < columns_.first_row; ++k) {
            most = std::max(most, sheet_.rows[k].cells.size());
        }
        return std::max(most, columns_.size.index + 1);
    }

    std::optional<double> read_size(const SheetRow& row) {
        const std::size_t column = columns_.size.index;
        const std::string& text = text_at(row, column);
        const bool is_quoted = column < row.cells.size() && row.cells[column].is_quoted;
        const bool comma = sheet_.mark != ',' || is_quoted;
        if (text.find(',') != std::string::npos && !check_comma(row, column)) {
            return std::nullopt;
        }
        const auto size = read_sieve_size(text, columns_.size.scale, comma);
        if (!size) {
            complain(
                place_at(row, column), no_size(text),
                "a size is a number in mm, or as in 75 um, 3/8\", No. 200; a comment begins with # and a blank"
            );
            return std::nullopt;
        }
        if (size->notation == SizeNotation::WithUnit && mixes_units_) {
            complain(
                place_at(row, column), fmt::format("\"{}\" has its own unit, and other sizes have none", text),
                "write a unit at every size, or name it in the heading: `d [mm]`"
            );
            return std::nullopt;
        }
        if (size->notation == SizeNotation::SieveNumber && !size->is_on_scale) {
            complain(
                place_at(row, column), fmt::format("\"{}\" is no sieve number of ASTM E11", text),
                "write its opening with a unit, as in 4.75 mm; a comment begins with # and a blank"
            );
            return std::nullopt;
        }
        if (size->notation == SizeNotation::Inches && !size->is_on_scale) {
            tell(
                place_at(row, column),
                fmt::format("\"{}\" is no sieve of ASTM E11: read as {:.4g} mm", text, 1e3 * size->diameter)
            );
        }
        has_unit_ = columns_.size.scale != SizeScale::Unknown || size->notation != SizeNotation::Plain;
        return size->diameter;
    }

    static std::string no_size(const std::string& text) {
        if (is_blank(text)) {
            return "a value is missing";
        }
        std::string_view unit = text;
        unit.remove_prefix(std::min(unit.find_first_not_of("0123456789.,eE+- "), unit.size()));
        try {
            parse_quantity(fmt::format("1 {}", unit), dimension::length);
        } catch (const UnitError& problem) {
            if (is_digit(text[0]) && std::string_view(problem.what()).find(" is a") != std::string_view::npos &&
                std::string_view(problem.what()).find("not a unit") == std::string_view::npos) {
                return fmt::format("\"{}\": {}", text, problem.what());
            }
        }
        return fmt::format("\"{}\" is not a number", text);
    }

    /// A decimal comma where commas separate, or beside decimal points.
    bool check_comma(const SheetRow& row, std::size_t column) {
        const std::string& text = row.cells[column].text;
        const bool is_ambiguous = has_points_ || (sheet_.mark == ',' && may_be_thousands(text));
        if (!is_ambiguous || text.find('/') != std::string::npos) {
            return true;
        }
        complain(
            row.cells[column].place, fmt::format("\"{}\" has a comma", text),
            sheet_.mark == ',' ? "commas separate the columns here: write a decimal point"
                               : "other numbers have a decimal point: write the same mark everywhere, and none between "
                                 "thousands"
        );
        return false;
    }

    /// A size 0 keeps what passed all sieves. @return whether it is passed over.
    bool take_zero(const SheetRow& row) {
        const ShareMeaning meaning = columns_.shares.front().meaning;
        if (meaning == ShareMeaning::OnSieve || meaning == ShareMeaning::Retained ||
            meaning == ShareMeaning::CumulativeRetained) {
            read_pan(row, text_at(row, columns_.size.index));
            return true;
        }
        const bool has_none = std::ranges::all_of(columns_.shares, [&](const ShareColumn& share) {
            const auto value = number_at(sheet_, row, share.index);
            return value && *value == 0;
        });
        if (has_none) {
            tell(row.place, "size 0 is passed over: no grain is that small", "write the size of the smallest grains");
        }
        return has_none;
    }

    void read_pan(const SheetRow& row, const std::string& word) {
        for (const ShareColumn& share : columns_.shares) {
            if (is_blank(text_at(row, share.index))) {
                continue;
            }
            const auto amount = read_amount(row, share);
            if (!amount) {
                continue;
            }
            SievedSoil& soil = soil_of(row, share);
            soil.pan = *amount, soil.end = row.place;
            if (share.meaning == ShareMeaning::Passing && *amount != 0) {
                complain(
                    place_at(row, share.index), fmt::format("{:.4g} % passes the pan", 100 * *amount),
                    "nothing passes it: what it holds belongs into a column `retained on sieve [%]`"
                );
            }
        }
        tell(row.place, fmt::format("`{}` is what passed the finest sieve: it has no size of its own", word));
    }

    void read_total(const SheetRow& row, const std::string& word) {
        for (const ShareColumn& share : columns_.shares) {
            if (!is_blank(text_at(row, share.index)) && number_at(sheet_, row, share.index)) {
                if (const auto amount = read_amount(row, share)) {
                    soil_of(row, share).total = *amount;
                }
            }
        }
        tell(row.place, fmt::format("`{}` is passed over: it is no sieve", word));
    }

    void take(const SheetRow& row, const ShareColumn& share, double diameter) {
        if (const auto amount = read_amount(row, share)) {
            SievedSoil& soil = soil_of(row, share);
            soil.end = row.place;
            soil.sieves.push_back(
                {diameter, *amount, place_at(row, columns_.size.index), place_at(row, share.index), has_unit_}
            );
        }
    }

    /// A share, or a mass without that of the sieve.
    std::optional<double> read_amount(const SheetRow& row, const ShareColumn& share) {
        const auto amount = read_value(row, share.index, share.unit);
        if (!amount || !share.tare) {
            return amount;
        }
        const auto tare = read_value(row, *share.tare, share.unit);
        if (tare && *tare > *amount) {
            complain(
                place_at(row, share.index),
                fmt::format("a sieve with soil of {:.6g} g, and empty of {:.6g} g", 1e3 * *amount, 1e3 * *tare),
                "the sieve with what it keeps is the heavier one: are the columns exchanged?"
            );
        }
        return tare ? std::optional(*amount - *tare) : std::nullopt;
    }

    std::optional<double> read_value(const SheetRow& row, std::size_t column, ShareUnit unit) {
        std::string text = trimmed_text(text_at(row, column));
        const bool is_quoted = column < row.cells.size() && row.cells[column].is_quoted;
        if (text.find(',') != std::string::npos) {
            if (!check_comma(row, column)) {
                return std::nullopt;
            }
            if (sheet_.mark != ',' || is_quoted) {
                std::replace(text.begin(), text.end(), ',', '.');
            }
        }
        const char* const own = unit == ShareUnit::Percent ? "%" : unit == ShareUnit::Mass ? "g" : "1";
        const Dimension dimension = unit == ShareUnit::Mass ? dimension::mass : dimension::none;
        const std::string advice =
            fmt::format("write a plain number; it is read in {}", unit == ShareUnit::Fraction ? "shares of 1" : own);
        try {
            const bool has_unit = parse_quantity(text).has_unit;
            if (has_unit && unit == ShareUnit::Fraction) {
                complain(place_at(row, column), fmt::format("\"{}\" has its own unit", text), advice);
                return std::nullopt;
            }
            return parse_quantity(has_unit ? text : fmt::format("{} {}", text, own), dimension);
        } catch (const UnitError& problem) {
            const std::string what = text.empty() ? "a value is missing" : problem.what();
            const bool is_no_number = what.find("start with a number") != std::string::npos;
            complain(place_at(row, column), is_no_number ? fmt::format("\"{}\" is not a number", text) : what, advice);
            return std::nullopt;
        }
    }

    /// The soil that a row and a column speak of.
    SievedSoil& soil_of(const SheetRow& row, const ShareColumn& share) {
        std::string name = share.name;
        for (const std::size_t key : columns_.sample_key) {
            name += name.empty() ? "" : " ";
            name += text_at(row, key);
        }
        const auto [found, is_new] = index_.try_emplace(name, soils_.size());
        if (is_new) {
            SievedSoil soil;
            soil.name = name, soil.meaning = share.meaning, soil.unit = share.unit;
            soil.heading_place =
                columns_.first_row > 0 ? place_at(sheet_.rows[columns_.first_row - 1], share.index) : row.place;
            soil.end = row.place;
            soils_.push_back(std::move(soil));
        }
        return soils_[found->second];
    }

    void tell_skipped() {
        if (!skipped_.empty()) {
            tell(
                skipped_place_, fmt::format(
                                    "{} {} without a value: passed over as not used",
                                    skipped_.size() == 1 ? "the sieve" : "the sieves", fmt::join(skipped_, ", ")
                                )
            );
        }
    }

    const Sheet& sheet_;
    GradingColumns columns_;
    Problems& problems_;
    bool has_points_ = false, is_good_ = true, mixes_units_ = false, has_unit_ = false;
    std::vector<SievedSoil> soils_;
    std::map<std::string, std::size_t> index_;
    std::vector<std::string> skipped_;
    Place skipped_place_;
};

} // namespace

std::optional<std::vector<SievedSoil>> read_sieve_rows(const Sheet& sheet, GradingColumns columns, Problems& problems) {
    return RowReader(sheet, std::move(columns), problems).read();
}

} // namespace suffuse::io
