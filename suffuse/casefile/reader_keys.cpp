// Which keys a table has: those requested, those that are missing, those that nobody knows.

#include "suffuse/base/spelling.hpp"
#include "suffuse/casefile/reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

namespace suffuse::casefile {

namespace {

/// A key of earlier versions: cases and run folders that have it are still read.
struct RetiredKey {
    std::string_view table, key, reason;
};

constexpr std::array retired_keys = {
    RetiredKey{"report", "language", "reports are in English; remove the line"},
};

/// "[fluid]", "a soil": the tables, but for those of `patterns`, that have a key of this name.
std::vector<std::string> homes_of(const std::string& name, const std::vector<std::string>& patterns) {
    std::vector<std::string> homes;
    for (const Key& key : schema()) {
        const bool is_here = std::ranges::find(patterns, key.table) != patterns.end();
        const std::string home = table_title(key.table);
        if (key.name == name && !is_here && key.table != "presets.*" && std::ranges::find(homes, home) == homes.end()) {
            homes.push_back(home);
        }
    }
    return homes;
}

/// Tables at the top of a case: contact, soil, study.
std::vector<std::string> top_tables() {
    std::vector<std::string> tables;
    for (const Key& key : schema()) {
        const std::string first(key.table.substr(0, key.table.find('.')));
        if (!first.empty() && first != "stage" && std::ranges::find(tables, first) == tables.end()) {
            tables.push_back(first);
        }
    }
    return tables;
}

} // namespace

Reader::Reader(
    ReadContext& context, const Node& table, Place place, std::vector<std::string> patterns, std::string path
)
    : context_(context), node_(table), place_(std::move(place)), patterns_(std::move(patterns)),
      path_(std::move(path)) {}

const Key& Reader::key_of(std::string_view key) const {
    for (const std::string& pattern : patterns_) {
        if (const Key* found = find_key(pattern, key)) {
            return *found;
        }
    }
    throw Bug(fmt::format("the schema has no key {} in {}", key, patterns_.front()));
}

const Node* Reader::take(std::string_view key) {
    const Key& known = key_of(key);
    taken_.emplace_back(key);
    const Node::Entry* entry = node_.find(key);
    if (entry != nullptr) {
        context_.places[join(key)] = entry->value.place;
        return &entry->value;
    }
    if (known.is_required) {
        error(
            "E201", place_, fmt::format("{} needs `{}`", title(), key),
            fmt::format("{} It is {}", known.text, value_text(known))
        );
    }
    return nullptr;
}

void Reader::error(std::string code, const Place& place, std::string message, std::string help, std::string label) {
    context_.problems.error(std::move(code), place, std::move(message), std::move(help), std::move(label));
}

std::string Reader::join(std::string_view key) const {
    return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

std::vector<std::string> Reader::inner_patterns(std::string_view key) const {
    return {key_of(key).table.empty() ? std::string(key) : fmt::format("{}.{}", key_of(key).table, key)};
}

std::string Reader::title() const {
    const std::size_t mark = path_.find(".stage.");
    if (mark == std::string::npos) {
        return path_.empty() ? "the case" : "[" + path_ + "]";
    }
    return fmt::format("stage \"{}\" of [{}]", path_.substr(mark + 7), path_.substr(0, mark));
}

void Reader::unknown_key(const Node::Entry& entry) {
    std::vector<std::string> here, everywhere;
    for (const Key& key : schema()) {
        const bool is_here = std::find(patterns_.begin(), patterns_.end(), key.table) != patterns_.end();
        if (is_here || key.table != "presets.*") { // nobody looks for a setting there
            (is_here ? here : everywhere).push_back(key.name);
        }
    }
    const std::vector<std::string> elsewhere = homes_of(entry.key, patterns_);
    std::string help;
    const auto near_here = nearest_word(entry.key, here);
    const auto near_else = nearest_word(entry.key, everywhere);
    const bool is_top_table = path_.empty() && entry.value.is_table();
    const auto near_table = is_top_table ? nearest_word(entry.key, top_tables()) : std::nullopt;
    if (near_table) {
        help = fmt::format("a table with a similar name exists: [{}]", *near_table);
    } else if (near_here && (elsewhere.empty() || edit_distance(entry.key, *near_here) == 1)) {
        help = fmt::format("a key with a similar name exists: `{}`", *near_here);
    } else if (!elsewhere.empty()) {
        help = fmt::format("`{}` belongs in {}", entry.key, fmt::join(elsewhere, " or "));
    } else if (near_else) {
        help = fmt::format(
            "a key with a similar name belongs in {}: `{}`", fmt::join(homes_of(*near_else, patterns_), " or "),
            *near_else
        );
    } else {
        help = is_top_table ? fmt::format("tables of a case are {}", fmt::join(top_tables(), ", "))
                            : fmt::format("keys here are {}", fmt::join(here, ", "));
    }
    error(
        "E203", entry.place, fmt::format("unknown key `{}` in {}", entry.key, title()), help,
        "not a key of " + table_title(patterns_.front())
    );
}

bool Reader::is_retired(const Node::Entry& entry) {
    for (const RetiredKey& retired : retired_keys) {
        if (retired.table == patterns_.front() && retired.key == entry.key) {
            context_.problems.warning(
                "W208", entry.place, fmt::format("`{}` in {} has no effect any more", entry.key, title()),
                std::string(retired.reason)
            );
            return true;
        }
    }
    return false;
}

void Reader::finish() {
    for (const Node::Entry& entry : node_.entries) {
        if (std::find(taken_.begin(), taken_.end(), entry.key) == taken_.end() && !is_retired(entry)) {
            unknown_key(entry);
        }
    }
}

} // namespace suffuse::casefile
