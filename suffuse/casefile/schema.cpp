#include "suffuse/casefile/schema.hpp"

#include "suffuse/casefile/bind.hpp"
#include "suffuse/casefile/calibrate_fields.hpp"
#include "suffuse/casefile/names.hpp"
#include "suffuse/casefile/stage_list.hpp"
#include "suffuse/casefile/study_fields.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace suffuse::casefile {

namespace {

std::vector<Key> make_rows() {
    std::vector<Key> rows;
    for (auto part :
         {detail::general_rows, detail::soil_and_study_rows, detail::preparation_rows, detail::test_rows,
          detail::erosion_rows, detail::calibrate_rows, detail::output_rows}) {
        std::vector<Key> more = part();
        rows.insert(rows.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    }
    return rows;
}

const std::vector<Key>& rows_without_defaults() {
    static const std::vector<Key> rows = make_rows();
    return rows;
}

/// Writes down the values of a table of Specs as they are, as defaults of its keys.
void collect_defaults(std::vector<Key>& rows, const Node& table, const std::vector<std::string>& patterns) {
    for (const auto& [name, place, value] : table.entries) {
        for (const std::string& pattern : patterns) {
            const auto is_it = [&, key = name](const Key& row) { return row.table == pattern && row.name == key; };
            const auto row = std::find_if(rows.begin(), rows.end(), is_it);
            if (row == rows.end()) {
                continue;
            }
            if (value.is_table()) {
                collect_defaults(rows, value, {pattern.empty() ? name : pattern + "." + name});
            } else if (!row->is_required) {
                row->default_text = print_value(value);
            }
            break;
        }
    }
}

std::vector<Key> make_schema() {
    std::vector<Key> rows = rows_without_defaults();
    Case defaults;
    defaults.soils["name"] = {};
    Study study;
    study.refine.emplace();
    study.sample_size.emplace();
    for (std::size_t verb = 0; verb < names::verbs.size(); ++verb) {
        study.stages.emplace_back().spec = default_spec(verb);
    }
    for (const auto& [name, place, value] : tree_of(defaults).entries) {
        Node one;
        one.set(name, value);
        if (name == "soil") {
            collect_defaults(rows, value.entries.front().value, {"soil.*"});
        } else if (value.is_table()) {
            collect_defaults(rows, value, {name});
        } else {
            collect_defaults(rows, one, {""});
        }
    }
    collect_defaults(rows, write_study(study), {"study.*"});
    for (const Stage& stage : study.stages) {
        collect_defaults(rows, write_stage(stage), {"stage." + verb_of(stage.spec), "stage"});
    }
    collect_defaults(rows, calibrate_defaults(), {"calibrate"});
    collect_defaults(rows, calibrate_target_defaults(), {"calibrate.targets"});
    for (Key& row : rows) {
        const bool is_derived = row.kind == ValueKind::Other && row.name == "stage";
        if (is_derived || row.name == "applied_preset") {
            row.default_text.clear();
        }
    }
    return rows;
}

std::string bound_text(const Key& key, double bound) {
    if (bound == 0) {
        return "0";
    }
    return key.kind == ValueKind::Quantity ? print_quantity(bound, key.dimension) : fmt::format("{}", bound);
}

} // namespace

const std::vector<Key>& schema() {
    static const std::vector<Key> all = make_schema();
    return all;
}

const Key* find_key(std::string_view table, std::string_view name) {
    for (const Key& key : rows_without_defaults()) {
        if (key.table == table && key.name == name) {
            return &key;
        }
    }
    return nullptr;
}

std::string table_title(std::string_view table) {
    if (table.empty()) {
        return "the top of a case";
    }
    if (table == "stage") {
        return "a stage";
    }
    if (table == "soil.*") {
        return "a soil";
    }
    if (table == "study.*") {
        return "a study";
    }
    if (table == "presets.*") {
        return "a preset";
    }
    if (table == "calibrate.targets") {
        return "a target of [calibrate]";
    }
    if (!table.starts_with("stage.")) {
        return fmt::format("[{}]", table);
    }
    const std::string_view rest = table.substr(6);
    const std::size_t point = rest.find('.');
    const std::string_view verb = rest.substr(0, point);
    if (std::find(names::verbs.begin(), names::verbs.end(), verb) == names::verbs.end()) {
        return fmt::format("`{}` of a stage", rest);
    }
    const std::string stage = fmt::format("a stage that does \"{}\"", verb);
    return point == std::string_view::npos ? stage : fmt::format("`{}` of {}", rest.substr(point + 1), stage);
}

std::string key_place(const Key& key) {
    if (key.table.empty()) {
        return key.name;
    }
    std::string table = key.table;
    if (table.starts_with("stage")) {
        table = "study.NAME." + table;
    }
    if (const std::size_t star = table.find('*'); star != std::string::npos) {
        table.replace(star, 1, "NAME");
    }
    return fmt::format("[{}] {}", table, key.name);
}

std::string range_text(const Key& key) {
    const bool has_least = std::isfinite(key.range.least);
    const bool has_most = std::isfinite(key.range.most) && !(key.kind == ValueKind::Count && key.range.most >= 1e15);
    if (has_least && key.range.least == key.range.most) {
        return "exactly " + bound_text(key, key.range.least);
    }
    const std::string least =
        has_least ? (key.range.without_least ? "above " : "at least ") + bound_text(key, key.range.least) : "";
    const std::string most =
        has_most ? (key.range.without_most ? "below " : "at most ") + bound_text(key, key.range.most) : "";
    return least + (has_least && has_most ? " and " : "") + most;
}

std::string value_text(const Key& key) {
    std::string text;
    switch (key.kind) {
    case ValueKind::Text:
        text = "a text";
        break;
    case ValueKind::Choice:
        text = fmt::format("{} \"{}\"", key.choices.size() > 1 ? "one of" : "only", fmt::join(key.choices, "\", \""));
        break;
    case ValueKind::Count:
        text = "a whole number";
        break;
    case ValueKind::Ratio:
        text = "a bare number, or one with %";
        break;
    case ValueKind::Quantity:
        text = fmt::format("{} with its unit", with_article(key.dimension));
        break;
    case ValueKind::Flag:
        text = "true or false";
        break;
    case ValueKind::Direction:
        text = "\"x\", \"y\", \"z\", \"-x\", \"-y\", \"-z\", or three numbers";
        break;
    case ValueKind::Table:
        text = "a table";
        break;
    case ValueKind::Other:
        break;
    }
    if (!key.form.empty()) {
        return key.form;
    }
    if (const std::string range = range_text(key); !range.empty()) {
        text += ", " + range;
    }
    return key.is_list ? "a list, each " + text : text;
}

std::string schema_markdown() {
    std::string page =
        "# The case file\n\n"
        "Made from the program's own table of keys. A value with a dimension is a text with its unit, "
        "`\"100 kPa\"`; bare numbers are ratios and counts; `%` and `deg` are units. Keys without a default "
        "may be left out unless they are required.\n";
    std::string table = "none yet";
    for (const Key& key : schema()) {
        if (key.table != table) {
            table = key.table;
            std::string heading = table_title(table);
            heading[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(heading[0])));
            page += fmt::format("\n## {}\n\n| key | value | default | |\n|---|---|---|---|\n", heading);
        }
        const std::string shown = key.is_required            ? "required"
                                  : key.default_text.empty() ? ""
                                                             : "`" + key.default_text + "`";
        page += fmt::format("| `{}` | {} | {} | {} |\n", key.name, value_text(key), shown, key.text);
    }
    return page;
}

} // namespace suffuse::casefile
