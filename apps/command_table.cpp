#include "apps/command_table.hpp"

#include <CLI/CLI.hpp>

#include "apps/help.hpp"
#include <algorithm>

namespace suffuse::apps {
namespace {

/// Words that the option allows or suggests, which stand in its type: "NAME:{svg,png,pdf}" -> svg, png, pdf. None where
/// only the user knows.
std::vector<std::string> words_of(const std::string& type) {
    std::vector<std::string> words;
    const std::size_t open = type.find('{'), close = type.find('}');
    if (open == std::string::npos || close == std::string::npos) {
        return words;
    }
    for (std::size_t at = open + 1; at < close;) {
        const std::size_t end = std::min(type.find(',', at), close);
        words.push_back(type.substr(at, end - at));
        at = end + 1;
    }
    return words;
}

Values kind_of(const std::string& placeholder) {
    if (placeholder == "CASE") {
        return Values::CaseFile;
    }
    if (placeholder == "DIR" || placeholder == "OTHER") {
        return Values::Folder;
    }
    return placeholder == "FILE" || placeholder == "STATE" ? Values::File : Values::Any;
}

FlagRow row_of(const CLI::Option& option) {
    FlagRow row;
    row.text = option.get_lnames() == std::vector<std::string>{"help"} ? "show what suffuse is, with an example"
                                                                       : option.get_description();
    if (option.get_positional()) {
        row.placeholder = option.get_name(true, false);
        row.names = {row.placeholder};
    } else {
        for (const std::string& name : option.get_snames()) {
            row.names.push_back("-" + name);
        }
        for (const std::string& name : option.get_lnames()) {
            row.names.push_back("--" + name);
        }
        if (option.get_items_expected_max() > 0) {
            const std::string type = option.get_type_name();
            row.placeholder = type.substr(0, type.find(':'));
        }
    }
    if (!row.placeholder.empty()) {
        row.words = words_of(option.get_type_name());
        row.values = row.words.empty() ? kind_of(row.placeholder) : Values::Words;
    }
    return row;
}

void add_rows(const CLI::App& app, const std::string& path, std::vector<VerbRow>& rows) {
    VerbRow row;
    row.path = path;
    row.text = app.get_description();
    row.example = app.get_footer();
    for (const CLI::Option* option : app.get_options()) {
        (option->get_positional() ? row.arguments : row.flags).push_back(row_of(*option));
    }
    const auto below = app.get_subcommands([](const CLI::App*) { return true; });
    for (const CLI::App* verb : below) {
        row.verbs.push_back(verb->get_name());
    }
    rows.push_back(std::move(row));
    for (const CLI::App* verb : below) {
        add_rows(*verb, path_of(*verb), rows);
    }
}

} // namespace

std::vector<VerbRow> command_table(const CLI::App& app) {
    std::vector<VerbRow> rows;
    add_rows(app, "", rows);
    return rows;
}

} // namespace suffuse::apps
