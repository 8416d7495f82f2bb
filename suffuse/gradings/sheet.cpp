#include "suffuse/gradings/sheet.hpp"

#include "suffuse/base/spelling.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace suffuse::gradings {

namespace {

constexpr std::string_view blanks = " \t\r\f\v";

/// Walks along a line and knows the column in characters.
class Ruler {
public:
    explicit Ruler(std::string_view line) : line_(line) {}

    /// Of the byte at `at`, from 1; called with rising places.
    int column(std::size_t at) {
        for (; at_ < at; ++at_) {
            column_ += (static_cast<unsigned char>(line_[at_]) & 0xC0U) != 0x80U ? 1 : 0;
        }
        return column_ + 1;
    }

private:
    std::string_view line_;
    std::size_t at_ = 0;
    int column_ = 0;
};

/// A quote opens at the beginning of a cell only: 3/8" is a size.
class QuoteWatch {
public:
    explicit QuoteWatch(char mark) : mark_(mark) {}

    /// @return whether the next character stands within quotes.
    bool passes(char c) {
        if (c == '\n') {
            is_open_ = just_closed_ = false, at_begin_ = true;
            return false;
        }
        const bool turns = c == '"' && (is_open_ || at_begin_ || just_closed_); // "" within quotes stands for "
        just_closed_ = turns && is_open_;
        is_open_ = is_open_ != turns;
        at_begin_ = !is_open_ && (is_mark(c) || (at_begin_ && blanks.find(c) != std::string_view::npos));
        return is_open_;
    }

    [[nodiscard]] bool is_mark(char c) const { return mark_ == ' ' ? c == ' ' || c == '\t' : c == mark_; }

private:
    char mark_;
    bool is_open_ = false, just_closed_ = false, at_begin_ = true;
};

/// "#N/A", "#REF!", "#WERT!": what a spreadsheet writes in place of a number.
bool is_spreadsheet_error(std::string_view text) {
    const std::size_t end = std::min(text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ/0", 1), text.size());
    const std::string_view word = text.substr(0, end);
    return word == "#N/A" || word == "#NV" || (end > 1 && end < text.size() && (text[end] == '!' || text[end] == '?'));
}

/// Whether a # begins a comment: behind a value, or in a cell of its own. "#200" and "# 4" are sieves, and that of
/// "Sieve #" is a word. @param cell where its cell begins @param before what stands before it there
bool begins_comment(std::string_view line, std::size_t at, std::string_view before, char mark) {
    const std::string_view after = line.substr(at + 1), text = trimmed(after.substr(0, after.find(mark)));
    const bool is_apart = at == 0 || blanks.find(line[at - 1]) != std::string_view::npos || line[at - 1] == mark;
    if (!is_apart || (!after.empty() && is_digit(after[0])) || is_spreadsheet_error(line.substr(at))) {
        return false;
    }
    if (!trimmed(before).empty()) {
        return before.find_first_of("0123456789") != std::string_view::npos;
    }
    const bool is_start = trimmed(line.substr(0, at)).empty();
    const bool is_heading = !after.empty() && after[0] == mark && mark != ' '; // "#,d [mm]", above 1, 2, 3
    return is_start ? !is_heading : text.find_first_not_of("0123456789 ") != std::string_view::npos;
}

/// The line without its comment.
std::string_view without_comment(std::string_view line, char mark) {
    QuoteWatch watch(mark);
    std::size_t cell = 0;
    for (std::size_t k = 0; k < line.size(); ++k) {
        const bool is_within = watch.passes(line[k]), is_cut_by_blanks = mark == ' ' || mark == wide_blanks;
        if (!is_within && line[k] == '#' && begins_comment(line, k, line.substr(cell, k - cell), mark)) {
            return line.substr(0, k);
        }
        cell = !is_within && !is_cut_by_blanks && watch.is_mark(line[k]) ? k + 1 : cell;
    }
    return line;
}

std::string unquoted(std::string_view text) {
    std::string plain;
    for (std::size_t k = 1; k + 1 < text.size(); ++k) {
        plain += text[k];
        k += text[k] == '"' && text[k + 1] == '"' ? 1U : 0U; // "" stands for "
    }
    return std::string(trimmed(plain));
}

/// Past the cell that begins here.
std::size_t end_of_cell(std::string_view line, std::size_t begin, char mark) {
    QuoteWatch watch(mark);
    for (std::size_t k = begin; k < line.size(); ++k) {
        if (!watch.passes(line[k]) && watch.is_mark(line[k])) {
            return k;
        }
    }
    return line.size();
}

SheetRow split_line(const std::shared_ptr<const Source>& source, std::string_view line, int number, char mark) {
    SheetRow row;
    row.place = {source, number, 1, std::max(1, Ruler(line).column(line.size()) - 1)};
    Ruler ruler(line);
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = end_of_cell(line, begin, mark);
        std::string_view text = trimmed(line.substr(begin, end - begin));
        begin = end + 1;
        if ((mark == ' ' || mark == wide_blanks) && text.empty()) {
            continue;
        }
        const auto first = static_cast<std::size_t>(text.data() - line.data());
        const int column = ruler.column(text.empty() ? end : first);
        const int length = text.empty() ? 1 : ruler.column(first + text.size()) - column;
        const bool is_quoted = text.size() > 1 && text.front() == '"' && text.back() == '"';
        row.cells.push_back(
            {is_quoted ? unquoted(text) : std::string(text), {source, number, column, length}, is_quoted}
        );
    }
    return row;
}

/// A line drawn between rows: "--------", "|---|---|".
bool is_rule(std::string_view line) {
    const bool has_run = line.find("---") != std::string_view::npos || line.find("===") != std::string_view::npos ||
                         line.find("___") != std::string_view::npos;
    return has_run && line.find_first_not_of("-=_+|: \t") == std::string_view::npos;
}

bool is_plain_number(std::string_view text) {
    const std::size_t first = text.find_first_of("0123456789");
    return first <= 1 && (first == 0 || text[0] == '.' || text[0] == '-') &&
           text.find_first_not_of("0123456789.,-+eE") == std::string_view::npos;
}

/// Whether a cell that a blank keeps from the one before belongs to it: "No. 4", "75 um", "passing [%]", "% passing".
bool belongs_to(const SheetCell& before, std::string_view text) {
    const std::string_view last = before.text;
    const bool is_bracket = text.starts_with('[') || text.starts_with('(');
    if (text == "#") {
        return !is_plain_number(last); // "Sieve #"
    }
    const bool is_number_word =
        last == "No." || last == "No" || last == "Nr." || last == "N\u00b0" || last == "#" || last == "%";
    const bool is_unit = text == "mm" || text == "um" || text == "\u00b5m" || text == "\u03bcm" || text == "cm" ||
                         text == "in" || text == "in." || text == "inch" || text == "micron" || text == "microns" ||
                         text == "%";
    return is_bracket || is_number_word || (is_unit && is_plain_number(last));
}

/// Joins what single blanks tore apart.
void join_cells(SheetRow& row) {
    std::vector<SheetCell> joined;
    for (SheetCell& cell : row.cells) {
        if (!joined.empty() && !cell.is_quoted && belongs_to(joined.back(), cell.text)) {
            joined.back().place.length = cell.place.column + cell.place.length - joined.back().place.column;
            joined.back().text += " " + cell.text;
        } else {
            joined.push_back(std::move(cell));
        }
    }
    row.cells = std::move(joined);
}

/// A wide gap is a mark, a narrow one none.
std::string with_wide_gaps(std::string_view text) {
    std::string line(text);
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        const bool is_wide = line[k] == '\t' || (line[k] == ' ' && (line[k + 1] == ' ' || line[k + 1] == '\t'));
        line[k] = is_wide || (k > 0 && line[k] == ' ' && line[k - 1] == wide_blanks) ? wide_blanks : line[k];
    }
    return line;
}

/// Whether all rows have the same cells, two at least.
bool is_even(const Sheet& sheet) {
    std::size_t columns = 0;
    for (const SheetRow& row : sheet.rows) {
        if (!row.is_comment && (row.cells.size() < 2 || (columns > 0 && row.cells.size() != columns))) {
            return false;
        }
        columns = row.is_comment ? columns : row.cells.size();
    }
    return columns > 0;
}

/// Characters of a line, from the first to behind the last.
struct Span {
    int first = 0, end = 0;
};

Span span_of(const SheetCell& cell) {
    return {cell.place.column, cell.place.column + cell.place.length};
}

/// What the cells of the longest rows cover, column by column.
std::vector<Span> columns_of(const std::vector<SheetRow>& rows, std::size_t begin, std::size_t end) {
    std::size_t most = 0;
    for (std::size_t k = begin; k < end; ++k) {
        most = std::max(most, rows[k].cells.size());
    }
    std::vector<Span> columns;
    for (std::size_t k = begin; k < end; ++k) {
        for (std::size_t c = 0; c < most && rows[k].cells.size() == most; ++c) {
            const Span span = span_of(rows[k].cells[c]);
            if (c == columns.size()) {
                columns.push_back(span);
            }
            columns[c] = {std::min(columns[c].first, span.first), std::max(columns[c].end, span.end)};
        }
    }
    return columns;
}

/// The column that a cell stands in; of several below it the last one that begins before it does.
std::size_t column_of(const Span& cell, const std::vector<Span>& columns) {
    std::vector<std::size_t> below;
    std::size_t nearest = 0;
    int least = -1;
    for (std::size_t c = 0; c < columns.size(); ++c) {
        const int gap = std::max(columns[c].first - cell.end, cell.first - columns[c].end);
        if (gap < 0) {
            below.push_back(c);
        }
        if (least < 0 || std::max(gap, 0) < least) {
            nearest = c, least = std::max(gap, 0);
        }
    }
    if (below.size() < 2) {
        return below.empty() ? nearest : below.front();
    }
    const auto begins_before = [&](std::size_t c) { return columns[c].first <= cell.first; };
    const auto last = std::find_if(below.rbegin(), below.rend(), begins_before);
    return last == below.rend() ? below.front() : *last;
}

void align_row(SheetRow& row, const std::vector<Span>& columns) {
    if (row.is_comment || row.cells.size() < 2 || row.cells.size() >= columns.size()) {
        return;
    }
    std::vector<std::size_t> places;
    for (const SheetCell& cell : row.cells) {
        const std::size_t place = column_of(span_of(cell), columns);
        if (!places.empty() && place <= places.back()) {
            return;
        }
        places.push_back(place);
    }
    std::vector<SheetCell> aligned(places.back() + 1, SheetCell{{}, row.place, false});
    for (std::size_t k = 0; k < places.size(); ++k) {
        aligned[places[k]] = std::move(row.cells[k]);
    }
    row.cells = std::move(aligned);
}

} // namespace

Sheet split_sheet(const std::shared_ptr<const Source>& source, char mark) {
    Sheet sheet{{}, mark};
    int number = 0;
    const std::string_view text = source->text;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        std::string_view line = text.substr(begin, end - begin);
        begin = end + 1;
        ++number;
        const std::string_view start = trimmed(line);
        const bool is_comment = start.starts_with('#') && begins_comment(start, 0, {}, mark);
        if (is_comment) { // its column numbers stay true: # is a blank
            line.remove_prefix(static_cast<std::size_t>(start.data() - line.data()) + 1);
        } else {
            line = without_comment(line, mark);
        }
        line = line.substr(0, line.find_last_not_of(" \r") + 1);
        if (line.find_first_not_of(" \t;,|\"") == std::string_view::npos || is_rule(line)) {
            continue; // the empty rows of a sheet have marks
        }
        sheet.rows.push_back(
            split_line(source, mark == wide_blanks ? with_wide_gaps(line) : std::string(line), number, mark)
        );
        sheet.rows.back().is_comment = is_comment;
        std::vector<SheetCell>& cells = sheet.rows.back().cells;
        while (cells.size() > 1 && cells.back().text.empty()) {
            cells.pop_back();
        }
    }
    if (mark == ' ') {
        if (Sheet wide = split_sheet(source, wide_blanks); is_even(wide)) {
            return {std::move(wide.rows), mark};
        }
        for (SheetRow& row : sheet.rows) {
            join_cells(row);
        }
    }
    return sheet;
}

std::vector<char> possible_marks(std::string_view text) {
    std::vector<char> found;
    for (const char mark : std::array{';', '\t', '|', ','}) {
        bool is_there = false;
        for (std::size_t begin = 0; begin < text.size() && !is_there;) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            const std::string_view line = without_comment(text.substr(begin, end - begin), mark);
            is_there = line.find(mark) != std::string_view::npos && end_of_cell(line, 0, mark) < line.size();
            begin = end + 1;
        }
        if (is_there) {
            found.push_back(mark);
        }
    }
    if (text.find("  ") != std::string_view::npos) {
        found.push_back(wide_blanks);
    }
    found.push_back(' ');
    return found;
}

void align_rows(Sheet& sheet) {
    for (std::size_t begin = 0, end = 0; begin < sheet.rows.size(); begin = end) {
        for (end = begin + 1; end < sheet.rows.size(); ++end) {
            if (sheet.rows[end].place.line != sheet.rows[end - 1].place.line + 1) {
                break;
            }
        }
        const auto columns = columns_of(sheet.rows, begin, end);
        for (std::size_t k = begin; k < end; ++k) {
            align_row(sheet.rows[k], columns);
        }
    }
}

} // namespace suffuse::gradings
