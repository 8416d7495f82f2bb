#include "suffuse/gradings/unnamed_shares.hpp"

#include "suffuse/gradings/lexicon.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace suffuse::gradings {

namespace {

/// Numbers of the longest part that never falls, whatever stands between them.
std::size_t longest_rise(const std::vector<double>& values) {
    std::vector<std::size_t> lengths;
    for (std::size_t k = 0; k < values.size(); ++k) {
        std::size_t before = 0;
        for (std::size_t i = 0; i < k; ++i) {
            before = values[i] <= values[k] ? std::max(before, lengths[i]) : before;
        }
        lengths.push_back(before + 1);
    }
    return lengths.empty() ? 0 : std::ranges::max(lengths);
}

/// Whether most of a column's cells are cumulative shares of one soil.
bool is_soil_but_for_cells(
    const Sheet& sheet, std::size_t first_row, const SizeColumn& size, std::size_t column, ShareMeaning meaning
) {
    constexpr double most = 100.5, nearly_all = 0.9; // of percents that were rounded; what passes the coarsest sieve
    constexpr std::size_t least = 3, most_rows = 300;
    std::vector<std::pair<double, double>> points;
    std::size_t cells = 0;
    for (const SheetRow* row : value_rows(sheet, first_row)) {
        const auto d = size_at(sheet, *row, size.index, size.scale);
        if (d && !is_blank(text_at(*row, column))) {
            const auto value = number_at(sheet, *row, column);
            ++cells;
            if (value && *value >= 0 && *value <= most) {
                points.emplace_back(d->diameter, *value);
            }
        }
    }
    std::ranges::stable_sort(points, {}, &std::pair<double, double>::first);
    if (meaning == ShareMeaning::CumulativeRetained) {
        std::ranges::reverse(points);
    }
    std::vector<double> values;
    for (const auto& [d, value] : points) {
        values.push_back(value);
    }
    if (values.size() < least || values.size() > most_rows) {
        return false;
    }
    const auto [lowest, highest] = std::ranges::minmax(values);
    const bool is_full = highest >= nearly_all * (highest > 1 ? 100 : 1);
    const std::size_t rise = longest_rise(values);
    return is_full && highest > lowest && rise >= least && 3 * rise >= 2 * cells;
}

} // namespace

bool is_index(const Sheet& sheet, std::size_t first_row, std::size_t column, std::string_view heading) {
    const std::string words = spaced_words(heading);
    const auto parts = split_words(words, " ");
    if (!std::ranges::all_of(parts, [](std::string_view word) { return is_word_of(Topic::Index, word); })) {
        return false;
    }
    constexpr std::size_t least = 3; // rows that are not numbered by chance
    std::optional<double> last, step;
    std::size_t rows = 0;
    for (const SheetRow* row : value_rows(sheet, first_row)) {
        const auto number = number_at(sheet, *row, column);
        const bool is_first = !last || !number;
        const double own_step = is_first ? 0 : *number - *last;
        if (!number || *number != std::round(*number) || (!is_first && std::abs(own_step) != 1) ||
            (step && own_step != *step)) {
            return false;
        }
        step = is_first ? step : own_step, last = number, ++rows;
    }
    return rows >= least;
}

OddSoils find_soils_with_odd_cells(
    const Sheet& sheet, std::size_t first_row, const SizeColumn& size, const std::vector<std::size_t>& candidates,
    const std::vector<std::pair<std::size_t, Amounts>>& columns
) {
    const auto are_all = [&columns](bool PossibleMeanings::*kind) {
        return !columns.empty() && std::ranges::all_of(columns, [kind](const auto& column) {
            return find_possible_meanings(column.second).*kind;
        });
    };
    OddSoils odd;
    if (!are_all(&PossibleMeanings::passing)) {
        odd.meaning = ShareMeaning::CumulativeRetained;
    }
    if (odd.meaning == ShareMeaning::CumulativeRetained && !are_all(&PossibleMeanings::cumulative_retained)) {
        return odd;
    }
    for (const std::size_t k : candidates) {
        const auto amounts = amounts_in(sheet, first_row, size, k);
        const bool is_good = amounts && may_be_shares(find_possible_meanings(*amounts));
        if (!is_good && is_soil_but_for_cells(sheet, first_row, size, k, odd.meaning)) {
            odd.columns.push_back(k);
        }
    }
    return odd;
}

} // namespace suffuse::gradings
