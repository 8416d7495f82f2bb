#include "suffuse/report/page.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/report/answer_section.hpp"
#include "suffuse/report/html.hpp"
#include "suffuse/report/packed.hpp"
#include "suffuse/report/scene_section.hpp"
#include "suffuse/report/still.hpp"
#include "suffuse/report/style.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>

namespace suffuse::report {

namespace {

using nlohmann::json;
using Remarks = std::vector<std::pair<std::string, std::string>>;

constexpr std::size_t most_rows_shown = 60; ///< of a figure's numbers; its CSV has them all
const std::array<const char*, 5> figure_sections = {"Soils", "Fines and structure", "Tests", "Water", "Erosion"};

/// What page/build.sh leaves: the script, its hash for the content policy, the notices of what is bundled in it.
struct PageScript {
    std::string code, sha256, notices;
};

std::optional<std::string> read_text(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) {
        return std::nullopt;
    }
    std::ostringstream text;
    text << in.rdbuf();
    return std::move(text).str();
}

std::optional<PageScript> read_page_script(const std::filesystem::path& folder) {
    if (folder.empty()) {
        return std::nullopt;
    }
    std::optional<std::string> code = read_text(folder / "page.js"), hash = read_text(folder / "page.js.sha256");
    if (!code || !hash) {
        return std::nullopt;
    }
    const auto is_base64 = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '+' || c == '/' || c == '=';
    };
    while (!hash->empty() && hash->back() == '\n') {
        hash->pop_back();
    }
    // A script that could end its element, or a hash that is none, is no script of ours.
    if (code->find("</script") != std::string::npos || !std::all_of(hash->begin(), hash->end(), is_base64)) {
        return std::nullopt;
    }
    return PageScript{std::move(*code), std::move(*hash), read_text(folder / "notices.txt").value_or("")};
}

std::string anchor(const std::string& name) {
    std::string id;
    for (const char letter : name) {
        if (letter >= 'A' && letter <= 'Z') {
            id += static_cast<char>(letter - 'A' + 'a');
        } else {
            const bool keeps = (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9');
            id += keeps ? letter : '-';
        }
    }
    return id;
}

std::string section(const std::string& name, const std::string& content) {
    return fmt::format(
        "<section id=\"{0}\" aria-labelledby=\"{0}-heading\">\n<h2 id=\"{0}-heading\">{1}</h2>\n{2}</section>\n",
        anchor(name), escaped(name), content
    );
}

Remarks csv_remarks(const figures::Figure& figure, const ReportData& report) {
    Remarks remarks = {{"figure", figure.id}, {"title", figure.title}, {"case", report.title}, {"run", report.run}};
    remarks.insert(remarks.end(), report.provenance.begin(), report.provenance.end());
    return remarks;
}

/// The drawing as a file of its own, which says where it comes from as the CSV of its numbers does.
std::string with_metadata(const figures::Figure& figure, const ReportData& report) {
    std::string lines;
    for (const auto& [key, value] : csv_remarks(figure, report)) {
        lines += escaped(key + ": " + value) + "\n";
    }
    std::string drawing = figure.drawing;
    return drawing.insert(drawing.find('>') + 1, "<metadata>\n" + lines + "</metadata>");
}

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

std::string figure_block(const figures::Figure& figure, const ReportData& report) {
    const std::string id = escaped(figure.id);
    std::string out = fmt::format(
        "<figure id=\"{0}\" class=\"figure{2}\" data-figure=\"{0}\">\n<h3 id=\"{0}-title\">{1}</h3>\n", id,
        escaped(figure.title),
        figure.chart.contains("facet") ? " wide"
        : figure.drawing.empty()       ? ""
                                       : " wide drawn"
    );
    if (!figure.flat.empty()) {
        out += "<p class=\"flat\">" + typeset(figure.flat) + "</p>\n";
    } else if (figure.drawing.empty()) {
        out += fmt::format("<div class=\"chart\" data-chart=\"{}\"></div>\n", id);
    } else {
        out += "<div class=\"drawing\">" + described_by_page(figure.drawing, id) + "</div>\n";
    }
    const std::optional<int> of_paper = figures::figure_of_paper(figure.id);
    const std::string number =
        of_paper && !report.paper.empty() ? fmt::format("Like Figure {} of the paper. ", *of_paper) : "";
    out += fmt::format(
        "<div class=\"about\">\n<figcaption id=\"{}-caption\"><b>{}</b>{}</figcaption>\n", id, number,
        typeset(figure.caption)
    );
    out += fmt::format(
        "<div class=\"tools\"><span class=\"buttons\" data-buttons=\"{0}\"></span><a "
        "href=\"figures/{0}.csv\">{0}.csv</a></div>\n",
        id
    );
    const std::size_t rows = figure.table.rows();
    out += fmt::format(
        "<details class=\"numbers-of\"><summary>Numbers ({}{})</summary>\n",
        rows > most_rows_shown ? "the first " + std::to_string(most_rows_shown) + " of " : "",
        rows == 1 ? "1 row" : grouped(static_cast<long long>(rows)) + " rows"
    );
    out += html_table(figure.table, most_rows_shown);
    if (!report.redraw.empty()) {
        out += "<p class=\"quiet\">Redraw: <code>" + escaped(report.redraw) + "</code></p>\n";
    }
    return out + "</details>\n</div>\n</figure>\n";
}

std::string section_tables(const ReportData& report, const std::string& name) {
    std::string out;
    for (const figures::PageTable& table : report.tables) {
        if (table.section == name) {
            out += "<h3>" + escaped(table.title) + "</h3>\n";
            out += table.note.empty() ? "" : "<p>" + typeset(table.note) + "</p>\n";
            out += html_table(table.header, table.rows, table.numeric, "page-table");
        }
    }
    return out;
}

/// Keys of provenance.json that say little to a reader, in words.
std::string in_words(const std::string& key) {
    if (key == "case_hash") {
        return "hash of the case";
    }
    return key == "wall_seconds" ? "wall time of all calls" : key;
}

std::string provenance_section(const ReportData& report, const std::optional<PageScript>& script) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& [key, value] : report.provenance) {
        const bool is_time = key == "wall_seconds";
        rows.push_back({in_words(key), is_time ? short_number(std::atof(value.c_str()), 4) + " s" : value});
    }
    std::sort(rows.begin(), rows.end());
    std::string out = html_table({"what", "value"}, rows, {}, "provenance");
    out +=
        "<h3>How to cite</h3>\n<p>" +
        typeset(fmt::format(
            "The program: suffuse {}, commit {}; CITATION.cff in its source holds the entry.{}{}", report.cited.version,
            report.cited.commit, report.cited.names_run ? " Seed and hash of the case identify the run." : "",
            report.paper.empty() ? "" : " The work that it follows: " + report.paper + "."
        )) +
        "</p>\n";
    if (script && !script->notices.empty()) {
        out += "<details><summary>Notices of the software in this page</summary><pre>" + escaped(script->notices) +
               "</pre></details>\n";
    }
    return section("Provenance", out);
}

/// Specification and numbers of each chart, for the page's script.
json charts_json(const ReportData& report) {
    json figures = json::array();
    for (const figures::Figure& figure : report.figures) {
        figures.push_back(
            {{"id", figure.id},
             {"title", figure.title},
             {"caption", figure.caption},
             {"chart", figure.drawing.empty() && figure.flat.empty() ? figure.chart : json(nullptr)},
             {"csv", figures::to_csv(figure.table, csv_remarks(figure, report))}}
        );
    }
    return {{"run", report.run}, {"look", figures::look_in_print()}, {"figures", std::move(figures)}};
}

/// Data for the page's script, packed.
std::string data_element(const char* id, const json& data) {
    const std::string text = data.dump(-1, ' ', false, json::error_handler_t::replace);
    return fmt::format("<script type=\"text/plain\" id=\"{}\">{}</script>\n", id, packed(text));
}

std::string head(const ReportData& report, const std::optional<PageScript>& script) {
    const std::string scripts = script ? "script-src 'sha256-" + script->sha256 + "'; " : "";
    return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; " +
           scripts +
           "style-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; form-action 'none'\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<meta name=\"color-scheme\" content=\"light dark\">\n"
           "<link rel=\"icon\" href=\"data:,\">\n<title>" +
           escaped(report.title) + "</title>\n<style>" + std::string(page_style()) + "</style>\n</head>\n";
}

const char* const plain_sentence = "<p class=\"missing\" role=\"note\">This report is plain: all numbers and verdicts "
                                   "are here, the charts are not, because "
                                   "the script that draws them was not built. To have it, install Node (18 or newer) "
                                   "and npm, let npm reach its registry, "
                                   "and call <code>./run</code> once more; each figure's chart is also in "
                                   "<code>figures/*.vl.json</code> for any Vega-Lite "
                                   "viewer.</p>\n";

// Shown after some seconds unless the script, which runs at once where it may, has taken it away.
const char* const no_script_sentence =
    "<p class=\"missing late\" id=\"no-script\" role=\"note\">The charts need JavaScript, which did not run here. All "
    "numbers are in the tables: open “Numbers” below each figure.</p>\n";

std::string render(const ReportData& report, const std::optional<PageScript>& script) {
    std::string sections = section("Answer", answer_content(report)), links = "<a href=\"#answer\">Answer</a>\n";
    for (const char* name : figure_sections) {
        const std::string tables = section_tables(report, name);
        std::string figures;
        for (const figures::Figure& figure : report.figures) {
            if (figure.section == name) {
                figures += figure_block(figure, report);
            }
        }
        if (figures.empty() && tables.empty()) {
            continue;
        }
        sections += section(name, tables + "<div class=\"figures\">\n" + figures + "</div>\n");
        links += fmt::format("<a href=\"#{}\">{}</a>\n", anchor(name), name);
    }
    if (!report.scene.states.empty()) {
        sections += section("In 3D", scene_section(report.scene, script.has_value()));
        links += "<a href=\"#in-3d\">In 3D</a>\n";
    }
    if (!report.stages.empty() || !report.case_warnings.empty()) {
        const std::string of_case = report.case_warnings.empty() ? ""
                                                                 : "<h3>What the check of the case warns of</h3>\n" +
                                                                       html_list(report.case_warnings, "plain");
        sections += section("Quality", of_case + (report.stages.empty() ? "" : quality_section(report.stages)));
        links += "<a href=\"#quality\">Quality</a>\n";
    }
    sections += provenance_section(report, script);
    links += "<a href=\"#provenance\">Provenance</a>\n";
    std::string page = head(report, script);
    page +=
        "<body>\n<a class=\"skip\" href=\"#answer\">Skip to the answer</a>\n<header>\n<p class=\"quiet\">suffuse · " +
        escaped(report.run) + "</p>\n<h1>" + escaped(report.title) + "</h1>\n<nav aria-label=\"Sections\">\n" + links +
        "</nav>\n</header>\n<main>\n" + unfinished_banner(report.unfinished) +
        (script ? no_script_sentence : plain_sentence) + sections + "</main>\n";
    if (script) {
        page += data_element("report-data", charts_json(report));
        if (!report.scene.states.empty()) {
            page += data_element("scene-data", scene_json(report.scene));
        }
        page += "<script>" + script->code + "</script>\n";
    }
    return page + "</body>\n</html>\n";
}

void check_figures(const ReportData& report) {
    for (const figures::Figure& figure : report.figures) {
        const bool plain = std::all_of(figure.id.begin(), figure.id.end(), [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
        });
        expects(plain && !figure.id.empty(), "a figure's id is made of a-z, 0-9 and '-'");
        expects(
            std::find(figure_sections.begin(), figure_sections.end(), figure.section) != figure_sections.end(),
            "a figure belongs to one of the report's sections"
        );
    }
}

} // namespace

WrittenReport write_report(
    const std::filesystem::path& run_folder, const ReportData& report, const std::filesystem::path& page_folder
) {
    check_figures(report);
    const std::filesystem::path figures = run_folder / "figures";
    std::error_code failure;
    std::filesystem::create_directories(figures, failure);
    if (failure) {
        throw IoError("cannot make the folder " + figures.string() + ": " + failure.message());
    }
    WrittenReport written;
    const auto write = [&](const std::string& name, std::string_view bytes) {
        io::write_file(figures / name, bytes);
        written.figures.push_back(name);
    };
    for (const figures::Figure& figure : report.figures) {
        write(figure.id + ".csv", figures::to_csv(figure.table, csv_remarks(figure, report)));
        if (figure.drawing.empty()) {
            const json chart = figures::complete_specification(figure);
            write(figure.id + ".vl.json", chart.dump(1, ' ', false, json::error_handler_t::replace) + "\n");
        } else {
            write(figure.id + ".svg", with_metadata(figure, report));
        }
    }
    for (const std::size_t k : still_states(report.scene)) {
        write(fmt::format("own-grains-{}.png", k), still_picture(report.scene, report.scene.states[k]));
    }
    const std::optional<PageScript> script = read_page_script(page_folder);
    written.file = run_folder / "report.html";
    written.has_charts = script.has_value();
    io::write_file(written.file, render(report, script));
    return written;
}

} // namespace suffuse::report
