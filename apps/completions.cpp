#include "apps/completions.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/spelling.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace suffuse::apps {
namespace {

/// Flags of a verb, with those that stand everywhere; each name once.
std::vector<FlagRow> flags_at(const std::vector<VerbRow>& table, const VerbRow& verb) {
    std::vector<FlagRow> flags = verb.flags;
    if (!verb.path.empty()) {
        flags.insert(flags.end(), table.front().flags.begin(), table.front().flags.end());
    }
    std::vector<FlagRow> each;
    for (const FlagRow& flag : flags) {
        const auto same = [&](const FlagRow& other) { return other.names.back() == flag.names.back(); };
        if (std::none_of(each.begin(), each.end(), same)) {
            each.push_back(flag);
        }
    }
    return each;
}

std::string names_of(const std::vector<FlagRow>& flags) {
    std::vector<std::string> names;
    for (const FlagRow& flag : flags) {
        names.insert(names.end(), flag.names.begin(), flag.names.end());
    }
    return fmt::format("{}", fmt::join(names, " "));
}

/// For single quotes of a shell.
std::string quoted(std::string text, std::string_view quote) {
    for (std::size_t at = text.find('\''); at != std::string::npos; at = text.find('\'', at + quote.size())) {
        text.replace(at, 1, quote);
    }
    return text;
}

// ---- bash

std::string bash_values(const FlagRow& row) {
    switch (row.values) {
    case Values::Words:
        return fmt::format("compgen -W '{}' -- \"$word\"", fmt::join(row.words, " "));
    case Values::CaseFile:
        return "compgen -d -- \"$word\"; compgen -f -X '!*.toml' -- \"$word\"";
    case Values::Folder:
        return "compgen -d -- \"$word\"";
    case Values::File:
        return "compgen -f -- \"$word\"";
    default:
        return ":";
    }
}

std::string bash_script(const std::vector<VerbRow>& table) {
    std::string paths, answers;
    for (const VerbRow& verb : table) {
        if (!verb.path.empty()) {
            paths += fmt::format("{}'{}'", paths.empty() ? "" : " | ", verb.path);
        }
        std::string rest = verb.arguments.empty() ? ":" : bash_values(verb.arguments.front());
        if (!verb.verbs.empty()) {
            rest = fmt::format("compgen -W '{}' -- \"$word\"", fmt::join(verb.verbs, " "));
        }
        if (verb.path.empty()) { // a case alone runs it
            rest += "; compgen -f -X '!*.toml' -- \"$word\"";
        }
        std::string valued;
        for (const FlagRow& flag : flags_at(table, verb)) {
            if (!flag.placeholder.empty()) {
                valued += fmt::format("        {}) {} ;;\n", fmt::join(flag.names, " | "), bash_values(flag));
            }
        }
        answers += fmt::format(
            "    '{}')\n        case $before in\n{}        *)\n            case $word in\n"
            "            -*) compgen -W '{}' -- \"$word\" ;;\n            *) {} ;;\n            esac\n            ;;\n"
            "        esac\n        ;;\n",
            verb.path, valued, names_of(flags_at(table, verb)), rest
        );
    }
    return "# bash completion for suffuse, written by `suffuse completions bash`. To use it:\n"
           "#   suffuse completions bash > ~/.local/share/bash-completion/completions/suffuse\n"
           "_suffuse_answers() {\n    local word=$1 before=$2 verb=$3\n    case $verb in\n" +
           answers +
           "    esac\n}\n\n_suffuse() {\n    local verb='' k path\n"
           "    for ((k = 1; k < COMP_CWORD; ++k)); do\n        path=${verb:+$verb }${COMP_WORDS[k]}\n"
           "        case $path in\n        " +
           paths +
           ") verb=$path ;;\n        esac\n    done\n"
           "    mapfile -t COMPREPLY < <(_suffuse_answers \"${COMP_WORDS[COMP_CWORD]}\" "
           "\"${COMP_WORDS[COMP_CWORD - 1]}\" \"$verb\" | sort -u)\n}\n"
           "complete -o filenames -F _suffuse suffuse\n";
}

// ---- zsh

std::string zsh_values(const FlagRow& row) {
    switch (row.values) {
    case Values::Words:
        return fmt::format("({})", fmt::join(row.words, " "));
    case Values::CaseFile:
        return "_files -g \"*.toml\"";
    case Values::Folder:
        return "_files -/";
    case Values::File:
        return "_files";
    default:
        return " ";
    }
}

/// For an explanation within a specification of _arguments, inside single quotes.
std::string zsh_text(std::string text) {
    for (const std::string_view mark : {"\\", "[", "]", ":"}) {
        for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 2)) {
            text.insert(at, "\\");
        }
    }
    return quoted(text, "'\\''");
}

std::string zsh_arguments(const std::vector<VerbRow>& table, const VerbRow& verb) {
    std::string text;
    for (const FlagRow& flag : flags_at(table, verb)) {
        for (const std::string& name : flag.names) {
            text += fmt::format(" \\\n            '*{}[{}]", name, zsh_text(flag.text));
            text += flag.placeholder.empty() ? "'" : fmt::format(":{}:{}'", flag.placeholder, zsh_values(flag));
        }
    }
    for (std::size_t k = 0; k < verb.arguments.size(); ++k) {
        const FlagRow& row = verb.arguments[k];
        text += fmt::format(" \\\n            '{}:{}:{}'", k + 1, row.placeholder, zsh_values(row));
    }
    return text;
}

/// A list of verbs with their texts, and what each goes on with.
void add_zsh_function(const std::vector<VerbRow>& table, const VerbRow& verb, std::string& script) {
    const auto name_of = [](const std::string& path) {
        std::string name = "_suffuse" + (path.empty() ? "" : "_" + path);
        std::replace(name.begin(), name.end(), ' ', '_');
        return name;
    };
    script += name_of(verb.path) + "() {\n";
    if (verb.verbs.empty()) {
        script += "    _arguments -s" + zsh_arguments(table, verb) + "\n}\n\n";
        return;
    }
    std::string list, cases;
    for (const std::string& below : verb.verbs) {
        const std::string path = verb.path.empty() ? below : verb.path + " " + below;
        const auto row = std::find_if(table.begin(), table.end(), [&](const VerbRow& r) { return r.path == path; });
        list += fmt::format("        '{}:{}'\n", below, zsh_text(row->text));
        cases += fmt::format("        {}) {} ;;\n", below, name_of(path));
    }
    script += fmt::format(
        "    local state line\n    local -a verbs=(\n{}    )\n    _arguments -C -s{} \\\n"
        "            '1: :->verb' '*:: :->rest'\n    case $state in\n    verb) _describe verb verbs{} ;;\n"
        "    rest)\n        case $line[1] in\n{}        esac\n        ;;\n    esac\n}}\n\n",
        list, zsh_arguments(table, verb), verb.path.empty() ? "; _files -g \"*.toml\"" : "", cases
    );
}

std::string zsh_script(const std::vector<VerbRow>& table) {
    std::string script = "#compdef suffuse\n# zsh completion for suffuse, written by `suffuse completions zsh`. To use "
                         "it:\n#   suffuse completions zsh > \"${fpath[1]}/_suffuse\"\n\n";
    for (const VerbRow& verb : table) {
        add_zsh_function(table, verb, script);
    }
    return script +
           "if [ \"$funcstack[1]\" = _suffuse ]; then\n    _suffuse \"$@\"\nelse\n    compdef _suffuse suffuse\n"
           "fi\n";
}

// ---- fish

std::string fish_values(const FlagRow& row) {
    switch (row.values) {
    case Values::Words:
        return fmt::format(" -x -a '{}'", fmt::join(row.words, " "));
    case Values::CaseFile:
        return " -x -a '(__fish_complete_suffix .toml)'";
    case Values::Folder:
        return " -x -a '(__fish_complete_directories)'";
    case Values::File:
        return " -r -F";
    default:
        return " -x";
    }
}

std::string fish_names(const FlagRow& flag) {
    std::string text;
    for (const std::string& name : flag.names) {
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    return text;
}

/// The condition under which a line belongs to the verb: all of its words were given.
std::string fish_condition(const VerbRow& verb) {
    if (verb.path.empty()) {
        return "__fish_use_subcommand";
    }
    std::string when;
    for (std::size_t at = 0; at <= verb.path.size();) {
        const std::size_t end = std::min(verb.path.find(' ', at), verb.path.size());
        when += fmt::format(
            "{}__fish_seen_subcommand_from {}", when.empty() ? "" : "; and ", verb.path.substr(at, end - at)
        );
        at = end + 1;
    }
    return when;
}

std::string fish_script(const std::vector<VerbRow>& table) {
    std::string script = "# fish completion for suffuse, written by `suffuse completions fish`. To use it:\n"
                         "#   suffuse completions fish > ~/.config/fish/completions/suffuse.fish\n"
                         "complete -c suffuse -f\n"
                         "complete -c suffuse -n __fish_use_subcommand -a '(__fish_complete_suffix .toml)'\n";
    for (const VerbRow& verb : table) {
        const std::string when = fish_condition(verb);
        for (const std::string& below : verb.verbs) {
            const std::string path = verb.path.empty() ? below : verb.path + " " + below;
            const auto row = std::find_if(table.begin(), table.end(), [&](const VerbRow& r) { return r.path == path; });
            const std::string none =
                verb.path.empty() ? ""
                                  : fmt::format("; and not __fish_seen_subcommand_from {}", fmt::join(verb.verbs, " "));
            script += fmt::format(
                "complete -c suffuse -n '{}{}' -a {} -d '{}'\n", when, none, below, quoted(row->text, "\\'")
            );
        }
        for (const FlagRow& flag : verb.flags) { // those of the program itself stand everywhere
            const std::string condition = verb.path.empty() ? "" : fmt::format(" -n '{}'", when);
            script += fmt::format(
                "complete -c suffuse{}{}{} -d '{}'\n", condition, fish_names(flag),
                flag.placeholder.empty() ? "" : fish_values(flag), quoted(flag.text, "\\'")
            );
        }
        if (!verb.arguments.empty() && verb.arguments.front().values != Values::Any) {
            std::string values = fish_values(verb.arguments.front());
            values = values == " -r -F" ? " -F" : values.substr(values.find(" -a"));
            script += fmt::format("complete -c suffuse -n '{}'{}\n", when, values);
        }
    }
    return script;
}

} // namespace

std::string completions_for(const std::string& shell, const std::vector<VerbRow>& table) {
    if (shell == "bash") {
        return bash_script(table);
    }
    if (shell == "zsh") {
        return zsh_script(table);
    }
    if (shell == "fish") {
        return fish_script(table);
    }
    throw UsageError(fmt::format(
        "no completions for {}{}; there are bash, zsh, fish", shown(shell), near_hint(shell, {"bash", "zsh", "fish"})
    ));
}

} // namespace suffuse::apps
