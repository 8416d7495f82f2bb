#include "suffuse/report/provenance_section.hpp"

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/report/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace suffuse::report {

namespace {

/// Keys of provenance.json that say little to a reader, in words.
std::string in_words(const std::string& key) {
    if (key == "case_hash") {
        return "hash of the case";
    }
    return key == "wall_seconds" ? "wall time of all calls" : key;
}

std::string calls_table(const std::vector<Call>& calls, Numbering& numbering) {
    std::vector<std::vector<std::string>> rows;
    for (const Call& call : calls) {
        rows.push_back({call.command, call.finished, duration_text(call.seconds), call.program});
    }
    return html_table(
        {"call", "ended", "took", "program"}, rows, {false, false, true, false}, "calls",
        fmt::format("<b>{} The calls that made this run, oldest first.</b>", numbering.next_table())
    );
}

std::string text_of(const std::string& key, const std::string& value) {
    return key == "wall_seconds" ? duration_text(std::atof(value.c_str())) : value;
}

/// The value of a key of the provenance; empty where there is none.
std::string find(const ReportData& report, const char* key) {
    const auto found =
        std::ranges::find(report.provenance, key, [](const auto& entry) -> const std::string& { return entry.first; });
    return found == report.provenance.end() ? "" : found->second;
}

/// Text within quotation marks of CSS, inside a style element.
std::string in_css(const std::string& text) {
    std::string out;
    for (const char letter : text) {
        const bool ends = letter == '"' || letter == '\\' || letter == '<' || letter == '\n' || letter == '\r';
        out += ends ? fmt::format("\\{:x} ", static_cast<unsigned char>(letter)) : std::string(1, letter);
    }
    return out;
}

std::string program_of(const ReportData& report) {
    return fmt::format("suffuse {} · {}", report.cited.version, report.cited.commit);
}

} // namespace

std::string provenance_content(const ReportData& report, const std::string& notices, Numbering& numbering) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& [key, value] : report.provenance) {
        rows.push_back({in_words(key), text_of(key, value)});
    }
    std::sort(rows.begin(), rows.end());
    std::string out = report.calls.empty() ? "" : calls_table(report.calls, numbering);
    out += html_table(
        {"what", "value"}, rows, {}, "provenance",
        fmt::format("<b>{} Program, machine and case.</b>", numbering.next_table())
    );
    out +=
        "<h3>How to cite</h3>\n<p>" +
        typeset(fmt::format(
            "The program: suffuse {}, commit {}; CITATION.cff in its source holds the entry.{}{}", report.cited.version,
            report.cited.commit, report.cited.names_run ? " Seed and hash of the case identify the run." : "",
            report.paper.empty() ? "" : " The work that it follows: " + report.paper + "."
        )) +
        "</p>\n";
    if (!notices.empty()) {
        out += "<details class=\"scr\"><summary>Notices of the software in this page</summary><pre>" +
               escaped(notices) + "</pre></details>\n";
    }
    return out;
}

std::string run_and_day(const ReportData& report) {
    constexpr std::size_t day = 10; // characters of "2026-11-26T12:00:00Z"
    const std::string finished = find(report, "finished");
    return report.run + (finished.size() < day ? "" : " · " + finished.substr(0, day));
}

std::string print_cover(const ReportData& report, const std::vector<std::pair<std::string, std::string>>& sections) {
    std::string verdict, facts, contents;
    for (const std::string& line : report.opening.verdict) {
        verdict += typeset(line) + " ";
    }
    std::string caution;
    for (const std::string& text : report.opening.disagreement) {
        caution += typeset(text) + " ";
    }
    for (const std::string& text : report.opening.doubts) {
        caution += typeset(text) + " ";
    }
    if (!report.unfinished.missing.empty()) {
        caution += "This run is not complete: " + typeset(report.unfinished.missing) + ".";
    }
    const auto add = [&](const char* what, const std::string& value) {
        facts += value.empty() ? "" : fmt::format("<dt>{}</dt><dd>{}</dd>", what, escaped(value));
    };
    const std::string hash = find(report, "case_hash"), seed = find(report, "seed");
    add("Project", report.project);
    add("Author", report.author);
    add("Specified", report.request);
    add("Date", find(report, "finished"));
    add("Program", fmt::format("suffuse {}, commit {}", report.cited.version, report.cited.commit));
    add("Case", hash.empty() ? "" : fmt::format("{}{}", hash, seed.empty() ? "" : ", seed " + seed));
    add("Run", report.run);
    for (const auto& [anchor, name] : sections) {
        contents += fmt::format("<li><a href=\"#{}\">{}</a></li>", anchor, escaped(name));
    }
    return fmt::format(
        "<div class=\"cover\"><div class=\"k\">Report of a run of suffuse</div>\n<div class=\"big\">{}</div>\n"
        "<div class=\"sub\">{}{}</div>\n{}<dl>{}</dl>\n<div class=\"toc\"><div "
        "class=\"k\">Contents</div><ol>{}</ol></div>"
        "</div>\n",
        escaped(report.title), verdict,
        report.opening.confidence.empty() ? "" : typeset(report.opening.confidence) + ".",
        caution.empty() ? "" : "<div class=\"sub\"><b>But:</b> " + caution + "</div>\n", facts, contents
    );
}

std::string print_margins(const ReportData& report) {
    return fmt::format(
        "@page {{ @top-left {{ content: \"{}\"; font: 8.5pt sans-serif; color: #555; }} @top-right {{ content: \"{}\"; "
        "font: 8.5pt sans-serif; color: #555; }} @bottom-right {{ content: \"page \" counter(page) \" of \" "
        "counter(pages); font: 8.5pt sans-serif; color: #555; }} }}\n@page :first {{ @top-left {{ content: \"\"; }} "
        "@top-right {{ content: \"\"; }} @bottom-right {{ content: \"\"; }} }}\n",
        in_css(report.title), in_css(program_of(report))
    );
}

} // namespace suffuse::report
