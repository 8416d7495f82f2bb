#include "suffuse/casefile/stage_list.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/casefile/check_measures.hpp"
#include "suffuse/casefile/check_name.hpp"
#include "suffuse/casefile/fields.hpp"
#include "suffuse/casefile/stage_traits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace suffuse::casefile {

namespace {

template <std::size_t... I>
StageSpec make_spec(std::size_t verb, std::index_sequence<I...>) {
    StageSpec spec;
    ((I == verb ? void(spec.emplace<I>()) : void()), ...);
    return spec;
}

/// Where the stages of a study stand, for messages.
struct StageNodes {
    std::vector<const Node*> nodes;

    /// Of a key of the stage in this row, or of the stage where it does not have the key.
    [[nodiscard]] Place place_of(std::size_t row, std::string_view key) const {
        const Node::Entry* entry = nodes[row]->find(key);
        return entry != nullptr ? entry->value.place : nodes[row]->place;
    }
};

std::optional<Stage> read_stage(ReadContext& context, const Node& node, const std::string& path, std::size_t row) {
    const Node::Entry* name = node.find("name");
    const std::string shown = name != nullptr && name->value.is_text() ? name->value.text : fmt::format("{}", row + 1);
    const Node::Entry* verb = node.find("do");
    std::vector<std::string> patterns{"stage"};
    const auto words = names::words_of(names::verbs);
    const auto known = verb != nullptr ? std::find(words.begin(), words.end(), verb->value.text) : words.end();
    if (known != words.end()) {
        patterns.insert(patterns.begin(), "stage." + *known);
    }
    Reader v(context, node, node.place, patterns, path + ".stage." + shown);
    Stage stage;
    v.field("name", stage.name);
    if (const Node* given = v.take("do")) {
        v.find_word("do", *given, words);
    }
    if (known == words.end()) {
        return std::nullopt; // whose keys these are is not known
    }
    stage.spec = default_spec(static_cast<std::size_t>(known - words.begin()));
    stage_fields(v, stage);
    std::visit([&](auto& spec) { fields(v, spec); }, stage.spec);
    v.finish();
    if (name != nullptr) {
        check_stage_name(context, stage.name, name->value.place);
    }
    check_measures(context, stage, node);
    return stage;
}

bool makes_sample(const Stage& stage) {
    return traits_of(stage).makes_sample();
}

bool leaves_state(const Stage& stage) {
    return stage.restore || traits_of(stage).only_looks;
}

/// The row of the stage of this name; -1 where there is none.
int row_of(const std::vector<Stage>& stages, const std::string& name) {
    const auto found = std::ranges::find(stages, name, &Stage::name);
    return found == stages.end() ? -1 : static_cast<int>(found - stages.begin());
}

void check_from(ReadContext& context, std::vector<Stage>& stages, std::size_t k, const StageNodes& at) {
    Stage& stage = stages[k];
    const int row = row_of(stages, stage.from);
    if (makes_sample(stage)) {
        context.problems.error(
            "E207", at.place_of(k, "from"),
            fmt::format("stage \"{}\" makes its own sample and starts from nothing", stage.name), "leave `from` out"
        );
    } else if (row < 0) {
        const std::vector<std::string> names = names_of(stages);
        const auto nearest = nearest_word(stage.from, names);
        context.problems.error(
            "E401", at.place_of(k, "from"),
            fmt::format("stage \"{}\" starts from \"{}\", which is no stage of this study", stage.name, stage.from),
            nearest ? fmt::format("a stage with a similar name exists: \"{}\"", *nearest)
                    : fmt::format("known are {}", fmt::join(names, ", "))
        );
    } else if (static_cast<std::size_t>(row) >= k) {
        context.problems.error(
            "E403", at.place_of(k, "from"),
            fmt::format("stage \"{}\" starts from \"{}\", which does not come before it", stage.name, stage.from),
            "stages run in the order of the file: move it down"
        );
    } else {
        stage.parent = row;
    }
}

/// Finds the parent of each stage; reports stages without a start.
void link_stages(ReadContext& context, std::vector<Stage>& stages, const StageNodes& at) {
    for (std::size_t k = 0; k < stages.size(); ++k) {
        Stage& stage = stages[k];
        const bool names_start = at.nodes[k]->find("from") != nullptr; // an empty name is none of a stage's
        if (names_start) {
            check_from(context, stages, k, at);
        } else if (!makes_sample(stage) && k > 0) {
            const Stage& before = stages[k - 1];
            stage.parent = leaves_state(before) ? before.parent : static_cast<int>(k) - 1;
        }
        if (!names_start && !makes_sample(stage) && stage.parent < 0) {
            context.problems.error(
                "E403", at.place_of(k, "name"), fmt::format("stage \"{}\" has nothing to start from", stage.name),
                "begin a study with do = \"pack\" or do = \"import\""
            );
        }
    }
}

/// Reports names that are used twice, also those of stages that could not be read.
void check_stage_names(ReadContext& context, const std::vector<Node>& stages) {
    std::vector<std::string> known;
    for (const Node& stage : stages) {
        const Node::Entry* name = stage.find("name");
        if (name == nullptr || !name->value.is_text()) {
            continue;
        }
        if (std::find(known.begin(), known.end(), name->value.text) != known.end()) {
            context.problems.error(
                "E204", name->value.place, fmt::format("two stages of this study are named \"{}\"", name->value.text),
                "give each stage its own name"
            );
        }
        known.push_back(name->value.text);
    }
}

} // namespace

StageSpec default_spec(std::size_t verb) {
    return make_spec(verb, std::make_index_sequence<std::variant_size_v<StageSpec>>{});
}

std::vector<std::string> names_of(const std::vector<Stage>& stages) {
    std::vector<std::string> names;
    for (const Stage& stage : stages) {
        names.push_back(stage.name);
    }
    return names;
}

std::vector<Stage> read_stages(ReadContext& context, Reader& v) {
    const Node* node = v.take("stage");
    const bool is_list = node != nullptr && node->is_array() && !node->items.empty();
    if (!is_list) {
        v.error(
            "E201", v.place(), fmt::format("{} has no stages", v.title()),
            "begin with a [[" + v.path() + ".stage]] that does \"pack\" or \"import\""
        );
        return {};
    }
    std::vector<Stage> stages;
    StageNodes at;
    bool is_whole = true;
    for (std::size_t k = 0; k < node->items.size(); ++k) {
        const Node& item = node->items[k];
        if (!item.is_table()) {
            v.wrong_type("stage", item, "tables, [[" + v.path() + ".stage]]");
            is_whole = false;
            continue;
        }
        if (auto stage = read_stage(context, item, v.path(), k)) {
            stages.push_back(std::move(*stage));
            at.nodes.push_back(&item);
        } else {
            is_whole = false;
        }
    }
    check_stage_names(context, node->items);
    // With a stage missing, what the others start from would be guesswork.
    if (is_whole) {
        link_stages(context, stages, at);
    }
    return stages;
}

Node write_stage(const Stage& stage) {
    Writer v({"stage." + verb_of(stage.spec), "stage"});
    v.field("name", stage.name);
    v.field("do", verb_of(stage.spec));
    Stage copy = stage;
    stage_fields(v, copy);
    std::visit([&](auto& spec) { fields(v, spec); }, copy.spec);
    return v.node();
}

const triaxial::TriaxialSpec* laboratory_test(const StageSpec& spec) {
    return std::visit(
        [](const auto& of) -> const triaxial::TriaxialSpec* {
            if constexpr (std::is_base_of_v<triaxial::TriaxialSpec, std::decay_t<decltype(of)>>) {
                return &of;
            }
            return nullptr;
        },
        spec
    );
}

std::string verb_of(const StageSpec& spec) {
    return std::string(traits_of(spec).verb);
}

} // namespace suffuse::casefile
