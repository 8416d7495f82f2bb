#include "suffuse/report/findings_section.hpp"

#include "suffuse/base/words.hpp"
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
        return {"by-number", "?"};
    case study::Standing::NotMet:
        return {"not-met", "✗"};
    case study::Standing::NotMetByOurNumber:
        return {"by-number", "✗"};
    case study::Standing::SeedsDisagree:
    case study::Standing::Undecided:
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

std::string findings_table(const std::vector<study::Finding>& findings, Numbering& numbering) {
    std::string out = fmt::format(
        "<div class=\"scroll\" tabindex=\"0\"><table class=\"findings\"><caption><b>{}</b> The paper's words, our "
        "criterion (numbers of ours in <span class=\"our-number\">this colour</span>), this run.</caption><thead><tr>"
        "<th></th><th>The paper</th><th>Our criterion</th><th>This run</th><th>Verdict</th><th>Why</th></tr></thead>"
        "<tbody>\n",
        numbering.next_table()
    );
    for (std::size_t k = 0; k < findings.size(); ++k) {
        const study::Finding& finding = findings[k];
        const std::string why = study::reason_in_table(findings, k);
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
    return out + "</tbody></table></div>\n";
}

/// What decides the findings that are not plainly met; those of one explanation together.
std::string explanations(const std::vector<study::Finding>& findings) {
    std::vector<std::pair<std::string, std::string_view>> listed; // ids, text
    for (const study::Finding& finding : findings) {
        const std::string_view text = study::background_of(finding.id);
        if (study::standing_of(finding) == study::Standing::Met || text.empty()) {
            continue;
        }
        const auto same = std::ranges::find(listed, text, &std::pair<std::string, std::string_view>::second);
        if (same == listed.end()) {
            listed.emplace_back(finding.id, text);
        } else {
            same->first += ", " + finding.id;
        }
    }
    std::string out;
    for (const auto& [ids, text] : listed) {
        out += fmt::format("<p><b>{}.</b> {}</p>\n", ids, typeset(std::string(text)));
    }
    return out.empty() ? out
                       : "<details class=\"fold\"><summary>What decides the findings that are not plainly "
                         "met</summary>\n<div>" +
                             out + "</div></details>\n";
}

/// What the standings say together: whose numbers the unmet ones fail by.
std::string summed_up(const std::vector<study::Finding>& findings) {
    const auto count = [&](study::Standing standing) {
        return std::ranges::count_if(findings, [&](const study::Finding& finding) {
            return study::standing_of(finding) == standing;
        });
    };
    using enum study::Standing;
    std::string text = as_sentence(study::count_standings(findings)) + ".";
    if (count(MetByNoise) > 0) {
        text += " Met by noise: the residual unbalanced forces meet the criterion, so it does not show an effect of "
                "the water and is not counted.";
    }
    if (const auto ours = count(NotMetByOurNumber); ours > 0) {
        text += fmt::format(
            " Not met by our number: the paper's words hold, our numerical threshold does not ({} of {} unmet).", ours,
            ours + count(NotMet)
        );
    }
    return text;
}

} // namespace

std::string findings_content(const std::vector<study::Finding>& findings, Numbering& numbering) {
    return "<p>" + typeset(summed_up(findings)) + "</p>\n" + findings_table(findings, numbering) +
           explanations(findings);
}

} // namespace suffuse::report
