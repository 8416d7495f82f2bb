#include "suffuse/gradings/column_content.hpp"

#include "suffuse/gradings/derived_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>
#include <string_view>
#include <utility>

namespace suffuse::gradings {

namespace {

constexpr double sieving_loss = 0.01;    // of the whole: ASTM D6913 allows this loss in sieving
constexpr double digitizing_step = 1e-3; // of the whole: of a digitized curve

double whole_of(const std::vector<std::pair<double, double>>& points) {
    constexpr double rounding = 1e-7;
    const bool are_percents =
        std::ranges::any_of(points, [](const auto& point) { return point.second > 1 + rounding; });
    return are_percents ? 100 : 1;
}

/// Of masses: a pan below the last cumulative mass is no cumulative one.
PossibleMeanings of_masses(const Amounts& amounts, double sum, bool rises, bool falls) {
    PossibleMeanings possible;
    const double last = amounts.on_sieves.empty() ? 0 : amounts.on_sieves.back();
    possible.adds_up = amounts.total && std::abs(sum - *amounts.total) <= sieving_loss * *amounts.total;
    possible.on_sieve = true;
    possible.cumulative_retained = rises && !(amounts.pan && *amounts.pan < last);
    possible.passing = falls && amounts.pan.value_or(0) == 0;
    return possible;
}

/// Whether one column holds each sieve's own share and the other the same shares added up.
bool are_differences(const Amounts& own, const Amounts& cumulative) {
    const std::vector<double>&each = own.on_sieves, &all = cumulative.on_sieves;
    const double rounding = 1.5 * digitizing_step * own.whole; // of percents with one digit
    const auto differ_by = [&](std::size_t shift) {
        bool are_same = each.size() == all.size() && own.whole == cumulative.whole;
        for (std::size_t k = 1; are_same && k < each.size(); ++k) {
            are_same = std::abs(std::abs(all[k] - all[k - 1]) - each[k - shift]) <= rounding;
        }
        return are_same;
    };
    return differ_by(0) || differ_by(1);
}

/// The numbers of sizes without a unit.
struct PlainNumbers {
    std::size_t count = 0, whole = 0, numbered = 0; ///< all, and those that a sieve number can be
    std::size_t foreign = 0;                        ///< sizes with a unit other than mm
    bool are_phi = true;                            ///< in quarters
    double largest = 0, smallest = std::numeric_limits<double>::infinity();
};

PlainNumbers read_plain_numbers(const Sheet& sheet, const GradingColumns& columns) {
    PlainNumbers found;
    for (const SheetRow* row : value_rows(sheet, columns.first_row)) {
        const std::string text = split_size_text(text_at(*row, columns.size.index)).text;
        const auto size = read_sieve_size(text, SizeScale::Millimeters, commas_are_decimal(sheet));
        if (size && size->notation == SizeNotation::Plain) {
            const double number = size->diameter * 1e3;
            found.are_phi = found.are_phi && std::abs(4 * number - std::round(4 * number)) < 1e-9;
            found.largest = std::max(found.largest, number), found.smallest = std::min(found.smallest, number);
            found.whole += text.find_first_of(".,") == std::string::npos ? 1U : 0U;
            found.numbered += read_sieve_size(text, SizeScale::SieveNumber)->is_on_scale && number > 0 ? 1U : 0U;
            ++found.count;
        } else if (size && size->notation == SizeNotation::WithUnit && text.find("mm") == std::string::npos) {
            ++found.foreign;
        }
    }
    return found;
}

/// Whether sizes go one way, and a share that is named as passing goes with them.
bool is_ordered(const Sheet& sheet, const GradingColumns& columns, SizeScale scale) {
    const ShareColumn& share = columns.shares.front();
    std::vector<double> sizes, shares;
    for (const SheetRow* row : value_rows(sheet, columns.first_row)) {
        const auto size = size_at(sheet, *row, columns.size.index, scale);
        const auto value = number_at(sheet, *row, share.index);
        if (size && value) {
            sizes.push_back(size->diameter), shares.push_back(*value);
        }
    }
    const bool rise = std::ranges::is_sorted(sizes), fall = std::ranges::is_sorted(sizes, std::greater{});
    if (share.meaning != ShareMeaning::Passing || !(rise || fall)) {
        return rise || fall;
    }
    return rise ? std::ranges::is_sorted(shares) : std::ranges::is_sorted(shares, std::greater{});
}

/// One cell, or the names that a plotting program gives: nothing that could say of which kind or unit a column is.
bool is_title(const SheetRow& row) {
    return row.cells.size() == 1 || std::ranges::all_of(row.cells, [](const SheetCell& cell) {
               return cell.text.size() < 2; // x, y
           });
}

/// Sizes each once, shares from near nothing to 100 (or to 1).
bool may_be_sizes(const Sheet& sheet, std::size_t first_row, std::size_t size, std::size_t share) {
    std::set<double> sizes;
    const auto rows = value_rows(sheet, first_row);
    for (const SheetRow* row : rows) {
        const auto d = read_sieve_size(text_at(*row, size), SizeScale::Unknown, commas_are_decimal(sheet));
        if (d && d->diameter > 0 && number_at(sheet, *row, share)) {
            sizes.insert(d->diameter);
        }
    }
    const auto amounts = amounts_in(sheet, first_row, {size, SizeScale::Unknown}, share);
    const double most = amounts ? std::ranges::max(amounts->on_sieves) : 0;
    const bool ends_full = (most >= 90 && most <= 100.1) || (most >= 0.9 && most <= 1.001);
    return sizes.size() == rows.size() && ends_full && is_cumulative(*amounts);
}

/// "clay,silt,sand": their bounds differ between standards.
std::vector<std::string> classes_in(const SheetRow& row) {
    std::vector<std::string> classes;
    for (const SheetCell& cell : row.cells) {
        const auto derived = read_derived_name(cell.text);
        if (derived && derived->kind >= DerivedValue::Kind::Cobbles && derived->kind <= DerivedValue::Kind::Clay) {
            classes.push_back(cell.text);
        }
    }
    return classes;
}

void complain_about_header(const Sheet& sheet, bool are_two_columns, Problems& problems) {
    const auto rows = value_rows(sheet, 0);
    const SheetRow& first = rows.empty() ? sheet.rows.front() : *rows.front();
    auto classes = classes_in(first);
    if (classes.size() > 1) {
        const std::string last = classes.back();
        classes.pop_back();
        problems.error(
            "E506", first.place,
            fmt::format("shares of {} and {} are no curve: their sizes are missing", fmt::join(classes, ", "), last),
            "write the curve: `d [mm],passing [%]` with the upper bound of each class by its standard, as 0.002, 0.063 "
            "and 2 mm"
        );
        return;
    }
    problems.error(
        "E506", first.place,
        are_two_columns ? "no column headings, and the numbers do not show which are the sizes"
                        : "a grading curve needs a column of sizes and one of percent passing, and `d` is missing",
        expected_header
    );
}

} // namespace

PlainSizes judge_plain_sizes(const Sheet& sheet, const GradingColumns& columns) {
    constexpr std::size_t least = 3;             // of sizes that show a scale
    constexpr double widest = 2000, coarse = 60; // [mm] of what anybody sieves; of stones
    const SizeScale named = columns.size.scale;
    const PlainNumbers plain = read_plain_numbers(sheet, columns);
    const bool is_open = named == SizeScale::Unknown,
               may_be_numbers = plain.count > 0 && plain.whole == plain.count && plain.numbered == plain.count;
    SizeScale scale = named;
    if (named == SizeScale::SieveNumber && plain.count > 0 && plain.whole == 0) {
        scale = SizeScale::Millimeters; // "Sieve No." above 4.75, 2.36 ...: those are openings
    } else if (is_open && plain.smallest < 0 && plain.are_phi && plain.count >= least) { // no grain is below nothing
        scale = SizeScale::Phi;
    } else if (is_open && plain.largest > widest && plain.smallest < coarse) {
        scale = SizeScale::Micrometers;
    } else if (is_open && may_be_numbers && is_ordered(sheet, columns, SizeScale::SieveNumber) && !is_ordered(sheet, columns, SizeScale::Millimeters)) {
        scale = SizeScale::SieveNumber;
    }
    return {scale, plain.count > 0, is_open && plain.count > 0 && plain.foreign > 0};
}

PossibleMeanings find_possible_meanings(const Amounts& amounts) {
    const std::vector<double>& values = amounts.on_sieves;
    const double sum = std::accumulate(values.begin(), values.end(), amounts.pan.value_or(0));
    const double whole = amounts.whole, step = digitizing_step * whole;
    const auto drops = [step](double coarse, double fine) { return fine < coarse - step; };
    const auto climbs = [step](double coarse, double fine) { return fine > coarse + step; };
    const bool is_level = values.empty() || std::ranges::max(values) - std::ranges::min(values) <= step;
    const bool rises = !is_level && std::ranges::adjacent_find(values, drops) == values.end(); // towards fine sieves
    const bool falls = !is_level && std::ranges::adjacent_find(values, climbs) == values.end();
    if (whole == 0) {
        return of_masses(amounts, sum, rises, falls);
    }
    constexpr double most = 1.005;      // of percents that were rounded
    constexpr std::ptrdiff_t least = 3; // shares that add up to 100 by chance are few
    const auto is_near = [whole](double value, double expected) {
        return std::abs(value - expected) <= sieving_loss * whole;
    };
    const bool is_part = std::ranges::all_of(values, [&](double value) { return value >= 0 && value <= most * whole; });
    PossibleMeanings possible;
    possible.adds_up = is_part && is_near(sum, whole) &&
                       std::ranges::count_if(values, [](double value) { return value > 0; }) >= least;
    possible.on_sieve = is_part && sum <= (1 + 2 * sieving_loss) * whole && (!amounts.pan || possible.adds_up);
    const auto agrees = [&](double pan) { return is_near(pan, whole) || is_near(pan, whole - values.back()); };
    possible.cumulative_retained = is_part && rises && (!amounts.pan || agrees(*amounts.pan));
    possible.passing = is_part && falls && amounts.pan.value_or(0) == 0;
    return possible;
}

PossibleMeanings in_common(const PossibleMeanings& a, const PossibleMeanings& b) {
    return {
        a.passing && b.passing, a.cumulative_retained && b.cumulative_retained, a.on_sieve && b.on_sieve,
        a.adds_up && b.adds_up};
}

std::optional<ShareMeaning> choose_meaning(ShareMeaning named, const PossibleMeanings& possible) {
    const auto cumulative = possible.passing ? ShareMeaning::Passing : ShareMeaning::CumulativeRetained;
    const bool is_cumulative = possible.passing != possible.cumulative_retained;
    switch (named) {
    case ShareMeaning::Passing:
    case ShareMeaning::OnSieve:
        return named;
    case ShareMeaning::CumulativeRetained:
        return possible.adds_up && !possible.cumulative_retained ? ShareMeaning::OnSieve : named;
    case ShareMeaning::Retained:
        return possible.adds_up || !possible.cumulative_retained ? std::optional(ShareMeaning::OnSieve)
               : !possible.on_sieve                              ? std::optional(ShareMeaning::CumulativeRetained)
                                                                 : std::nullopt;
    case ShareMeaning::Cumulative:
        return is_cumulative      ? std::optional(cumulative)
               : possible.adds_up ? std::optional(ShareMeaning::OnSieve)
                                  : std::nullopt;
    case ShareMeaning::Unstated:
        return is_cumulative && !possible.adds_up   ? std::optional(cumulative)
               : !is_cumulative && possible.adds_up ? std::optional(ShareMeaning::OnSieve)
                                                    : std::nullopt;
    }
    return std::nullopt;
}

bool is_open(ShareMeaning named) {
    return named == ShareMeaning::Retained || named == ShareMeaning::Cumulative || named == ShareMeaning::Unstated;
}

std::optional<Amounts>
amounts_in(const Sheet& sheet, std::size_t first_row, const SizeColumn& size, std::size_t column) {
    constexpr double most = 100.5; // percents that were rounded
    std::vector<std::pair<double, double>> points;
    Amounts amounts;
    const bool has_pan = std::ranges::count_if(sheet.rows, [&size](const SheetRow& row) {
                             return split_size_text(text_at(row, size.index)).sense == SizeSense::Finer;
                         }) == 1;
    for (const SheetRow* row : value_rows(sheet, first_row)) {
        const RowWord word = read_row_word(text_at(*row, size.index));
        if (is_blank(text_at(*row, column)) || word == RowWord::Total) {
            continue;
        }
        const SizeText text = split_size_text(text_at(*row, size.index));
        const auto d = read_sieve_size(text.text, size.scale, commas_are_decimal(sheet));
        const auto value = number_at(sheet, *row, column);
        const bool is_pan = word == RowWord::Pan || (has_pan && text.sense == SizeSense::Finer) ||
                            (d && d->notation == SizeNotation::Plain && d->diameter == 0 && value.value_or(0) != 0);
        if (!(is_pan || d) || !value || !(*value >= 0 && *value <= most)) {
            return std::nullopt;
        }
        if (is_pan) {
            amounts.pan = amounts.pan.value_or(0) + *value;
        } else {
            points.emplace_back(d->diameter, *value);
        }
    }
    if (size.scale != SizeScale::SieveNumber) { // some may not be on the scale
        std::ranges::stable_sort(points, std::greater{}, &std::pair<double, double>::first);
    }
    for (const auto& [d, value] : points) {
        amounts.on_sieves.push_back(value);
    }
    amounts.whole = whole_of(points);
    return points.size() > 1 ? std::optional(amounts) : std::nullopt;
}

bool may_be_shares(const PossibleMeanings& possible) {
    return possible.passing || possible.cumulative_retained || possible.adds_up;
}

bool names_soils(const Sheet& sheet, std::size_t first_row, const SizeColumn& size, std::size_t column) {
    constexpr std::size_t least = 2;   // rows of a soil
    constexpr double common_range = 2; // of sizes: a hydrometer that goes on below sieves shares less

    struct Block {
        std::string_view name;
        double finest = 0, coarsest = 0;
        std::size_t rows = 0;
    };

    std::vector<Block> blocks;
    std::set<std::string_view> names;
    for (const SheetRow* row : value_rows(sheet, first_row)) {
        const auto d = size_at(sheet, *row, size.index, size.scale);
        if (!d) {
            continue;
        }
        const std::string_view name = text_at(*row, column);
        if (blocks.empty() || blocks.back().name != name) {
            if (is_blank(name) || !names.insert(name).second) {
                return false; // it has come before
            }
            blocks.push_back({name, d->diameter, d->diameter, 0});
        }
        Block& block = blocks.back();
        block.finest = std::min(block.finest, d->diameter), block.coarsest = std::max(block.coarsest, d->diameter);
        ++block.rows;
    }
    if (blocks.size() < 2) {
        return false;
    }
    const double finest = std::ranges::max(blocks, {}, &Block::finest).finest;
    const double coarsest = std::ranges::min(blocks, {}, &Block::coarsest).coarsest;
    const auto is_soil = [](const Block& block) { return block.rows >= least; };
    return std::ranges::all_of(blocks, is_soil) && coarsest > common_range * finest;
}

bool is_cumulative(const Amounts& amounts) {
    const PossibleMeanings possible = find_possible_meanings(amounts);
    return possible.passing || possible.cumulative_retained;
}

std::vector<std::pair<std::size_t, Amounts>> find_share_columns(
    const Sheet& sheet, std::size_t first_row, const SizeColumn& size, const std::vector<std::size_t>& candidates
) {
    std::vector<std::pair<std::size_t, Amounts>> all;
    for (const std::size_t k : candidates) {
        const auto amounts = amounts_in(sheet, first_row, size, k);
        if (amounts && may_be_shares(find_possible_meanings(*amounts))) {
            all.emplace_back(k, *amounts);
        }
    }
    constexpr std::size_t most = 50; // columns that are compared with each other
    auto columns = all;
    std::erase_if(columns, [&all](const auto& own) {
        return all.size() <= most && !is_cumulative(own.second) && std::ranges::any_of(all, [&own](const auto& other) {
                   return is_cumulative(other.second) && are_differences(own.second, other.second);
               });
    });
    return columns;
}

std::optional<std::size_t> find_finer_bound(const Sheet& sheet, std::size_t first_row, std::size_t a, std::size_t b) {
    std::size_t rows = 0, rises = 0;
    for (const SheetRow* row : value_rows(sheet, first_row)) {
        const auto first = number_at(sheet, *row, a), second = number_at(sheet, *row, b);
        if (first && second) {
            ++rows, rises += *first < *second ? 1U : 0U;
        }
    }
    const bool are_bounds = rows > 1 && (rises == 0 || rises == rows);
    return are_bounds ? std::optional(rises == rows ? a : b) : std::nullopt;
}

std::optional<GradingColumns> find_unnamed_columns(const Sheet& sheet, Problems& problems) {
    const auto is_pair = [&sheet](const SheetRow& row) {
        return !row.is_comment && row.cells.size() == 2 && number_at(sheet, row, 1) && is_size(sheet, row, 0);
    };
    GradingColumns found;
    found.first_row = static_cast<std::size_t>(std::ranges::find_if(sheet.rows, is_pair) - sheet.rows.begin());
    const auto values = value_rows(sheet, found.first_row);
    const bool are_two =
        !values.empty() && std::ranges::all_of(values, [](const SheetRow* row) { return row->cells.size() == 2; });
    const bool first = are_two && may_be_sizes(sheet, found.first_row, 0, 1),
               second = are_two && may_be_sizes(sheet, found.first_row, 1, 0);
    if (first == second) {
        complain_about_header(sheet, are_two, problems);
        return std::nullopt;
    }
    for (const SheetRow* title : value_rows(sheet, 0, found.first_row)) {
        if (!is_title(*title)) {
            complain_about_header(sheet, false, problems);
            return std::nullopt;
        }
        problems.warning(
            sheet_remark, title->place, "skipped: it is not a row of two numbers",
            "name the columns in it: `d [mm],passing [%]`"
        );
    }
    found.size = {first ? 0U : 1U, SizeScale::Unknown};
    found.is_headed = false;
    found.shares.push_back({first ? 1U : 0U, {}, "", ShareMeaning::Cumulative, ShareUnit::Unknown, false});
    problems.warning(
        sheet_remark, sheet.rows[found.first_row].place,
        fmt::format(
            "no column headings: the {} is read as the size in mm, the other as a cumulative share",
            first ? "first" : "second"
        ),
        "begin with a line `d [mm],passing [%]` to say so"
    );
    return found;
}

} // namespace suffuse::gradings
