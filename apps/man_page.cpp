#include "apps/man_page.hpp"

#include "suffuse/base/version.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/help.hpp"

namespace suffuse::apps {
namespace {

/// Text as it is: a backslash, a hyphen, and a dot or a quote at the start of a line mean something to roff.
std::string plain(std::string_view text) {
    std::string safe;
    bool at_start = true;
    for (const char c : text) {
        if (at_start && (c == '.' || c == '\'')) {
            safe += "\\&";
        }
        if (c == '\\') {
            safe += "\\e";
        } else if (c == '-') {
            safe += "\\-";
        } else {
            safe.push_back(c);
        }
        at_start = c == '\n';
    }
    return safe;
}

std::string flag_row(const FlagRow& flag, bool is_argument) {
    std::string names;
    for (const std::string& name : flag.names) {
        names += fmt::format("{}{}{}\\fR", names.empty() ? "" : ", ", is_argument ? "\\fI" : "\\fB", plain(name));
    }
    if (!is_argument && !flag.placeholder.empty()) {
        names += fmt::format(" \\fI{}\\fR", plain(flag.placeholder));
    }
    return fmt::format(".TP\n{}\n{}\n", names, plain(flag.text));
}

std::string verb_section(const VerbRow& verb) {
    std::string synopsis = fmt::format("\\fBsuffuse {}\\fR", plain(verb.path));
    for (const FlagRow& argument : verb.arguments) {
        synopsis += fmt::format(" \\fI{}\\fR", plain(argument.placeholder));
    }
    std::string text = fmt::format(".SS {}\n{}\n.PP\n{}.\n", synopsis, "", plain(verb.text));
    text.erase(text.find("\n\n") + 1, 1);
    for (const FlagRow& argument : verb.arguments) {
        text += flag_row(argument, true);
    }
    for (const FlagRow& flag : verb.flags) {
        if (flag.names.back() != "--help") {
            text += flag_row(flag, false);
        }
    }
    if (!verb.example.empty()) {
        text += fmt::format(".PP\n.nf\n{}\n.fi\n", plain(verb.example));
    }
    return text;
}

} // namespace

std::string man_page(const std::vector<VerbRow>& table) {
    std::string text = fmt::format(
        ".TH SUFFUSE 1 \"\" \"suffuse {}\" \"User Commands\"\n.SH NAME\nsuffuse \\- internal erosion of soils, grain "
        "by grain, from a grading curve to a report\n.SH SYNOPSIS\n.B suffuse\n\\fIVERB\\fR [\\fIARGUMENT\\fR] "
        "[\\fIFLAG\\fR]...\n.br\n.B suffuse\n\\fIFILE\\fR.toml\n.SH DESCRIPTION\nThe second form runs a case. suffuse "
        "VERB \\-\\-help shows this page's text for one verb.\n.SH FLAGS EVERYWHERE\n",
        plain(version())
    );
    for (const FlagRow& flag : table.front().flags) {
        text += flag_row(flag, false);
    }
    text += ".SH VERBS\n";
    for (const VerbRow& verb : table) {
        if (!verb.path.empty()) {
            text += verb_section(verb);
        }
    }
    text += fmt::format(".SH EXIT STATUS\n.nf\n{}.fi\n", plain(exit_codes_text()));
    text += ".SH ENVIRONMENT\n.TP\n\\fBNO_COLOR\\fR\nDisables colors if set.\n"
            ".SH FILES\n.TP\n\\fIruns/NAME\\-0001/\\fR\nThe results of a run: report.html, summary.json, events.jsonl, "
            "studies/.\n";
    return text;
}

} // namespace suffuse::apps
