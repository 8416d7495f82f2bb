#include "suffuse/report/figure_block.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/report/html.hpp"

#include <fmt/format.h>

namespace suffuse::report {

namespace {

constexpr std::size_t most_rows_shown = 60; ///< of a figure's numbers; its CSV has them all

/// The drawing with the page's title and caption as its own.
std::string described_by_page(std::string drawing, const std::string& id) {
    const std::string opening = "<svg";
    if (const std::size_t at = drawing.find(opening); at != std::string::npos) {
        drawing.insert(
            at + opening.size(), fmt::format(" aria-labelledby=\"{0}-title\" aria-describedby=\"{0}-caption\"", id)
        );
    }
    return drawing;
}

std::string picture_of(const figures::Figure& figure, const std::string& id) {
    if (!figure.flat.empty()) {
        return "<p class=\"flat\">" + typeset(figure.flat) + "</p>\n";
    }
    if (!figure.drawing.empty()) {
        return "<div class=\"drawing\">" + described_by_page(figure.drawing, id) + "</div>\n";
    }
    return fmt::format("<div class=\"chart\" data-chart=\"{}\">{}</div>\n", id, described_by_page(figure.still, id));
}

std::string numbers_of(const figures::Figure& figure, const ReportData& report) {
    const std::size_t rows = figure.table.rows();
    std::string out = fmt::format(
        "<details class=\"numbers-of\"><summary>Numbers ({}{})</summary>\n",
        rows > most_rows_shown ? "the first " + std::to_string(most_rows_shown) + " of " : "",
        rows == 1 ? "1 row" : grouped(static_cast<long long>(rows)) + " rows"
    );
    out += html_table(figure.table, most_rows_shown);
    if (!report.redraw.empty()) {
        out += "<p class=\"quiet\">Redraw: <code>" + escaped(report.redraw) + "</code></p>\n";
    }
    return out + "</details>\n";
}

} // namespace

std::vector<std::pair<std::string, std::string>> csv_remarks(const figures::Figure& figure, const ReportData& report) {
    std::vector<std::pair<std::string, std::string>> remarks = {
        {"figure", figure.id}, {"title", figure.title}, {"case", report.title}, {"run", report.run}};
    remarks.insert(remarks.end(), report.provenance.begin(), report.provenance.end());
    return remarks;
}

std::string with_metadata(const figures::Figure& figure, const ReportData& report) {
    std::string lines;
    for (const auto& [key, value] : csv_remarks(figure, report)) {
        lines += escaped(key + ": " + value) + "\n";
    }
    std::string drawing = figure.drawing;
    return drawing.insert(drawing.find('>') + 1, "<metadata>\n" + lines + "</metadata>");
}

std::string figure_block(const figures::Figure& figure, const ReportData& report, Numbering& numbering) {
    const std::string id = escaped(figure.id);
    const bool is_wide = figure.chart.contains("facet");
    std::string out = fmt::format(
        "<figure id=\"{0}\" class=\"figure{2}\" data-figure=\"{0}\">\n<h3 id=\"{0}-title\">{1}</h3>\n", id,
        typeset(figure.claim.empty() ? figure.title : figure.claim),
        is_wide                  ? " wide"
        : figure.drawing.empty() ? ""
                                 : " wide drawn"
    );
    out += picture_of(figure, id);
    const std::optional<int> of_paper = figures::figure_of_paper(figure.id);
    const std::string papers = of_paper && !report.paper.empty() ? fmt::format(" (Paper: Figure {}.)", *of_paper) : "";
    out += fmt::format(
        "<div class=\"about\">\n<figcaption id=\"{}-caption\"><b>{}</b> {}{}</figcaption>\n", id,
        numbering.next_figure(), typeset(figure.caption), papers
    );
    out += fmt::format(
        "<div class=\"tools\"><span class=\"buttons\" data-buttons=\"{0}\"></span><a "
        "href=\"figures/{0}.csv\">{0}.csv</a></div>\n",
        id
    );
    return out + numbers_of(figure, report) + "</div>\n</figure>\n";
}

std::string table_block(const figures::PageTable& table, Numbering& numbering) {
    const std::string caption = fmt::format(
        "<b>{} {}.</b>{}{}", numbering.next_table(), typeset(table.title), table.note.empty() ? "" : " ",
        typeset(table.note)
    );
    return html_table(table.header, table.rows, table.numeric, "page-table", caption);
}

} // namespace suffuse::report
