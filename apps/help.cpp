#include "apps/help.hpp"

#include "suffuse/base/version.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <string_view>
#include <vector>

namespace suffuse::apps {
namespace {

constexpr std::string_view exit_codes =
    "exit codes  0 done, 1 failed while running, 2 wrong use, 3 errors in the case\n"
    "            or its data, 4 ran but missed a quality bar, 5 compare or verify\n"
    "            found a difference, 70 a defect of suffuse, 74 cannot read or\n"
    "            write, 75 time limit reached, 128 + N stopped by signal N (130 by\n"
    "            Ctrl-C, 143 by SIGTERM); from 75 on the run can be resumed\n";

std::vector<const CLI::App*> verbs_of(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App*) { return true; });
}

std::string flag_names(const CLI::Option& option) {
    std::string names = option.get_positional() ? option.get_name(true, false) : option.get_name(false, true);
    for (std::size_t at = names.find(','); at != std::string::npos; at = names.find(',', at + 2)) {
        names.replace(at, 1, ", ");
    }
    if (!option.get_positional() && option.get_items_expected_max() > 0) {
        names += " " + option.get_type_name().substr(0, option.get_type_name().find(':'));
    }
    return names;
}

/// @param left_out a flag that is not listed, besides --help
std::string flags_of(const CLI::App& app, bool positional, std::string_view left_out = {}) {
    std::string text, group, of_group;
    const std::string usual = app.get_help_ptr()->get_group();
    for (const CLI::Option* option : app.get_options()) {
        const bool is_listed =
            option->get_positional() == positional && option->get_name() != "--help" && option->get_name() != left_out;
        if (is_listed && option->get_group() != usual) {
            group = option->get_group();
            of_group += (of_group.empty() ? "" : ", ") + option->get_name();
        } else if (is_listed) {
            text += fmt::format("  {:24} {}\n", flag_names(*option), option->get_description());
        }
    }
    return group.empty() ? text : text + fmt::format("  {} {}\n", of_group, group);
}

} // namespace

std::string_view exit_codes_text() {
    return exit_codes;
}

std::string path_of(const CLI::App& verb) {
    const CLI::App* above = verb.get_parent();
    const bool is_top = above == nullptr || above->get_parent() == nullptr;
    return is_top ? verb.get_name() : path_of(*above) + " " + verb.get_name();
}

std::string overview(const CLI::App& app) {
    std::string text = "suffuse: internal erosion of soils, grain by grain, from grading to report\n\n"
                       "  suffuse new my-dyke --psd dyke.csv\n"
                       "  suffuse run my-dyke/case.toml\n\nverbs\n";
    for (const CLI::App* verb : verbs_of(app)) {
        text += fmt::format("  {:12} {}\n", verb->get_name(), verb->get_description());
    }
    text += "\neverywhere\n" + flags_of(app, false);
    text += "\nsuffuse VERB --help for details; suffuse FILE.toml runs that case\n\n";
    return text + std::string(exit_codes);
}

std::string help_on(const CLI::App& verb) {
    const std::string path = path_of(verb);
    std::string text = fmt::format("suffuse {}: {}\n", path, verb.get_description());
    const std::string arguments = flags_of(verb, true), flags = flags_of(verb, false);
    if (!verbs_of(verb).empty()) {
        text += "\nverbs\n";
        for (const CLI::App* below : verbs_of(verb)) {
            text += fmt::format("  {:24} {}\n", path + " " + below->get_name(), below->get_description());
        }
    }
    if (!arguments.empty()) {
        text += "\narguments\n" + arguments;
    }
    if (!flags.empty()) {
        text += "\nflags\n" + flags;
    }
    const CLI::App* above = verb.get_parent()->get_parent();
    text += "\neverywhere\n" + flags_of(above != nullptr ? *above : *verb.get_parent(), false, "--version");
    if (const std::string example = verb.get_footer(); !example.empty()) {
        text += fmt::format("\nexample\n{}\n", example);
    }
    return text;
}

std::string version_text() {
    return fmt::format("suffuse {} ({}, {})\n", version(), commit(), compiler());
}

} // namespace suffuse::apps
