#include "suffuse/gradings/grading_rows.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/gradings/column_content.hpp"
#include "suffuse/gradings/lexicon.hpp"
#include "suffuse/gradings/table_cells.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace suffuse::gradings {

namespace {

bool keeps(ShareMeaning meaning) {
    return meaning == ShareMeaning::OnSieve || meaning == ShareMeaning::Retained ||
           meaning == ShareMeaning::CumulativeRetained;
}

class RowReader {
public:
    RowReader(const Sheet& sheet, GradingColumns& columns, bool mixes_units, Problems& problems)
        : sheet_(sheet), columns_(columns), problems_(problems), cells_(sheet, columns, mixes_units, problems) {
        for (ShareColumn& share : columns_.shares) {
            share.unit = cells_.decide_unit(share);
        }
        take_classes();
    }

    std::optional<std::vector<SievedSoil>> read() {
        for (std::size_t k = columns_.first_row; k < sheet_.rows.size(); ++k) {
            if (sheet_.rows[k].is_comment) {
                remark_on_comment(sheet_.rows[k]);
            } else {
                read_row(sheet_.rows[k]);
            }
        }
        remark_on_skipped();
        if (columns_.sample_key.empty()) { // in the order of their columns, whichever has the coarsest sieve
            std::ranges::stable_sort(soils_, {}, &SievedSoil::column);
        }
        return cells_.has_failed() ? std::nullopt : std::optional(std::move(soils_));
    }

private:
    /// "63 - 31.5": what lies between two sieves is each one's own.
    void take_classes() {
        const auto rows = value_rows(sheet_, columns_.first_row);
        const auto row = std::ranges::find_if(rows, [this](const SheetRow* one) {
            return split_size_text(text_at(*one, columns_.size.index)).sense == SizeSense::Class;
        });
        for (ShareColumn& share : columns_.shares) {
            if (!is_open(share.meaning) || (!columns_.upper && row == rows.end())) {
                continue;
            }
            share.meaning = ShareMeaning::OnSieve;
            if (!columns_.upper) {
                remark(
                    place_at(**row, columns_.size.index),
                    "read as the share between two sieves, retained on the finer one"
                );
            }
        }
    }

    void remark(const Place& place, const std::string& what, const std::string& advice = {}) {
        problems_.warning(sheet_remark, place, what, advice);
    }

    /// `# 4`, with a blank, is a comment, and may have been meant as a sieve.
    void remark_on_comment(const SheetRow& row) {
        if (!row.cells.empty() && row.cells.size() > 1 && !row.cells[0].text.empty() &&
            is_digit(row.cells[0].text[0])) {
            remark(row.place, "skipped as a comment", "if this is a sieve, write # without a space after it: #4");
        }
    }

    /// What says which soil a row is of. Where cells were merged, only the first row of a soil says it.
    void read_key(const SheetRow& row) {
        std::vector<std::string> key;
        for (const std::size_t column : columns_.sample_key) {
            key.push_back(text_at(row, column));
        }
        const bool is_left_out =
            !key.empty() && std::ranges::all_of(key, [](const std::string& part) { return is_blank(part); });
        if (is_left_out && !key_.empty() && !has_reported_merged_) {
            remark(
                row.place, "a row without a sample name belongs to the sample above", "name it in every row to say so"
            );
            has_reported_merged_ = true;
        }
        key_ = is_left_out ? key_ : key;
    }

    void read_row(const SheetRow& row) {
        read_key(row);
        if (row.cells.size() > width()) {
            return cells_.complain(
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
        if (const RowWord kind = read_row_word(word); kind != RowWord::None) {
            return kind == RowWord::Pan ? read_pan(row, word) : read_total(row, word);
        }
        if (is_blank(text_at(row, columns_.size.index)) && (is_empty || is_sum(row))) {
            return remark(
                row.place, is_empty ? "skipped: it has no size and no share"
                                    : "skipped: it has no size and is the sum of the rows above"
            );
        }
        if (is_pan_by_content(row)) {
            return read_pan(row, word);
        }
        const auto size = cells_.read_size(row);
        if (!size) {
            return;
        }
        for (const ShareColumn& share : columns_.shares) {
            if (may_bound_classes(share) && is_blank(text_at(row, share.index))) {
                soil_of(row, share).blanks.push_back({size->diameter, place_at(row, columns_.size.index)});
            }
        }
        if (is_empty) {
            if (!may_bound_classes(columns_.shares.front())) {
                skipped_.emplace_back(trimmed(word));
                skipped_place_ = skipped_.size() == 1 ? row.place : skipped_place_;
            }
            return;
        }
        if (!take_bound(row, *size) && (size->diameter != 0 || !take_zero(row))) {
            take_amounts(row, [&](const ShareColumn& share, double amount, SievedSoil& soil) {
                check_pan_above(soil, size->diameter);
                soil.end = row.place;
                soil.sieves.push_back(
                    {size->diameter, amount, place_at(row, columns_.size.index), place_at(row, share.index),
                     size->has_unit, size->sense == SizeSense::Finer || size->diameter == 0, size->upper}
                );
            });
        }
    }

    /// What a row says of each soil, where it says something.
    template <class Take>
    void take_amounts(const SheetRow& row, const Take& take) {
        for (const ShareColumn& share : columns_.shares) {
            const auto amount = is_blank(text_at(row, share.index)) ? std::nullopt : cells_.read_amount(row, share);
            if (amount) {
                take(share, *amount, soil_of(row, share));
            }
        }
    }

    /// A column of shares without a meaning may be one of classes between edges, of which there is one more.
    [[nodiscard]] bool may_bound_classes(const ShareColumn& share) const {
        return share.meaning == ShareMeaning::Unstated && columns_.sample_key.empty();
    }

    /// What stands in place of the size; in a column before it where that cell is empty: "Total,,100".
    [[nodiscard]] const std::string& word_of(const SheetRow& row) const {
        const std::string &own = text_at(row, columns_.size.index), &first = first_text(row);
        return is_blank(own) && !first.empty() ? first : own;
    }

    /// Columns of the header, or of the first row where there is none.
    [[nodiscard]] std::size_t width() const {
        std::size_t most = columns_.first_row > 0 ? 0 : sheet_.rows.front().cells.size();
        for (std::size_t k = 0; k < columns_.first_row; ++k) {
            most = std::max(most, sheet_.rows[k].cells.size());
        }
        return std::max(most, columns_.size.index + 1);
    }

    [[nodiscard]] double sum_above(const SheetRow& row, const ShareColumn& share) const {
        double sum = 0;
        for (const SheetRow* above : value_rows(sheet_, columns_.first_row)) {
            if (above == &row) {
                break;
            }
            sum += number_at(sheet_, *above, share.index).value_or(0);
        }
        return sum;
    }

    /// Whether a row without a size is a total that nobody named: it says what stands above, added up.
    [[nodiscard]] bool is_sum(const SheetRow& row) const {
        constexpr double rounding = 0.002;
        return std::ranges::all_of(columns_.shares, [&](const ShareColumn& share) {
            const auto value = number_at(sheet_, row, share.index);
            const double sum = sum_above(row, share);
            const bool is_own_sum = value && *value > 0 && std::abs(*value - sum) <= rounding * *value;
            return is_blank(text_at(row, share.index)) || (keeps(share.meaning) && is_own_sum);
        });
    }

    /// Whether a word in place of a size can only be the pan: with it, the percents are complete.
    [[nodiscard]] bool is_pan_by_content(const SheetRow& row) const {
        constexpr double rounding = 0.5; // of the sum of percents with one digit
        const std::string& text = text_at(row, columns_.size.index);
        if (is_blank(text) || text.find_first_of("0123456789") != std::string::npos) {
            return false;
        }
        return std::ranges::all_of(columns_.shares, [&](const ShareColumn& share) {
            const auto value = number_at(sheet_, row, share.index);
            const bool is_own = share.meaning == ShareMeaning::OnSieve;
            const double whole = is_own                                   ? sum_above(row, share) + value.value_or(0)
                                 : share.meaning == ShareMeaning::Passing ? 100 - value.value_or(1)
                                                                          : value.value_or(0);
            return value && share.unit == ShareUnit::Percent && !is_open(share.meaning) &&
                   std::abs(whole - 100) <= (is_own ? rounding : 0);
        });
    }

    /// "< 0.063" keeps what passed the finest sieve where masses or shares are retained, and is a size where they pass;
    /// what passes "> 63" is no question. @return whether the row is done with.
    bool take_bound(const SheetRow& row, const CellSize& size) {
        const ShareMeaning meaning = columns_.shares.front().meaning;
        if (size.sense == SizeSense::Finer && is_open(meaning) && !keeps(meaning)) {
            return false; // the numbers of all rows will show whether this is the pan
        }
        const bool is_retained = keeps(meaning);
        const bool is_pan = is_retained || std::ranges::all_of(columns_.shares, [&](const ShareColumn& share) {
                                return number_at(sheet_, row, share.index).value_or(0) == 0;
                            });
        const std::string& word = text_at(row, columns_.size.index);
        if (size.sense == SizeSense::Finer && is_pan) {
            read_pan(row, word);
            return true;
        }
        if (is_retained || size.sense == SizeSense::At || size.sense == SizeSense::Finer) {
            return false;
        }
        cells_.complain(
            place_at(row, columns_.size.index), fmt::format("\"{}\" in a table of what passes", word),
            "write the size alone; a column of what is kept is named `retained on sieve [%]` or [g]"
        );
        return true;
    }

    /// A size 0 keeps what passed all sieves. @return whether it is passed over.
    bool take_zero(const SheetRow& row) {
        if (keeps(columns_.shares.front().meaning)) {
            read_pan(row, text_at(row, columns_.size.index));
            return true;
        }
        const bool has_none = std::ranges::all_of(columns_.shares, [&](const ShareColumn& share) {
            return number_at(sheet_, row, share.index) == 0.0;
        });
        if (has_none) {
            remark(row.place, "size 0 is skipped: no grain is that small", "write the size of the smallest grains");
        }
        return has_none;
    }

    /// A pan between two sieves: a part of what it holds was sieved on, and its masses are not of the whole sample.
    void check_pan_above(const SievedSoil& soil, double diameter) {
        const auto pan = inner_pans_.find(soil.name);
        if (pan == inner_pans_.end()) {
            return;
        }
        const auto [finest, coarsest] = std::ranges::minmax(soil.sieves, {}, &SieveRow::diameter);
        if (diameter < finest.diameter || diameter > coarsest.diameter) {
            cells_.complain(
                pan->second.place,
                fmt::format(
                    "`{}` holds what passed, and the sieve of {:.6g} mm comes after it: was a part of it riffled and "
                    "sieved on?",
                    pan->second.text, 1e3 * diameter
                ),
                "give masses of the whole sample: multiply those of the part by the mass of this line over that of the "
                "part, and leave this line out"
            );
            inner_pans_.erase(pan);
        }
    }

    void read_pan(const SheetRow& row, const std::string& word) {
        const bool is_washed = mentions(Topic::Washing, spaced_words(word));
        take_amounts(row, [&](const ShareColumn& share, double amount, SievedSoil& soil) {
            if (keeps(share.meaning) && amount != 0 && !soil.sieves.empty() && !is_washed) {
                inner_pans_.try_emplace(soil.name, SheetCell{word, row.place});
            }
            // what was washed away and what lies in the pan are two parts of one
            const bool is_own = share.meaning == ShareMeaning::OnSieve || is_open(share.meaning);
            soil.pan = is_own ? soil.pan.value_or(0) + amount : std::max(soil.pan.value_or(0), amount);
            soil.end = row.place;
            if (share.meaning == ShareMeaning::Passing && amount != 0) {
                cells_.complain(
                    place_at(row, share.index), fmt::format("{:.4g} % passes the pan", 100 * amount),
                    "nothing passes it: what it holds belongs into a column `retained on sieve [%]`"
                );
            }
        });
        remark(row.place, fmt::format("`{}` is what passed the finest sieve: it has no size of its own", word));
    }

    void read_total(const SheetRow& row, const std::string& word) {
        for (const ShareColumn& share : columns_.shares) {
            if (!is_blank(text_at(row, share.index)) && number_at(sheet_, row, share.index)) {
                if (const auto amount = cells_.read_amount(row, share)) {
                    soil_of(row, share).total = *amount;
                }
            }
        }
        remark(row.place, fmt::format("`{}` is skipped: it is not a sieve", word));
    }

    /// The soil that a row and a column speak of.
    SievedSoil& soil_of(const SheetRow& row, const ShareColumn& share) {
        std::string name = share.name;
        for (const std::string& part : key_) {
            append_word(name, part);
        }
        const auto [found, is_new] = index_.try_emplace(name, soils_.size());
        if (is_new) {
            SievedSoil soil;
            soil.name = name, soil.meaning = share.meaning, soil.unit = share.unit, soil.mass_unit = share.mass_unit,
            soil.column = share.index;
            const SheetRow heads =
                columns_.first_row > 0 ? sheet_.rows[columns_.first_row - 1] : SheetRow{{}, row.place};
            soil.heading = text_at(heads, share.index), soil.heading_place = place_at(heads, share.index);
            soil.size_heading = text_at(heads, columns_.size.index);
            soil.end = row.place;
            soil.is_by_number = columns_.is_by_number, soil.is_of_largest = share.is_of_largest;
            soil.size_unit =
                columns_.size.scale == SizeScale::SieveNumber ? "sieve numbers" : scale_name(columns_.size.scale);
            soils_.push_back(std::move(soil));
        }
        return soils_[found->second];
    }

    void remark_on_skipped() {
        if (!skipped_.empty()) {
            remark(
                skipped_place_, fmt::format(
                                    "{} {} without a value: skipped as not used",
                                    skipped_.size() == 1 ? "the sieve" : "the sieves", fmt::join(skipped_, ", ")
                                )
            );
        }
    }

    const Sheet& sheet_;
    GradingColumns& columns_;
    Problems& problems_;
    TableCells cells_;
    std::vector<SievedSoil> soils_;
    std::map<std::string, std::size_t> index_;
    std::map<std::string, SheetCell> inner_pans_; ///< of each soil, the first one below a sieve
    std::vector<std::string> skipped_, key_;
    Place skipped_place_;
    bool has_reported_merged_ = false;
};

/// The scale of sizes without a unit, reported where it was found in the numbers. @return whether some have a unit
bool settle_scale(const Sheet& sheet, GradingColumns& columns, Problems& problems) {
    const PlainSizes sizes = judge_plain_sizes(sheet, columns);
    const Place& first = sheet.rows[columns.first_row].place;
    if (sizes.scale != columns.size.scale) {
        problems.warning(
            sheet_remark, first,
            sizes.scale == SizeScale::SieveNumber
                ? "plain sizes are read as sieve numbers of ASTM E11, because only then do they agree with the shares"
            : sizes.scale == SizeScale::Phi ? "sizes below 0 are read as phi: d = 2^-phi mm"
            : sizes.scale == SizeScale::Micrometers
                ? "sizes without a unit are read in um, because in mm some would be wider than 2 m"
                : "plain sizes are read in mm, because sieve numbers are whole",
            "name the column `d [mm]`, `d [um]`, `phi` or `sieve no.` to say so"
        );
        columns.size.scale = sizes.scale;
    } else if (sizes.scale == SizeScale::Unknown && sizes.has_plain && columns.stated_unit.scale != SizeScale::Unknown) {
        columns.size.scale = columns.stated_unit.scale;
        if (columns.size.scale == SizeScale::Micrometers) {
            problems.warning(sheet_remark, columns.stated_unit.place, "sizes are read in um, the unit stated here");
        }
    } else if (sizes.scale == SizeScale::Unknown && sizes.has_plain && columns.is_headed) {
        problems.warning(
            sheet_remark, first, "no unit is given for the sizes: read in mm", "name the column `d [mm]` or `d [um]`"
        );
    }
    return sizes.mix_units;
}

} // namespace

std::optional<std::vector<SievedSoil>> read_sieve_rows(const Sheet& sheet, GradingColumns columns, Problems& problems) {
    const bool mixes_units = settle_scale(sheet, columns, problems);
    return RowReader(sheet, columns, mixes_units, problems).read();
}

} // namespace suffuse::gradings
