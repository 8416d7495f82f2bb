#include "suffuse/report/live_page.hpp"

#include "suffuse/report/html.hpp"
#include "suffuse/report/page.hpp"
#include "suffuse/report/style.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::report {

namespace {

constexpr const char* look = R"css(
progress { width: 100%; max-width: 44rem; height: 1rem; accent-color: var(--accent); display: block; margin: .8rem 0 .3rem; }
td.status { white-space: nowrap; }
tr.running td, tr.running th { background: var(--panel); font-weight: 600; }
tr.waits td, tr.waits th { color: var(--soft); }
)css";

std::string row_of(const LiveRow& row) {
    return fmt::format(
        "<tr class=\"{}\"><th scope=\"row\">{}</th><td>{}</td><td "
        "class=\"status\">{}</td><td>{}</td><td>{}</td></tr>\n",
        escaped(row.status), escaped(row.stage), escaped(row.verb), escaped(row.status), escaped(row.time),
        typeset(row.state)
    );
}

std::string ending_of(const LivePage& page) {
    std::string out = "<div class=\"warnings\" role=\"note\"><p>" + escaped(page.ending) + "</p>\n";
    if (!page.command.empty()) {
        out += "<p>Continue with <code>" + escaped(page.command) + "</code></p>\n";
    }
    return out + "</div>\n";
}

/// A run that was killed says no goodbye, and its page goes on loading itself.
std::string if_killed(const std::string& command) {
    return command.empty() ? ""
                           : " If that time does not change for minutes, the run was killed; continue it with <code>" +
                                 escaped(command) + "</code>.";
}

} // namespace

std::string render_live_page(const LivePage& page) {
    const bool is_live = page.ending.empty();
    std::string out =
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; img-src "
        "data:\">\n";
    if (is_live) {
        out += fmt::format("<meta http-equiv=\"refresh\" content=\"{}\">\n", page.refresh_seconds);
    }
    out += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<meta name=\"color-scheme\" "
           "content=\"light dark\">\n<link rel=\"icon\" href=\"data:,\">\n";
    out += fmt::format("<title>{}{}</title>\n", is_live ? "… " : "", escaped(page.title));
    out += fmt::format("<style>{}{}</style>\n</head>\n<body>\n", page_style(), look);
    out += fmt::format(
        "<header>\n<p class=\"quiet\">suffuse · {}</p>\n<h1>{}</h1>\n</header>\n<main>\n", escaped(page.run),
        escaped(page.title)
    );
    out += fmt::format(
        "<progress value=\"{:.4f}\" max=\"1\" aria-label=\"share of the stages that are done\"></progress>\n<p "
        "class=\"answer\">{}{}</p>\n",
        std::clamp(page.share, 0.0, 1.0), escaped(page.progress),
        is_live && !page.left.empty() ? ", " + escaped(page.left) + " left" : ""
    );
    out += is_live ? fmt::format(
                         "<p class=\"quiet\">As of {}. This page reloads every {} s and becomes the report when the "
                         "run ends.{}</p>\n",
                         escaped(page.at), page.refresh_seconds, if_killed(page.command)
                     )
                   : ending_of(page) + "<p class=\"quiet\">As of " + escaped(page.at) + ".</p>\n";
    out += "<div class=\"scroll\"><table class=\"page-table\"><thead><tr><th>stage</th><th>verb</th><th>status</th>"
           "<th>time</th><th>state</th></tr></thead><tbody>\n";
    for (const LiveRow& row : page.rows) {
        out += row_of(row);
    }
    return out + "</tbody></table></div>\n</main>\n</body>\n</html>\n";
}

} // namespace suffuse::report
