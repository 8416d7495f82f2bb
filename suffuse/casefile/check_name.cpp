#include "suffuse/casefile/check_name.hpp"

#include <fmt/format.h>

#include <cctype>
#include <string_view>

namespace suffuse::casefile {

bool check_name(ReadContext& context, const std::string& what, const std::string& name, const Place& place) {
    const auto is_plain = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
    };
    bool is_good = !name.empty() && name.size() <= 64 && is_plain(name.front());
    for (const char c : name) {
        is_good = is_good && (is_plain(c) || c == '.');
    }
    if (!is_good) {
        context.problems.error(
            "E209", place, fmt::format("\"{}\" cannot be the name of a {}", name, what),
            "names become folders: letters, digits, - and _, with . between them, at most 64"
        );
    }
    return is_good;
}

bool check_stage_name(ReadContext& context, const std::string& name, const Place& place) {
    if (!check_name(context, "stage", name, place)) {
        return false;
    }
    // A run writes grains.pvd, view.py, provenance.json and events.jsonl next to the folders of the stages.
    for (const std::string_view ending : {".pvd", ".py", ".json", ".jsonl"}) {
        if (name.ends_with(ending)) {
            context.problems.error(
                "E209", place,
                fmt::format("\"{}\" cannot be the name of a stage: a run writes files of that ending", name),
                fmt::format("leave the {} out", ending)
            );
            return false;
        }
    }
    return true;
}

} // namespace suffuse::casefile
