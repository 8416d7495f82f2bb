#include "suffuse/report/answer_section.hpp"

#include "suffuse/report/html.hpp"

#include <fmt/format.h>

namespace suffuse::report {

namespace {

std::string findings_table(const std::vector<study::Finding>& findings) {
    std::string out =
        "<div class=\"scroll\" tabindex=\"0\"><table class=\"findings\"><thead><tr><th></th><th>Criterion</th>"
        "<th>Paper</th><th>This run</th><th>Verdict</th></tr></thead><tbody>\n";
    for (const study::Finding& finding : findings) {
        const bool known = finding.met.has_value();
        const char* css_class = !known ? "unknown" : *finding.met ? "met" : "not-met";
        const char* verdict = !known ? "? cannot tell" : *finding.met ? "✓ met" : "✗ not met";
        out += fmt::format(
            "<tr><th scope=\"row\">{}</th><td>{}</td><td data-label=\"Paper\">{}</td><td data-label=\"This "
            "run\">{}</td>"
            "<td class=\"verdict {}\">{}</td></tr>\n",
            escaped(finding.id), typeset(finding.claim), typeset(finding.paper), typeset(finding.ours), css_class,
            verdict
        );
    }
    return out + "</tbody></table></div>\n";
}

std::string headline_list(const std::vector<answer::Headline>& headlines) {
    std::string out = "<dl class=\"headlines\">\n";
    for (const answer::Headline& headline : headlines) {
        out += fmt::format(
            "<div><dt>{}</dt><dd class=\"value\">{}</dd><dd class=\"quiet\">{}</dd></div>\n", typeset(headline.label),
            typeset(headline.value), typeset(headline.detail)
        );
    }
    return out + "</dl>\n";
}

std::string warnings_box(const ReportData& report) {
    if (report.warnings.empty() && report.case_warnings.empty()) {
        return "";
    }
    std::string out = "<div class=\"warnings\" role=\"note\"><h3>Warnings</h3>\n";
    if (!report.warnings.empty()) {
        out += html_list(report.warnings, "plain");
    }
    if (!report.case_warnings.empty()) {
        out += fmt::format(
            "<p>The check of the case warned of {} before the run: <a href=\"#quality\">Quality</a>.</p>\n",
            report.case_warnings.size() == 1 ? "1 thing" : fmt::format("{} things", report.case_warnings.size())
        );
    }
    return out + "</div>\n";
}

} // namespace

std::string answer_content(const ReportData& report) {
    std::string out = "<div class=\"opening\">\n<div>\n";
    for (const std::string& line : report.answer) {
        out += "<p class=\"answer\">" + typeset(line) + "</p>\n";
    }
    if (report.answer.empty()) {
        out += "<p class=\"answer\">In what was run there is no erosion, removal or test to sum up; its numbers are in "
               "the "
               "sections below.</p>\n";
    }
    out += "</div>\n" + (report.headlines.empty() ? "" : headline_list(report.headlines)) + "</div>\n";
    out += warnings_box(report);
    if (!report.findings.empty()) {
        std::size_t met = 0, unknown = 0;
        for (const study::Finding& finding : report.findings) {
            met += finding.met == true ? 1U : 0U;
            unknown += finding.met ? 0U : 1U;
        }
        out += fmt::format(
            "<h3>The paper's findings: {} of {} met{}</h3>\n", met, report.findings.size(),
            unknown > 0 ? fmt::format(", {} cannot be told from this run", unknown) : ""
        );
        out += findings_table(report.findings);
    }
    if (!report.assumed.empty()) {
        std::vector<std::vector<std::string>> rows;
        for (const AssumedValue& value : report.assumed) {
            rows.push_back({value.key, value.value, value.note});
        }
        out += fmt::format(
            "<details><summary>{} {}</summary>\n",
            report.assumed.size() == 1 ? "1 value" : fmt::format("{} values", report.assumed.size()),
            report.paper.empty() ? "that the case marks as assumed" : "that the paper does not give: our choice"
        );
        out += html_table({"key", "value", "remark"}, rows, {}, "assumed") + "</details>\n";
    }
    return out;
}

std::string unfinished_banner(const Unfinished& unfinished) {
    return unfinished.missing.empty()
               ? ""
               : fmt::format(
                     "<div class=\"warnings\" id=\"unfinished\" role=\"note\"><p><b>This run is not complete.</b> "
                     "{}.</p>\n<p>Go on with <code>{}</code></p></div>\n",
                     typeset(unfinished.missing), escaped(unfinished.command)
                 );
}

} // namespace suffuse::report
