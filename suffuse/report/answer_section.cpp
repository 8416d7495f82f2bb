#include "suffuse/report/answer_section.hpp"

#include "suffuse/report/html.hpp"
#include "suffuse/study/finding_guide.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace suffuse::report {

namespace {

/// Colour never speaks alone: the sign says the same.
struct Mark {
    const char* css_class;
    const char* sign;
};

Mark mark_of(study::Standing standing) {
    switch (standing) {
    case study::Standing::Met:
        return {"met", "✓"};
    case study::Standing::MetByNoise:
        return {"by-number", "✓"};
    case study::Standing::NotMet:
        return {"not-met", "✗"};
    case study::Standing::NotMetByOurNumber:
        return {"by-number", "✗"};
    case study::Standing::SeedsDisagree:
    case study::Standing::CannotTell:
        break;
    }
    return {"unknown", "?"};
}

/// The criterion with the numbers that are ours marked in it.
std::string criterion(const study::Finding& finding) {
    std::string html = typeset(finding.claim);
    std::size_t from = 0;
    for (const std::string& number : finding.our_numbers) {
        const std::string text = typeset(number);
        if (const std::size_t at = html.find(text, from); at != std::string::npos) {
            const std::string marked = "<span class=\"our-number\">" + text + "</span>";
            html.replace(at, text.size(), marked);
            from = at + marked.size();
        }
    }
    return html;
}

std::string findings_table(const std::vector<study::Finding>& findings) {
    std::string out = "<div class=\"scroll\" tabindex=\"0\"><table class=\"findings\"><thead><tr><th></th><th>The paper"
                      "</th><th>Our criterion</th><th>This run</th><th>Verdict</th><th>Why</th></tr></thead><tbody>\n";
    for (std::size_t k = 0; k < findings.size(); ++k) {
        const study::Finding& finding = findings[k];
        const std::string why = study::why_in_row(findings, k);
        const study::Standing standing = study::standing_of(finding);
        const Mark mark = mark_of(standing);
        out += fmt::format(
            "<tr><th scope=\"row\">{}</th><td>{}</td><td data-label=\"Criterion\">{}</td><td data-label=\"This "
            "run\">{}</td><td class=\"verdict {}\">{} {}</td>",
            escaped(finding.id), typeset(finding.paper), criterion(finding), typeset(finding.ours), mark.css_class,
            mark.sign, study::name_of(standing)
        );
        out += why.empty() ? "<td></td></tr>\n" : "<td data-label=\"Why\">" + typeset(why) + "</td></tr>\n";
    }
    return out +
           "</tbody></table></div>\n<p class=\"quiet\">Numbers <span class=\"our-number\">marked</span> in a criterion "
           "are ours: the paper gives words there. <b>Not met by our number</b>: the words hold, the number does "
           "not.</p>\n";
}

/// What decides the findings that are not plainly met; those of one explanation together.
std::string explanations(const std::vector<study::Finding>& findings) {
    std::vector<std::pair<std::string, std::string_view>> told; // ids, text
    for (const study::Finding& finding : findings) {
        const std::string_view text = study::background_of(finding.id);
        if (study::standing_of(finding) == study::Standing::Met || text.empty()) {
            continue;
        }
        const auto same = std::ranges::find(told, text, &std::pair<std::string, std::string_view>::second);
        if (same == told.end()) {
            told.emplace_back(finding.id, text);
        } else {
            same->first += ", " + finding.id;
        }
    }
    std::string out;
    for (const auto& [ids, text] : told) {
        out += fmt::format("<p><b>{}.</b> {}</p>\n", ids, typeset(std::string(text)));
    }
    return out.empty() ? out
                       : "<details><summary>What decides the findings that are not plainly met</summary>\n" + out +
                             "</details>\n";
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
        out += fmt::format("<h3>The paper's findings: {}</h3>\n", study::count_standings(report.findings));
        out += findings_table(report.findings) + explanations(report.findings);
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
