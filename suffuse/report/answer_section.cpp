#include "suffuse/report/answer_section.hpp"

#include "suffuse/base/base64.hpp"
#include "suffuse/base/grouped.hpp"
#include "suffuse/report/figure_block.hpp"
#include "suffuse/report/html.hpp"
#include "suffuse/report/scene_section.hpp"
#include "suffuse/report/still.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace suffuse::report {

namespace {

using answer::Headline;

std::string verdict_lines(const std::vector<std::string>& lines) {
    std::string out = "<p class=\"verdict\">";
    for (const std::string& line : lines) {
        out += "<span>" + typeset(line) + "</span> ";
    }
    return out + "</p>\n";
}

std::string small(const std::string& text) {
    return text.empty() ? "" : "<small>" + typeset(text) + "</small>";
}

std::string card(const Headline& headline, bool is_first) {
    const std::string lead = headline.lead.empty() ? "" : small(headline.lead) + " ";
    const std::string spread = headline.spread.empty() ? "" : " " + small(headline.spread);
    const bool is_long = headline.value.size() + headline.spread.size() + headline.lead.size() > 16;
    std::string out = fmt::format(
        "<div class=\"item{}{}\"><dt class=\"l\">{}</dt><dd class=\"v\">{}{}{}</dd><dd class=\"u\">{}</dd>",
        is_first ? " key" : "", is_long ? " long" : "", typeset(headline.label), lead, typeset(headline.value), spread,
        typeset(headline.detail)
    );
    if (!headline.caution.empty()) {
        out += "<dd class=\"w\">▲ " + typeset(headline.caution) + "</dd>";
    }
    return out + "</div>\n";
}

std::string cards(const std::vector<Headline>& headlines) {
    if (headlines.empty()) {
        return "";
    }
    std::string out = fmt::format("<dl class=\"cards of{}\">\n", headlines.size());
    for (std::size_t k = 0; k < headlines.size(); ++k) {
        out += card(headlines[k], k == 0);
    }
    return out + "</dl>\n";
}

/// The sample as it was and as it is, side by side.
std::string grains_figure(const Scene& scene, Numbering& numbering) {
    std::vector<std::size_t> shown = still_states(scene);
    if (shown.size() == 2 &&
        count_scene(scene, scene.states[shown[0]]).grains == count_scene(scene, scene.states[shown[1]]).grains) {
        shown.erase(shown.begin()); // none has left: one picture says all
    }
    std::string pictures;
    std::vector<std::string> labels;
    for (const std::size_t k : shown) {
        const SceneState& state = scene.states[k];
        const std::string count = grouped(count_scene(scene, state).grains);
        pictures += fmt::format(
            "<div><img alt=\"{0} grains in their cell, {1}; fines in red, coarse grains in sand\" width=\"450\" "
            "height=\"450\" src=\"data:image/png;base64,{2}\"><p>{1}: <b>{0} grains</b></p></div>\n",
            count, escaped(state.label), base64(still_picture(scene, state))
        );
        labels.push_back(state.label);
    }
    return fmt::format(
        "<figure class=\"figure grains\"><h3>{}</h3>\n<div class=\"pair\">{}</div>\n<figcaption><b>{}</b> "
        "Fines in red, coarse grains in sand, to one scale. <span class=\"scr\">To turn it: <a href=\"#in-3d\">In "
        "3D</a>.</span></figcaption></figure>\n",
        typeset(labels.size() < 2 ? "The sample" : fmt::format("The sample, {}", fmt::join(labels, " and "))), pictures,
        numbering.next_figure()
    );
}

/// The deciding picture and the one next to it.
std::string pictures_of(const ReportData& report, Numbering& numbering) {
    std::vector<std::string> cells;
    if (shows_grains(report)) {
        cells.push_back(grains_figure(report.scene, numbering));
    }
    for (const figures::Figure* figure : opening_figures(report)) {
        cells.push_back(figure_block(*figure, report, numbering));
    }
    if (cells.empty()) {
        return "";
    }
    std::string out = "<div class=\"g\">\n";
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const char* const width = cells.size() == 1 ? "c12" : cells.size() == 3 ? "c4" : k == 0 ? "c8" : "c4";
        out += fmt::format("<div class=\"{}\">\n{}</div>\n", width, cells[k]);
    }
    return out + "</div>\n";
}

std::string fold(const std::string& title, const std::string& about, const std::string& content) {
    return fmt::format(
        "<details class=\"fold\"><summary>{} <span>{}</span></summary>\n<div>{}</div></details>\n", title, about,
        content
    );
}

std::string in_full(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& line : sentences) {
        text += "<p>" + typeset(line) + "</p>\n";
    }
    return fold(
        "In full", fmt::format("The answer in {} sentence{}", sentences.size(), sentences.size() == 1 ? "" : "s"), text
    );
}

std::string assumed_fold(const ReportData& report, Numbering& numbering) {
    std::vector<std::vector<std::string>> rows;
    for (const AssumedValue& value : report.assumed) {
        rows.push_back({value.key, value.value, value.note});
    }
    const std::string many =
        fmt::format("{} {}", report.assumed.size(), report.assumed.size() == 1 ? "value" : "values");
    const std::string whose =
        report.paper.empty() ? "that the case marks as assumed" : "that the paper does not give: our choice";
    return fold(
        "What was assumed", many + " " + whose,
        html_table(
            {"key", "value", "remark"}, rows, {}, "assumed",
            fmt::format("<b>{} Values {}.</b>", numbering.next_table(), whose)
        )
    );
}

std::string warnings_fold(const ReportData& report) {
    std::string content = report.warnings.empty() ? "" : html_list(report.warnings, "plain");
    if (!report.case_warnings.empty()) {
        content += fmt::format(
            "<p>The check of the case warned of {} before the run: <a href=\"#quality\">Quality</a>.</p>\n",
            report.case_warnings.size() == 1 ? "1 thing" : fmt::format("{} things", report.case_warnings.size())
        );
    }
    const std::size_t all = report.warnings.size() + (report.case_warnings.empty() ? 0 : 1);
    return content.empty() ? "" : fold(fmt::format("▲ Warnings: {}", all), "of stages, and of the case", content);
}

/// What the verdict rests on, and its largest doubts.
std::string basis(const answer::Opening& opening) {
    std::string out = opening.estimates.empty() ? "" : fmt::format("<p>{}</p>\n", typeset(opening.estimates));
    if (!opening.doubts.empty()) {
        out += "<ul class=\"doubts\">";
        for (const std::string& doubt : opening.doubts) {
            out += fmt::format("<li>{}</li>", typeset(doubt));
        }
        out += "</ul>\n";
    }
    return out;
}

std::string note(const char* title, const std::string& text) {
    return fmt::format("<p class=\"note\" role=\"note\">▲ <b>{}</b> {}</p>\n", title, typeset(text));
}

} // namespace

bool shows_grains(const ReportData& report) {
    return report.opening.shows_grains && !report.scene.states.empty();
}

std::vector<const figures::Figure*> opening_figures(const ReportData& report) {
    const std::size_t most = shows_grains(report) ? 1 : 2;
    std::vector<const figures::Figure*> shown;
    for (const std::string& id : report.opening.pictures) {
        const auto found = std::ranges::find(report.figures, id, &figures::Figure::id);
        if (found != report.figures.end() && shown.size() < most) {
            shown.push_back(&*found);
        }
    }
    return shown;
}

std::string answer_content(const ReportData& report, Numbering& numbering) {
    std::string out = verdict_lines(report.opening.verdict);
    if (!report.opening.confidence.empty()) {
        out += fmt::format(
            "<p class=\"conf\"><b>{}</b> <span>{}</span></p>\n", typeset(report.opening.confidence),
            typeset(report.opening.about_confidence)
        );
    }
    out += basis(report.opening);
    for (const std::string& flaw : report.flaws) {
        out += note("Flaw.", flaw);
    }
    out += cards(report.opening.cards) + pictures_of(report, numbering);
    for (const std::string& text : report.opening.disagreement) {
        out += note("Two answers disagree.", text);
    }
    out += report.answer.empty() ? "" : in_full(report.answer);
    out += report.assumed.empty() ? "" : assumed_fold(report, numbering);
    return out + warnings_fold(report);
}

std::string unfinished_banner(const Unfinished& unfinished) {
    return unfinished.missing.empty() ? ""
                                      : fmt::format(
                                            "<div class=\"warnings\" id=\"unfinished\" role=\"note\"><p><b>This run is "
                                            "not complete.</b> {}.</p>\n<p>Continue with <code>{}</code></p></div>\n",
                                            typeset(unfinished.missing), escaped(unfinished.command)
                                        );
}

} // namespace suffuse::report
