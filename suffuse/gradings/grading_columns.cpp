#include "suffuse/gradings/grading_columns.hpp"

#include "suffuse/base/units.hpp"
#include "suffuse/gradings/column_content.hpp"
#include "suffuse/gradings/sheet_header.hpp"
#include "suffuse/gradings/soil_columns.hpp"
#include "suffuse/gradings/unnamed_shares.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

namespace suffuse::gradings {

namespace {

class ColumnFinder {
public:
    ColumnFinder(const Sheet& sheet, Problems& problems) : sheet_(sheet), problems_(problems) {}

    std::optional<GradingColumns> find() {
        if (const auto header = find_sheet_header(sheet_)) {
            return by_header(*header);
        }
        return find_unnamed_columns(sheet_, problems_);
    }

private:
    std::optional<GradingColumns> by_header(const SheetHeader& header) {
        header_ = &sheet_.rows[header.row];
        header_row_ = header.row;
        second_ = header.lines > 1 ? &sheet_.rows[header.row + 1] : nullptr;
        headings_ = header.headings;
        found_.first_row = header.row + header.lines;
        if (found_.first_row < sheet_.rows.size() && take_unit_row(sheet_.rows[found_.first_row], headings_)) {
            ++found_.first_row;
        }
        pass_over_bare_masses();
        remark_on_titles(header.row);
        if (!check_units() || !choose_size() || !choose_shares() || !check_names()) {
            return std::nullopt;
        }
        find_sample_key();
        settle_bounds();
        remark_on_unread();
        return found_;
    }

    /// "Mass (g)" next to the masses of empty sieves is no mass retained.
    void pass_over_bare_masses() {
        const bool are_weighed = !columns_of(ColumnKind::Tare).empty() || !columns_of(ColumnKind::Gross).empty();
        for (Heading& heading : headings_) {
            heading.kind = heading.is_bare_mass && are_weighed ? ColumnKind::Other : heading.kind;
        }
    }

    /// Titles and notes above the headings, in one line.
    void remark_on_titles(std::size_t header_row) {
        const auto titles = value_rows(sheet_, 0, header_row);
        if (!titles.empty()) {
            problems_.warning(
                sheet_remark, titles.front()->place,
                fmt::format(
                    "skipped {}; the column headings are on line {}",
                    titles.size() == 1 ? "1 title line" : fmt::format("{} title lines", titles.size()),
                    header_->place.line
                ),
                "begin titles with # to keep this quiet"
            );
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
                    if (problem.kind != UnitError::Kind::UnknownUnit &&
                        heading.own_unit.find(' ') == std::string::npos) {
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
    [[nodiscard]] int rank_of_size(std::size_t column) const {
        const Heading& heading = headings_[column];
        if (heading.kind != ColumnKind::Size) {
            return 0;
        }
        std::size_t sizes = 0, others = 0, classes = 0;
        for (const SheetRow* row : value_rows(sheet_, found_.first_row, found_.first_row + most_titles)) {
            const std::string& text = text_at(*row, column);
            if (!is_blank(text) && read_row_word(text) == RowWord::None) {
                ++(is_size(sheet_, *row, column) ? sizes : others);
                classes += split_size_text(text).sense == SizeSense::Class ? 1U : 0U;
            }
        }
        const bool is_metric = heading.scale == SizeScale::Millimeters || heading.scale == SizeScale::Micrometers ||
                               heading.scale == SizeScale::Meters || heading.scale == SizeScale::Centimeters;
        const bool is_nominal = heading.scale == SizeScale::SieveNumber || heading.scale == SizeScale::Inches;
        const int named = is_nominal ? 2 : heading.names_sieve_alone ? 3 : 5;
        const int rank = sizes < others ? 1 : heading.is_length_alone ? 4 : is_metric ? 6 : named;
        return classes > 0 ? rank + 1 : rank; // "mean D" next to the bounds of a class
    }

    bool choose_size() {
        std::vector<int> ranks(headings_.size());
        std::ranges::generate(ranks, [this, k = std::size_t{0}]() mutable { return rank_of_size(k++); });
        const auto highest = std::ranges::max_element(ranks); // of a header, which has one
        const auto best = static_cast<std::size_t>(highest - ranks.begin());
        found_.size = {best, headings_[best].scale};
        if (names_no_diameter(headings_[best], name_of(best))) {
            complain_about_diameters(place_at(*header_, best), name_of(best), problems_);
            return false;
        }
        for (std::size_t k = best + 1; k < headings_.size(); ++k) {
            if (ranks[k] == *highest && !take_bounds(best, k)) {
                complain_about_two(best, k, "keep one of the two columns, or rename the other so that it is ignored");
                return false;
            }
        }
        return true;
    }

    /// Two columns of which one has the coarser size in each row: the bounds of classes.
    bool take_bounds(std::size_t a, std::size_t b) {
        const auto finer = find_finer_bound(sheet_, found_.first_row, a, b);
        if (!finer || headings_[a].scale != headings_[b].scale || found_.upper) {
            return false;
        }
        found_.size.index = *finer, found_.upper = *finer == a ? b : a;
        problems_.warning(
            sheet_remark, header_->cells[b].place,
            fmt::format(
                "`{}` and `{}` are read as the bounds of classes", header_->cells[a].text, header_->cells[b].text
            )
        );
        return true;
    }

    /// What passes is finer than the coarser bound of its class.
    void settle_bounds() {
        if (found_.upper && found_.shares.front().meaning == ShareMeaning::Passing) {
            std::swap(found_.size.index, *found_.upper);
            bound_ = *std::exchange(found_.upper, std::nullopt);
        }
        bound_ = found_.upper ? *found_.upper : bound_;
    }

    bool choose_shares() {
        auto columns = columns_of(ColumnKind::Share);
        if (!columns.empty()) {
            const auto meaning_of = [this](std::size_t k) { return headings_[k].meaning; };
            const ShareMeaning surest = meaning_of(*std::ranges::min_element(columns, {}, meaning_of));
            std::erase_if(columns, [&](std::size_t k) { return meaning_of(k) != surest; });
            return take_shares(std::move(columns));
        }
        auto gross = columns_of(ColumnKind::Gross), tare = columns_of(ColumnKind::Tare);
        if (gross.empty() && tare.size() == 2) { // "sieve mass" and "sieve soil mass": what is on it never weighs less
            if (is_never_less(tare[0], tare[1])) {
                std::swap(tare[0], tare[1]);
            }
            if (is_never_less(tare[1], tare[0])) {
                gross = {tare[1]}, tare = {tare[0]};
            }
        }
        return gross.empty() ? take_unnamed() : take_weighings(gross, tare);
    }

    /// A form has columns that nobody filled in.
    [[nodiscard]] bool has_number(std::size_t column) const {
        return std::ranges::any_of(value_rows(sheet_, found_.first_row), [&](const SheetRow* row) {
            return number_at(sheet_, *row, column).has_value();
        });
    }

    [[nodiscard]] bool is_never_less(std::size_t column, std::size_t than) const {
        return std::ranges::all_of(sheet_.rows, [&](const SheetRow& row) {
            const auto value = number_at(sheet_, row, column), other = number_at(sheet_, row, than);
            return !value || !other || *value >= *other;
        });
    }

    /// One column, or one for each soil; of percents rather than of masses.
    bool take_shares(std::vector<std::size_t> columns) {
        if (std::ranges::any_of(columns, [this](std::size_t k) { return has_number(k); })) {
            std::erase_if(columns, [this](std::size_t k) { return !has_number(k); });
        }
        const auto soils = find_soil_columns(sheet_, headings_, columns, header_row_, found_.first_row);
        for (const SoilColumns& soil : soils) {
            if (soil.columns.size() > 1) {
                complain_about_two(
                    soil.columns[0], soil.columns[1],
                    "keep one of the two columns; if each is a soil, put its name into the heading: `TP1 passing [%]`"
                );
                return false;
            }
            const std::size_t k = soil.columns.front();
            const std::string name = soils.size() > 1 ? soil.name : "";
            const Heading& heading = headings_[k];
            found_.shares.push_back({k, {}, name, heading.meaning, heading.unit, true, heading.mass_unit});
            found_.shares.back().counts_grains = heading.counts_grains;
        }
        return true;
    }

    /// Soils of one name would be one soil, with each size twice.
    bool check_names() {
        for (auto share = found_.shares.begin(); share != found_.shares.end(); ++share) {
            const auto same = std::ranges::find(found_.shares.begin(), share, share->name, &ShareColumn::name);
            if (same != share && !share->name.empty()) {
                problems_.error(
                    "E506", place_at(*header_, share->index),
                    fmt::format("columns {} and {} are both `{}`", same->index + 1, share->index + 1, share->name),
                    "give each soil a heading of its own, or delete one of the two columns"
                );
                return false;
            }
        }
        return true;
    }

    void complain_about_two(std::size_t first, std::size_t second, const char* advice) {
        problems_.error(
            "E506", header_->cells[second].place,
            fmt::format("`{}` and `{}` mean the same", header_->cells[first].text, header_->cells[second].text), advice
        );
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
        found_.shares.push_back(
            {gross.front(), tare.front(), "", ShareMeaning::OnSieve, ShareUnit::Mass, true,
             headings_[gross.front()].mass_unit}
        );
        return true;
    }

    void find_sample_key() {
        for (std::size_t k = 0; k < headings_.size(); ++k) {
            if (headings_[k].kind == ColumnKind::Sample && !is_share(k) && !differs_everywhere(k)) {
                found_.sample_key.push_back(k);
            }
        }
        for (std::size_t k = 0; k < headings_.size() && found_.sample_key.empty(); ++k) {
            const bool may_be = k != found_.size.index && k != found_.upper && !is_share(k);
            if (may_be && names_soils(sheet_, found_.first_row, found_.size, k)) {
                found_.sample_key.push_back(k);
                problems_.warning(
                    sheet_remark, place_at(*header_, k),
                    fmt::format("`{}` names the soils, because the sizes begin anew where it changes", name_of(k))
                );
            }
        }
    }

    [[nodiscard]] std::vector<std::size_t> columns_of(ColumnKind kind) const {
        return columns_of_kind(headings_, kind);
    }

    [[nodiscard]] bool is_share(std::size_t column) const {
        return std::ranges::any_of(found_.shares, [column](const ShareColumn& share) {
            return share.index == column || share.tare == column;
        });
    }

    /// Rows that are a sample each make no curve: such a column counts or measures something else.
    [[nodiscard]] bool differs_everywhere(std::size_t column) const {
        std::set<std::string_view> values;
        const auto rows = value_rows(sheet_, found_.first_row);
        for (const SheetRow* row : rows) {
            values.insert(text_at(*row, column));
        }
        return rows.size() > 1 && values.size() == rows.size();
    }

    /// Columns whose headings say neither: soils, by their numbers.
    bool take_unnamed() {
        std::vector<std::size_t> candidates;
        for (std::size_t k = 0; k < headings_.size(); ++k) {
            const Heading& heading = headings_[k];
            if (heading.kind == ColumnKind::Other || (heading.kind == ColumnKind::Sample && !heading.rest.empty())) {
                candidates.push_back(k);
            }
        }
        const auto has_unit = [this](std::size_t k) { return headings_[k].unit != ShareUnit::Unknown; };
        if (std::ranges::any_of(candidates, has_unit)) { // "class" next to "freq. (%)"
            std::erase_if(candidates, std::not_fn(has_unit));
        }
        std::erase_if(candidates, [this](std::size_t k) { return is_index(sheet_, found_.first_row, k, name_of(k)); });
        const auto columns = find_share_columns(sheet_, found_.first_row, found_.size, candidates);
        for (const auto& [k, amounts] : columns) {
            add_unnamed(k, ShareMeaning::Unstated);
        }
        const OddSoils odd = find_soils_with_odd_cells(sheet_, found_.first_row, found_.size, candidates, columns);
        for (const std::size_t k : odd.columns) {
            add_unnamed(k, odd.meaning);
        }
        if (found_.shares.empty()) {
            problems_.error(
                "E506", header_->place,
                "a grading curve needs a column of sizes and one of percent passing, and `passing` is missing",
                expected_header
            );
            return false;
        }
        remark_on_meaning(std::ranges::all_of(columns, [](const auto& column) { return is_cumulative(column.second); })
        );
        return true;
    }

    void add_unnamed(std::size_t k, ShareMeaning meaning) {
        const bool is_split = headings_[k].unit != ShareUnit::Unknown && !headings_[k].rest.empty();
        const std::string& name = is_split ? headings_[k].rest : text_at(*header_, k);
        found_.shares.push_back({k, {}, name, meaning, headings_[k].unit, false});
        found_.shares.back().counts_grains = headings_[k].counts_grains;
    }

    void remark_on_meaning(bool are_cumulative) {
        const std::size_t first = found_.shares.front().index;
        const bool is_one = found_.shares.size() == 1;
        problems_.warning(
            sheet_remark, is_one ? place_at(*header_, first) : header_->place,
            fmt::format(
                "{} read as {}{}, because {}",
                is_one ? fmt::format("column {} is", first + 1) : fmt::format("{} columns are", found_.shares.size()),
                is_one && are_cumulative ? "a cumulative share"
                : are_cumulative         ? "cumulative shares"
                                         : "shares",
                is_one ? "" : ", each of a soil of its own",
                are_cumulative ? "the numbers rise or fall throughout" : "the numbers add up to 100 %"
            ),
            is_one ? "name it `passing [%]` or `retained on sieve [%]` to say so" : ""
        );
    }

    void remark_on_unread() {
        std::vector<std::string> unread;
        for (std::size_t k = 0; k < headings_.size(); ++k) {
            const bool is_key = std::ranges::find(found_.sample_key, k) != found_.sample_key.end();
            if (!is_share(k) && !is_key && k != found_.size.index && k != bound_ && !name_of(k).empty()) {
                unread.push_back(fmt::format("`{}`", name_of(k)));
            }
        }
        if (!unread.empty()) {
            problems_.warning(
                sheet_remark, header_->place,
                fmt::format(
                    "sizes are read from `{}`, shares from `{}`; not read: {}", name_of(found_.size.index),
                    name_of(found_.shares.front().index), fmt::join(unread, ", ")
                )
            );
        }
    }

    /// A heading as written, in one line or two.
    [[nodiscard]] std::string name_of(std::size_t column) const {
        std::string name = text_at(*header_, column);
        append_word(name, second_ != nullptr ? text_at(*second_, column) : "");
        return name;
    }

    const Sheet& sheet_;
    Problems& problems_;
    const SheetRow *header_ = nullptr, *second_ = nullptr; ///< lines of the headings
    std::size_t header_row_ = 0;
    std::vector<Heading> headings_;
    std::optional<std::size_t> bound_; ///< the other column of sizes of classes
    GradingColumns found_;
};

} // namespace

std::optional<GradingColumns> find_grading_columns(const Sheet& sheet, Problems& problems) {
    return ColumnFinder(sheet, problems).find();
}

} // namespace suffuse::gradings
