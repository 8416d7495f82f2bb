#include "suffuse/report/html.hpp"

#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

namespace suffuse::report {

std::string with_indices(std::string html) {
    static const std::regex indexed(R"(\b(e|FC)_(min|g|eq|active|threshold)\b)");
    return html.find('_') == std::string::npos ? html : std::regex_replace(html, indexed, "$1<sub>$2</sub>");
}

std::string html_table(
    const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
    const std::vector<bool>& numeric, std::string_view css_class
) {
    constexpr std::size_t long_text = 40; // on a narrow screen, of a word a line, it would make its row tall
    const auto cell = [&numeric](const char* tag, std::size_t column, const std::string& text) {
        const bool right = column < numeric.size() && numeric[column];
        const char* const kind = right ? " class=\"number\"" : text.size() > long_text ? " class=\"long\"" : "";
        return fmt::format("<{0}{1}>{2}</{0}>", tag, kind, with_indices(escaped(text)));
    };
    // Wide tables scroll inside their own frame, which the keyboard must be able to reach.
    std::string out = "<div class=\"scroll\" tabindex=\"0\"><table class=\"" + escaped(css_class) + "\"><thead><tr>";
    for (std::size_t column = 0; column < header.size(); ++column) {
        out += cell("th", column, header[column]);
    }
    out += "</tr></thead><tbody>\n";
    for (const std::vector<std::string>& row : rows) {
        out += "<tr>";
        for (std::size_t column = 0; column < row.size(); ++column) {
            out += cell("td", column, row[column]);
        }
        out += "</tr>\n";
    }
    return out + "</tbody></table></div>\n";
}

std::string html_table(const figures::Table& table, std::size_t most_rows) {
    constexpr int digits = 6;
    std::vector<std::string> header;
    std::vector<bool> numeric;
    for (const figures::Column& column : table.columns()) {
        header.push_back(figures::heading(column));
        numeric.push_back(std::holds_alternative<std::vector<double>>(column.values));
    }
    std::vector<std::vector<std::string>> rows;
    for (std::size_t row = 0; row < std::min(table.rows(), most_rows); ++row) {
        std::vector<std::string> cells;
        for (std::size_t column = 0; column < header.size(); ++column) {
            cells.push_back(table.cell(row, column, digits));
        }
        rows.push_back(std::move(cells));
    }
    return html_table(header, rows, numeric, "numbers");
}

std::string typeset(const std::string& text) {
    static const std::regex quoted("`([^`]+)`");
    return std::regex_replace(with_indices(escaped(kept_together(text))), quoted, "<code>$1</code>");
}

std::string html_list(const std::vector<std::string>& lines, std::string_view css_class) {
    std::string out = fmt::format("<ul class=\"{}\">\n", css_class);
    for (const std::string& line : lines) {
        out += "<li>" + typeset(line) + "</li>\n";
    }
    return out + "</ul>\n";
}

} // namespace suffuse::report
