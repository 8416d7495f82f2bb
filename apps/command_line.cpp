#include "apps/command_line.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/spelling.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/help.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <algorithm>
#include <array>
#include <filesystem>

namespace suffuse::apps {
namespace {

std::vector<std::string> names_of_verbs(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(verb->get_name());
    }
    return names;
}

/// Long and short names of what an app and those above it understand.
std::vector<std::string> names_of_flags(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* level = &app; level != nullptr; level = level->get_parent()) {
        for (const CLI::Option* option : level->get_options()) {
            for (const std::string& name : option->get_lnames()) {
                names.push_back("--" + name);
            }
        }
    }
    return names;
}

/// "; run, resume have it": verbs that understand a flag which the one that was called does not.
std::string verbs_that_have(const CLI::App& app, const std::string& flag) {
    std::vector<std::string> verbs;
    for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
        if (verb->get_option_no_throw(flag) != nullptr) {
            verbs.push_back(verb->get_name());
        }
    }
    return verbs.empty() ? "" : fmt::format("; {} {} it", fmt::join(verbs, ", "), verbs.size() == 1 ? "has" : "have");
}

/// The verb, or verb below it, that was recognized last.
const CLI::App& innermost(const CLI::App& app) {
    const CLI::App* level = &app;
    while (!level->get_subcommands().empty()) {
        level = level->get_subcommands().back();
    }
    return *level;
}

[[noreturn]] void complain_about_extra(const CLI::App& app) {
    const CLI::App& verb = innermost(app);
    const std::vector<std::string> extra = app.remaining(true);
    const std::string word = extra.empty() ? "" : extra.front();
    const std::string help = &verb == &app ? "suffuse --help" : fmt::format("suffuse {} --help", path_of(verb));
    if (word.rfind('-', 0) == 0) {
        const std::string flag = word.substr(0, word.find('='));
        const std::string elsewhere = verbs_that_have(app, flag);
        const std::string hint = elsewhere.empty() ? near_hint(flag, names_of_flags(verb)) : elsewhere;
        throw UsageError(fmt::format("unknown flag {}{}; {} lists them", shown(flag), hint, help));
    }
    std::vector<std::string> verbs = names_of_verbs(verb);
    if (!verbs.empty()) {
        verbs.emplace_back("help");
        if (std::error_code none; std::filesystem::is_regular_file(word, none)) {
            throw UsageError(fmt::format(
                "unknown verb {}: it is a file. A grading: suffuse assess {}, or suffuse new DIR --psd {}; a case: "
                "suffuse run {}",
                shown(word), shell_word(word), shell_word(word), shell_word(word)
            ));
        }
        throw UsageError(fmt::format("unknown verb {}{}; {} lists them", shown(word), near_hint(word, verbs), help));
    }
    throw UsageError(fmt::format("{} is one argument too many; see {}", shown(word), help));
}

Color color_of(const std::string& word) {
    if (word == "always") {
        return Color::Always;
    }
    if (word == "never") {
        return Color::Never;
    }
    if (word == "auto") {
        return Color::Auto;
    }
    throw UsageError(fmt::format("--color {}: it is auto, always or never", shown(word)));
}

/// `suffuse help bench step` is `suffuse bench step --help`; then `suffuse my/case.toml` runs the case. Flags of every
/// verb may stand before.
std::vector<std::string> with_verb(std::vector<std::string> words) {
    constexpr std::string_view ending = ".toml";
    constexpr std::array<std::string_view, 5> everywhere{"-q", "--quiet", "-v", "--verbose", "--json"};
    std::size_t first = 0;
    while (first < words.size() &&
           (words[first] == "--color" || std::ranges::find(everywhere, words[first]) != everywhere.end())) {
        first += words[first] == "--color" ? 2 : 1; // with its value
    }
    if (first < words.size() && words[first] == "help") {
        words.erase(words.begin() + static_cast<std::ptrdiff_t>(first));
        words.emplace_back("--help");
    }
    if (first < words.size() && words[first].size() > ending.size() && words[first].ends_with(ending)) {
        words.insert(words.begin() + static_cast<std::ptrdiff_t>(first), "run");
    }
    return words;
}

/// Whether help is requested on a verb that there is not.
bool names_unknown_verb(const CLI::App& app) {
    const std::vector<std::string> extra = app.remaining(true);
    return !extra.empty() && !extra.front().starts_with('-') && !names_of_verbs(innermost(app)).empty();
}

/// @return what there is to say where help or the version is requested, or no verb; else empty
std::string parse(CLI::App& app, std::vector<std::string> words) {
    std::reverse(words.begin(), words.end()); // as CLI11 wants them
    try {
        app.parse(words);
    } catch (const CLI::CallForVersion&) {
        return version_text();
    } catch (const CLI::CallForHelp&) {
        if (names_unknown_verb(app)) {
            complain_about_extra(app);
        }
        const CLI::App& verb = innermost(app);
        return &verb == &app ? overview(app) : help_on(verb);
    } catch (const CLI::ExtrasError&) {
        complain_about_extra(app);
    } catch (const CLI::ParseError& error) {
        const CLI::App& verb = innermost(app);
        std::string message = shown(error.what());
        if (const std::size_t mark = message.find(": 1 required"); mark != std::string::npos) {
            message = message.substr(0, mark) + " needs a value"; // "--gradient: 1 required I missing"
        }
        throw UsageError(fmt::format("{}; see suffuse {}--help", message, &verb == &app ? "" : path_of(verb) + " "));
    }
    return app.get_subcommands().empty() ? overview(app) : "";
}

void add_everywhere(CLI::App& app, CommandLine& line, std::string& color) {
    Options everywhere(app);
    everywhere.flag("-q,--quiet", line.quiet, "print only results and errors");
    everywhere.flag("-v,--verbose", line.verbose, "say more");
    everywhere.flag("--json", line.json, "one JSON document on standard output");
    everywhere.value("--color", color, "auto, always or never; NO_COLOR is obeyed")
        .type("WHEN")
        .suggest({"auto", "always", "never"});
}

std::vector<std::shared_ptr<Verb>> add_verbs(CLI::App& app) {
    const Options program(app);
    std::vector<std::shared_ptr<Verb>> verbs;
    for (const auto make : verb_makers) {
        verbs.push_back(make());
        Options below = program.below(verbs.back()->name(), verbs.back()->text(), verbs.back()->example());
        verbs.back()->add_to(below);
    }
    return verbs;
}

std::string typed_command(const std::vector<std::string>& words) {
    std::string typed = "suffuse";
    for (const std::string& word : words) {
        typed += " " + shell_word(word);
    }
    return typed;
}

} // namespace

ParsedCommand read_command_line(int argc, const char* const* argv) {
    const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    ParsedCommand command;
    std::string color = "auto";
    CLI::App app;
    app.fallthrough();
    app.require_subcommand(0, 1); // so that `suffuse studio runs` names a folder, not a second verb
    app.set_version_flag("--version", std::string(), "which program this is");
    add_everywhere(app, command.line, color);
    const std::vector<std::shared_ptr<Verb>> verbs = add_verbs(app);
    command.line.typed = typed_command(words);
    command.text = parse(app, with_verb(words));
    if (!command.text.empty()) {
        return command;
    }
    const std::string called = app.get_subcommands().front()->get_name();
    command.verb = *std::ranges::find(verbs, called, [](const auto& verb) { return verb->name(); });
    command.verb->check();
    command.line.color = color_of(color);
    command.text = command.verb->printed(app);
    return command;
}

} // namespace suffuse::apps
