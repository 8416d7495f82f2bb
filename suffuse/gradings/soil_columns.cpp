#include "suffuse/gradings/soil_columns.hpp"

#include "suffuse/gradings/lexicon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace suffuse::gradings {

namespace {

using Columns = std::vector<std::size_t>;
using Names = std::vector<std::string>;

bool are_distinct(const Names& names) {
    const std::set<std::string> all(names.begin(), names.end());
    return all.size() == names.size() && !all.contains("");
}

/// What a row above the headings says over each column; cells that were merged have their text in the first one.
Names texts_over(const SheetRow& row, const Columns& columns) {
    Names texts;
    for (const std::size_t column : columns) {
        std::size_t k = column;
        while (k > columns.front() && is_blank(text_at(row, k))) {
            --k;
        }
        texts.push_back(text_at(row, k));
    }
    return texts;
}

/// Whether these may be names of soils: over every column one that heads none, and not one over all of them.
bool are_names(const SheetRow& row, const Columns& columns, const Names& texts) {
    const bool are_all = std::ranges::none_of(texts, [](const std::string& text) {
        const ColumnKind kind = read_heading(text).kind;
        return is_blank(text) || (kind != ColumnKind::Other && kind != ColumnKind::Sample);
    });
    const bool are_apart = std::ranges::none_of(columns, [&row](std::size_t k) { return is_blank(text_at(row, k)); });
    return are_all && (are_apart || std::set<std::string>(texts.begin(), texts.end()).size() > 1);
}

bool keeps_each(ShareMeaning meaning) {
    return meaning == ShareMeaning::OnSieve || meaning == ShareMeaning::Retained;
}

enum class RowLabel { None, Sample, Other };

/// What stands before the columns: "Borehole", "Depth (m)".
RowLabel label_of(const SheetRow& row, const Columns& columns) {
    for (std::size_t k = 0; k < columns.front(); ++k) {
        const std::string& text = text_at(row, k);
        if (!is_blank(text)) {
            const auto named = std::string_view(text).substr(0, text.find(':'));
            return read_heading(named).kind == ColumnKind::Sample ? RowLabel::Sample : RowLabel::Other;
        }
    }
    return RowLabel::None;
}

/// Names in the rows right above the headings, joined; else those of all rows that say that they name samples.
Names names_above(const Sheet& sheet, std::size_t header_row, const Columns& columns) {
    Names joined(columns.size());
    bool is_next = true, has_unlabeled = false;
    int line = sheet.rows[header_row].place.line;
    auto rows = value_rows(sheet, 0, header_row);
    std::ranges::reverse(rows);
    for (const SheetRow* row : rows) {
        const Names texts = texts_over(*row, columns);
        const RowLabel label = label_of(*row, columns);
        is_next = is_next && (!has_unlabeled || row->place.line + 1 == line);
        const bool counts = is_next ? label != RowLabel::Other : label == RowLabel::Sample && !has_unlabeled;
        const bool are_theirs = counts && are_names(*row, columns, texts);
        for (std::size_t c = 0; c < columns.size() && are_theirs; ++c) {
            joined[c] = fmt::format("{}{}{}", texts[c], joined[c].empty() ? "" : " ", joined[c]);
        }
        is_next = is_next && are_theirs, line = row->place.line;
        has_unlabeled = has_unlabeled || (are_theirs && label == RowLabel::None);
    }
    return joined;
}

/// Whether masses are those of which the percents are, to the digit that is printed: they say the same with more.
bool agree(const Sheet& sheet, std::size_t masses, std::size_t percents, std::size_t first_row) {
    constexpr double rounding = 0.0006; // of percents with one digit, and a little
    double sum = 0;
    std::vector<std::pair<double, double>> pairs;
    for (const SheetRow* row : value_rows(sheet, first_row)) {
        const bool is_total = read_row_word(first_text(*row)) == RowWord::Total;
        const auto mass = number_at(sheet, *row, masses), percent = number_at(sheet, *row, percents);
        if (!is_total && mass.has_value() != percent.has_value()) {
            return false;
        }
        if (!is_total && mass) {
            sum += *mass, pairs.emplace_back(*mass, *percent);
        }
    }
    return pairs.size() > 2 && sum > 0 && std::ranges::all_of(pairs, [sum](const std::pair<double, double>& pair) {
               return std::abs(pair.first / sum - pair.second / 100) <= rounding;
           });
}

/// "% finer total" next to "% finer -#10": of the whole sample.
bool is_of_total(const Heading& heading, const std::string& text) {
    const std::string words = fmt::format(" {} ", plain_words(text));
    return heading.unit != ShareUnit::Mass && mentions(Topic::TotalSample, words);
}

/// Of the columns of one soil that of the whole sample; percents rather than masses, whose whole may be another, unless
/// both are the same.
void choose_best(
    const Sheet& sheet, const std::vector<Heading>& headings, std::size_t header_row, std::size_t first_row,
    Columns& columns
) {
    const auto is_percent = [&headings](std::size_t k) { return headings[k].unit != ShareUnit::Mass; };
    const auto is_whole = [&](std::size_t k) { return is_of_total(headings[k], text_at(sheet.rows[header_row], k)); };
    if (columns.size() > 1 && std::ranges::count_if(columns, is_percent) == 1) {
        const std::size_t percents = *std::ranges::find_if(columns, is_percent);
        const std::size_t masses = columns.front() == percents ? columns.back() : columns.front();
        const bool are_one =
            columns.size() == 2 && keeps_each(headings[masses].meaning) && agree(sheet, masses, percents, first_row);
        columns = {are_one ? masses : percents};
    } else if (columns.size() > 1 && std::ranges::count_if(columns, is_whole) == 1) {
        columns = {*std::ranges::find_if(columns, is_whole)};
    }
}

} // namespace

std::vector<SoilColumns> find_soil_columns(
    const Sheet& sheet, const std::vector<Heading>& headings, const std::vector<std::size_t>& columns,
    std::size_t header_row, std::size_t first_row
) {
    Names names;
    for (const std::size_t k : columns) {
        names.push_back(columns.size() > 1 ? headings[k].rest : "");
    }
    if (columns.size() > 1 && !are_distinct(names)) {
        const Names above = names_above(sheet, header_row, columns);
        names = std::ranges::find(above, "") == above.end() ? above : Names(columns.size()); // of one soil
    }
    std::vector<SoilColumns> soils;
    for (std::size_t k = 0; k < columns.size(); ++k) {
        auto soil = std::ranges::find(soils, names[k], &SoilColumns::name);
        soil = soil == soils.end() ? soils.insert(soils.end(), {names[k], {}}) : soil;
        soil->columns.push_back(columns[k]);
    }
    for (SoilColumns& soil : soils) {
        choose_best(sheet, headings, header_row, first_row, soil.columns);
    }
    return soils;
}

} // namespace suffuse::gradings
