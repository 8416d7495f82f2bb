#include "suffuse/job/assumed_values.hpp"

#include <algorithm>
#include <string>

namespace suffuse::job {
namespace {

std::string trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
    return first == std::string_view::npos ? std::string{} : std::string(text.substr(first, last - first + 1));
}

/// The name between the brackets of a table's header; empty for other lines.
std::string table_name(const std::string& line) {
    if (!line.starts_with('[')) {
        return {};
    }
    const std::size_t begin = line.find_first_not_of('['), end = line.find(']');
    return begin == std::string::npos || end == std::string::npos || end < begin ? std::string{}
                                                                                 : line.substr(begin, end - begin);
}

std::string full_key(const std::string& table, const std::string& stage, const std::string& key) {
    constexpr std::string_view of_stage = ".stage";
    if (table.ends_with(of_stage)) {
        const std::string study = table.substr(0, table.size() - of_stage.size());
        return study + (stage.empty() ? "" : ", stage " + stage) + ": " + key;
    }
    return table.empty() ? key : table + "." + key;
}

/// Where a comment begins, outside of texts in quotes.
std::size_t comment_of(std::string_view line) {
    bool quoted = false;
    for (std::size_t k = 0; k < line.size(); ++k) {
        if (line[k] == '"') {
            quoted = !quoted;
        } else if (line[k] == '#' && !quoted) {
            return k;
        }
    }
    return std::string_view::npos;
}

/// One line that gives a key.
struct Given {
    std::string table, stage, key, value, note;
    bool is_assumed = false;
};

std::vector<Given> given_keys(std::string_view case_text) {
    std::vector<Given> all;
    std::string table, stage;
    for (std::size_t at = 0; at < case_text.size();) {
        const std::size_t end = std::min(case_text.find('\n', at), case_text.size());
        const std::string line = trimmed(case_text.substr(at, end - at));
        at = end + 1;
        if (const std::string name = table_name(line); !name.empty()) {
            table = name;
            stage.clear();
            continue;
        }
        const std::size_t equals = line.find('='), comment = comment_of(line);
        if (equals == std::string::npos || comment < equals) {
            continue;
        }
        const std::size_t mark = comment == std::string::npos ? comment : line.find("#~", comment);
        Given given{table, stage, trimmed(std::string_view(line).substr(0, equals)), {}, {}};
        given.value = trimmed(std::string_view(line).substr(equals + 1, comment - equals - 1));
        given.is_assumed = mark != std::string::npos;
        given.note = given.is_assumed ? trimmed(std::string_view(line).substr(mark + 2)) : "";
        if (given.key == "name" && given.value.size() > 2) {
            stage = given.value.substr(1, given.value.size() - 2);
        }
        all.push_back(std::move(given));
    }
    return all;
}

/// Whether the preset in force gives another value for it, or it belongs to one that is not.
bool is_overruled(const Given& given, const std::vector<Given>& all, const std::string& preset) {
    if (given.table.starts_with("presets.")) {
        return given.table != preset;
    }
    return std::ranges::any_of(all, [&](const Given& other) {
        const bool shortens_tests = other.key == "triaxial_strain" && given.key == "strain";
        return other.table == preset && (other.key == given.key || shortens_tests);
    });
}

/// Whether --set gives another value for it, or for a part of it. What it gives for a study, the preset does not.
bool is_set_anew(const Given& given, const std::vector<std::string>& overrides) {
    std::string path = given.table.empty() ? "" : given.table + ".";
    path += (given.stage.empty() ? "" : given.stage + ".") + given.key;
    const bool of_preset = given.table.starts_with("presets.");
    return std::ranges::any_of(overrides, [&](const std::string& text) {
        const std::string set = trimmed(text.substr(0, text.find('=')));
        return (of_preset && set.starts_with("study.") && set.ends_with("." + given.key)) || set == path ||
               set.starts_with(path + ".");
    });
}

/// Whether it belongs to a study that is none of these.
bool is_of_another_study(const Given& given, const std::vector<std::string>& studies) {
    const std::string of_study = "study.";
    return !studies.empty() && given.table.starts_with(of_study) &&
           std::ranges::none_of(studies, [&](const std::string& study) {
               return (given.table + ".").starts_with(of_study + study + ".");
           });
}

} // namespace

std::vector<report::AssumedValue> assumed_values(
    std::string_view case_text, const std::string& preset, const std::vector<std::string>& overrides,
    const std::vector<std::string>& studies
) {
    std::vector<report::AssumedValue> values;
    const std::vector<Given> all = given_keys(case_text);
    for (const Given& given : all) {
        if (given.is_assumed && !is_overruled(given, all, "presets." + preset) && !is_set_anew(given, overrides) &&
            !is_of_another_study(given, studies)) {
            values.push_back({full_key(given.table, given.stage, given.key), given.value, given.note});
        }
    }
    return values;
}

} // namespace suffuse::job
