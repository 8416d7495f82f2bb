#include "suffuse/report/html.hpp"

#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>

namespace suffuse::report {

namespace {

/// "5.6 × 10⁻¹¹" for "5.6·10⁻¹¹" and for the "5.6e-11" of a text that a program wrote.
std::string with_powers(std::string text) {
    static const std::regex written(R"((^|[^\w.])(\d+(?:\.\d+)?)e([-+])0*(\d{1,3})\b)");
    const bool may_have = text.find("e-") != std::string::npos || text.find("e+") != std::string::npos;
    for (std::smatch found; may_have && std::regex_search(text, found, written);) {
        const int exponent = std::stoi(found.str(4)) * (found.str(3) == "-" ? -1 : 1);
        text = found.prefix().str() + found.str(1) + found.str(2) + "·" + power_of_ten(exponent) + found.suffix().str();
    }
    const std::string dot = "·10", times = "\u00a0×\u00a010";
    for (std::size_t at = text.find(dot); at != std::string::npos; at = text.find(dot, at + times.size())) {
        text.replace(at, dot.size(), times);
    }
    return text;
}

/// Words between back quotes are code.
std::string set_text(const std::string& text) {
    static const std::regex quoted("`([^`]+)`");
    return std::regex_replace(with_powers(with_indices(escaped(text))), quoted, "<code>$1</code>");
}

} // namespace

std::string with_indices(std::string html) {
    static const std::regex indexed(R"(\b(e|FC|i)_(min|g|eq|active|threshold|c)\b)");
    return html.find('_') == std::string::npos ? html : std::regex_replace(html, indexed, "$1<sub>$2</sub>");
}

std::string html_table(
    const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
    const std::vector<bool>& numeric, std::string_view css_class, std::string_view caption
) {
    constexpr std::size_t long_text = 40; // on a narrow screen, of a word a line, it would make its row tall
    constexpr std::size_t rows_of_a_page = 25, columns_of_a_page = 8;
    const auto cell = [&numeric](const char* tag, std::size_t column, const std::string& text) {
        const bool right = column < numeric.size() && numeric[column];
        const char* const kind = right ? " class=\"number\"" : text.size() > long_text ? " class=\"long\"" : "";
        return fmt::format("<{0}{1}>{2}</{0}>", tag, kind, set_text(text));
    };
    // Wide tables scroll inside their own frame, which the keyboard must be able to reach.
    std::string out = fmt::format(
        "<div class=\"scroll{}{}\" tabindex=\"0\"><table class=\"{}\">{}<thead><tr>",
        rows.size() > rows_of_a_page ? " long" : "", header.size() > columns_of_a_page ? " broad" : "",
        escaped(std::string(css_class)), caption.empty() ? "" : fmt::format("<caption>{}</caption>", caption)
    );
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

std::string in_figures(double value, int digits) {
    constexpr double longest = 1e9;
    if (!std::isfinite(value)) {
        return "";
    }
    if (value == std::round(value) && std::abs(value) < longest) { // counts and steps, to the last
        return fmt::format("{}{:.0f}", value < 0 ? "−" : "", std::abs(value));
    }
    return with_powers(short_number(value, digits));
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
            const auto* numbers = std::get_if<std::vector<double>>(&table.columns()[column].values);
            cells.push_back(numbers == nullptr ? table.cell(row, column) : in_figures((*numbers)[row], digits));
        }
        rows.push_back(std::move(cells));
    }
    return html_table(header, rows, numeric, "numbers");
}

std::string typeset(const std::string& text) {
    return set_text(kept_together(text));
}

std::string html_list(const std::vector<std::string>& lines, std::string_view css_class) {
    std::string out = fmt::format("<ul class=\"{}\">\n", css_class);
    for (const std::string& line : lines) {
        out += "<li>" + typeset(line) + "</li>\n";
    }
    return out + "</ul>\n";
}

} // namespace suffuse::report
