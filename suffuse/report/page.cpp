#include "suffuse/report/page.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/folders.hpp"
#include "suffuse/report/answer_section.hpp"
#include "suffuse/report/figure_block.hpp"
#include "suffuse/report/findings_section.hpp"
#include "suffuse/report/html.hpp"
#include "suffuse/report/numbering.hpp"
#include "suffuse/report/packed.hpp"
#include "suffuse/report/provenance_section.hpp"
#include "suffuse/report/references.hpp"
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

const std::array<const char*, 9> figure_sections = {"Parameters", "Fit",   "Samples", "Soils",  "Fines and structure",
                                                    "Tests",      "Water", "Filter",  "Erosion"};

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

/// The sections of the page, and what leads to them.
class Sections {
public:
    void add(const std::string& name, const std::string& content) {
        html_ += fmt::format(
            "<section id=\"{0}\" aria-labelledby=\"{0}-heading\">\n<h2 id=\"{0}-heading\">{1}</h2>\n{2}</section>\n",
            anchor(name), escaped(name), content
        );
        names_.emplace_back(anchor(name), name);
    }

    /// The works that the sections name, resolved to a section of their own.
    void add_references() {
        CitedWorks cited = resolve_citations(std::move(html_), read_works(bibliography()));
        html_ = std::move(cited.html);
        if (!cited.works.empty()) {
            add("References", references_content(cited.works));
        }
    }

    [[nodiscard]] const std::string& html() const { return html_; }

    [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& names() const { return names_; }

private:
    std::string html_;
    std::vector<std::pair<std::string, std::string>> names_; ///< anchor, name
};

/// Tables and figures of one of the sections that a case may fill; empty where it has none.
std::string content_of(const std::string& name, const ReportData& report, Numbering& numbering) {
    const std::vector<const figures::Figure*> shown = opening_figures(report);
    std::string tables, figures, texts;
    for (const figures::PageTable& table : report.tables) {
        tables += table.section == name ? table_block(table, numbering) : "";
    }
    for (const figures::Figure& figure : report.figures) {
        const bool is_shown = std::ranges::count(shown, &figure) > 0;
        figures += figure.section == name && !is_shown ? figure_block(figure, report, numbering) : "";
    }
    for (const TextBlock& block : report.texts) {
        texts += block.section != name
                     ? ""
                     : fmt::format(
                           "<h3>{}</h3>\n<pre class=\"block\">{}</pre>\n", typeset(block.title), escaped(block.text)
                       );
    }
    return tables + (figures.empty() ? "" : "<div class=\"figures\">\n" + figures + "</div>\n") + texts;
}

/// Specification and numbers of each chart, for the page's script.
json charts_json(const ReportData& report) {
    json figures = json::array();
    for (const figures::Figure& figure : report.figures) {
        figures.push_back(
            {{"id", figure.id},
             {"title", figure.title},
             {"caption", figure.caption},
             {"chart", figure.drawing.empty() && figure.flat.empty() ? named_chart(figure) : json(nullptr)},
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
           escaped(report.title) + "</title>\n<style>" + std::string(page_style()) + print_margins(report) +
           "</style>\n</head>\n";
}

const char* const plain_sentence = "<p class=\"missing\" role=\"note\">This report is plain: all numbers and verdicts "
                                   "are here, the charts are not, because "
                                   "the script that draws them was not built. To have it, install Node (18 or newer) "
                                   "and npm, let npm reach its registry, "
                                   "and call <code>./run</code> once more; each figure's chart is also in "
                                   "<code>figures/*.vl.json</code> for any Vega-Lite "
                                   "viewer.</p>\n";

// Shown after some seconds unless the script, which runs at once where it may, has taken it away.
const char* const no_script_sentence = "<p class=\"missing late\" id=\"no-script\" role=\"note\">The charts are drawn "
                                       "by JavaScript. Where it does not run, all "
                                       "numbers are in the tables: open “Numbers” below each figure.</p>\n";

Sections sections_of(const ReportData& report, const std::optional<PageScript>& script) {
    Numbering numbering;
    Sections sections;
    sections.add("Answer", answer_content(report, numbering));
    for (const char* name : figure_sections) {
        if (const std::string content = content_of(name, report, numbering); !content.empty()) {
            sections.add(name, content);
        }
    }
    if (!report.scene.states.empty()) {
        sections.add("In 3D", scene_section(report.scene, script.has_value(), shows_grains(report), numbering));
    }
    if (!report.findings.empty()) {
        sections.add("Findings", findings_content(report.findings, numbering));
    }
    if (!report.stages.empty() || !report.case_warnings.empty()) {
        const std::string of_case = report.case_warnings.empty() ? ""
                                                                 : "<h3>Warnings from the check of the case</h3>\n" +
                                                                       html_list(report.case_warnings, "plain");
        sections.add("Quality", of_case + (report.stages.empty() ? "" : quality_section(report.stages, numbering)));
    }
    sections.add("Provenance", provenance_content(report, script ? script->notices : "", numbering));
    sections.add_references();
    return sections;
}

/// Whether some chart is not there before the script has drawn it.
bool needs_script(const ReportData& report) {
    return std::ranges::any_of(report.figures, [](const figures::Figure& figure) {
        return figure.drawing.empty() && figure.flat.empty() && figure.still.empty();
    });
}

std::string render(const ReportData& report, const std::optional<PageScript>& script) {
    const Sections sections = sections_of(report, script);
    std::string links;
    for (const auto& [anchor, name] : sections.names()) {
        links += fmt::format("<a href=\"#{}\">{}</a>\n", anchor, name);
    }
    std::string page = head(report, script);
    page += "<body>\n<a class=\"skip\" href=\"#answer\">Skip to the answer</a>\n" +
            print_cover(report, sections.names()) + "<header class=\"top\">\n<p class=\"kick\">suffuse · " +
            escaped(run_and_day(report)) + "</p>\n<h1>" + escaped(report.title) +
            "</h1>\n<nav aria-label=\"Sections\">\n" + links + "</nav>\n</header>\n<main>\n" +
            unfinished_banner(report.unfinished) +
            (!script                ? plain_sentence
             : needs_script(report) ? no_script_sentence
                                    : "") +
            sections.html() + "</main>\n";
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

std::vector<std::string> write_figures(const std::filesystem::path& run_folder, const ReportData& report) {
    check_figures(report);
    const std::filesystem::path figures = run_folder / "figures";
    io::make_folders(figures);
    std::vector<std::string> written;
    const auto write = [&](const std::string& name, std::string_view bytes) {
        io::write_file(figures / name, bytes);
        written.push_back(name);
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
    return written;
}

WrittenReport write_page(
    const std::filesystem::path& run_folder, const ReportData& report, const std::filesystem::path& page_folder
) {
    const std::optional<PageScript> script = read_page_script(page_folder);
    WrittenReport written;
    written.file = run_folder / "report.html";
    written.has_charts = script.has_value();
    io::write_file(written.file, render(report, script));
    return written;
}

std::string scene_page(const std::string& title, const Scene& scene, const std::filesystem::path& page_folder) {
    const std::optional<PageScript> script = read_page_script(page_folder);
    ReportData report;
    report.title = report.run = title;
    Numbering numbering;
    std::string page = head(report, script) + "<body>\n<main>\n<section>\n" +
                       scene_section(scene, script.has_value(), false, numbering) + "</section>\n</main>\n";
    if (script) {
        page += data_element("report-data", charts_json(report)) + data_element("scene-data", scene_json(scene)) +
                "<script>" + script->code + "</script>\n";
    }
    return page + "</body>\n</html>\n";
}

WrittenReport write_report(
    const std::filesystem::path& run_folder, const ReportData& report, const std::filesystem::path& page_folder
) {
    std::vector<std::string> figures = write_figures(run_folder, report);
    WrittenReport written = write_page(run_folder, report, page_folder);
    written.figures = std::move(figures);
    return written;
}

} // namespace suffuse::report
