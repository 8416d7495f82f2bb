#include "suffuse/casefile/overrides.hpp"

#include "suffuse/base/read_text.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/casefile/read_toml.hpp"
#include "suffuse/casefile/schema.hpp"
#include "suffuse/casefile/stage_traits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace suffuse::casefile {

namespace {

std::vector<std::string> split_path(const std::string& text) {
    std::vector<std::string> parts{""};
    for (const char c : text) {
        if (c == '.') {
            parts.emplace_back();
        } else if (c != ' ') {
            parts.back() += c;
        }
    }
    return parts;
}

/// The path of an override, in which a key of a sweep is one part with its dots: study.NAME.sweep.stage.NAME.KEY
std::vector<std::string> override_path(const std::string& text) {
    std::vector<std::string> path = split_path(text.substr(0, text.find('=')));
    if (path.size() > 4 && path[0] == "study" && (path[2] == "sweep" || path[2] == "rows")) {
        path[3] = fmt::format("{}", fmt::join(path.begin() + 3, path.end(), "."));
        path.resize(4);
    }
    return path;
}

Place place_of_key(const std::string& text) {
    const std::size_t size = std::max<std::size_t>(1, std::min(text.find('='), text.size()));
    return {std::make_shared<Source>(Source{"--set", text}), 1, 1, static_cast<int>(size)};
}

std::string text_of(const Node& table, std::string_view key) {
    const Node::Entry* entry = table.find(key);
    return entry != nullptr && entry->value.is_text() ? entry->value.text : "";
}

template <class Visit>
void for_each_study(Node& root, Visit visit) {
    Node::Entry* studies = root.find("study");
    if (studies == nullptr) {
        return;
    }
    for (Node::Entry& study : studies->value.entries) {
        if (study.value.is_table()) {
            visit(study.value);
        }
    }
}

template <class Visit>
void for_each_stage(Node& root, const std::vector<std::string>& verbs, Visit visit) {
    for_each_study(root, [&](Node& study) {
        Node::Entry* stages = study.find("stage");
        if (stages == nullptr) {
            return;
        }
        for (Node& stage : stages->value.items) {
            const std::string verb = text_of(stage, "do");
            if (std::find(verbs.begin(), verbs.end(), verb) != verbs.end()) {
                visit(stage);
            }
        }
    });
}

struct NamedStudy {
    std::string name;
    Place place; ///< of the name
};

/// Takes out all other studies; none where no name is given.
void keep_named(Node& root, const std::vector<NamedStudy>& names, Problems& problems) {
    Node::Entry* studies = root.find("study");
    if (names.empty() || studies == nullptr || !studies->value.is_table()) {
        return;
    }
    std::vector<Node::Entry>& entries = studies->value.entries;
    std::vector<std::string> known;
    std::ranges::transform(entries, std::back_inserter(known), &Node::Entry::key);
    for (const NamedStudy& named : names) {
        if (std::ranges::find(known, named.name) == known.end()) {
            problems.error(
                "E408", named.place, fmt::format("there is no study \"{}\"", named.name),
                fmt::format("known are {}", fmt::join(known, ", "))
            );
        }
    }
    std::erase_if(entries, [&](const Node::Entry& study) {
        return std::ranges::find(names, study.key, &NamedStudy::name) == names.end();
    });
}

/// What is no text is reported where the presets are read.
void keep_studies_of_preset(Node& root, const Node& value, Problems& problems) {
    std::vector<NamedStudy> wanted;
    for (const Node& item : value.items) {
        if (item.is_text()) {
            wanted.push_back({item.text, item.place});
        }
    }
    keep_named(root, wanted, problems);
}

/// @param weighs fines have weight, and keys of probes without it have no meaning
void apply_preset_key(Node& root, const Node::Entry& entry, bool weighs) {
    const std::string& key = entry.key;
    const auto set = [&](Node& table, std::string_view name) { table.set(name, entry.value, entry.place); };
    const auto set_in_stages = [&](const std::vector<std::string>& verbs, std::string_view name) {
        for_each_stage(root, verbs, [&](Node& stage) { set(stage, name); });
    };
    if (key == "particles") {
        // A study that imports its grains has as many as its file.
        for_each_study(root, [&](Node& study) {
            if (study.find("particles") != nullptr) {
                set(study, key);
            }
        });
    } else if (key == "coarse_grains" || key == "at_least") {
        for_each_study(root, [&](Node& study) {
            Node::Entry* size = study.find("sample_size");
            if (size != nullptr && size->value.is_table()) {
                set(size->value, key);
            }
        });
    } else if (key == "replicates") {
        for_each_study(root, [&](Node& study) { set(study, key); });
    } else if (key == "fines_content") {
        for_each_study(root, [&](Node& study) {
            Node::Entry* sweep = study.find("sweep");
            if (sweep != nullptr && sweep->value.find(key) != nullptr) {
                set(sweep->value, key);
            }
        });
    } else if (key == "inertial_number") {
        set_in_stages({"triaxial"}, key);
    } else if (key == "triaxial_strain") {
        set_in_stages({"triaxial"}, "strain");
    } else if (key == "passes") {
        set_in_stages({"erode"}, key);
    } else if (key == "gradients") {
        set_in_stages({"detach"}, key);
    } else if (key == "hold_at_most") {
        set_in_stages({"migrate"}, key);
    } else if (key == "max_rate") {
        set_in_stages({"compact"}, key);
    } else if (key == "unbalanced_force" || key == "stress_error" || key == "patience") {
        if (root.find("balance") == nullptr) {
            root.set("balance", Node{}, entry.place);
        }
        set(root.find("balance")->value, key);
    } else if (find_key("presets.*", key) != nullptr && !weighs) { // of probes without weight
        std::vector<std::string> probing;
        for (const StageTraits& traits : stage_traits) {
            if (traits.probes_fines()) {
                probing.emplace_back(traits.verb);
            }
        }
        set_in_stages(probing, key);
    }
}

} // namespace

void apply_preset(Node& root, const std::string& name, const Place& preset_place, bool weighs, Problems& problems) {
    const Node::Entry* presets = root.find("presets");
    const Node::Entry* preset = presets != nullptr ? presets->value.find(name) : nullptr;
    if (preset == nullptr) {
        if (name == "standard") {
            return;
        }
        std::vector<std::string> known{"standard"};
        for (const Node::Entry& entry : presets != nullptr ? presets->value.entries : std::vector<Node::Entry>{}) {
            if (entry.key != "standard") {
                known.push_back(entry.key);
            }
        }
        problems.error(
            "E404", preset_place, fmt::format("there is no preset \"{}\"", name),
            fmt::format("known are {}", fmt::join(known, ", "))
        );
        return;
    }
    if (!preset->value.is_table()) {
        return;
    } // reported where the presets are read
    const std::vector<Node::Entry> entries = preset->value.entries;
    for (const Node::Entry& entry : entries) {
        if (entry.key == "studies") {
            keep_studies_of_preset(root, entry.value, problems);
        } else {
            apply_preset_key(root, entry, weighs);
        }
    }
}

void keep_studies(Node& root, const std::vector<std::string>& names, Problems& problems) {
    std::vector<NamedStudy> wanted;
    wanted.reserve(names.size());
    for (const std::string& name : names) {
        wanted.push_back(
            {name, {std::make_shared<Source>(Source{"--study", name}), 1, 1, static_cast<int>(name.size())}}
        );
    }
    keep_named(root, wanted, problems);
}

std::optional<std::string>
set_at(Node& table, const std::vector<std::string>& path, const Node& value, const Place& place) {
    Node* node = &table;
    for (std::size_t k = 0; k + 1 < path.size(); ++k) {
        Node::Entry* entry = node->find(path[k]);
        if (entry == nullptr) {
            // Named things must be there; a table of settings may be left out in the file.
            if (k == 1 && (path[0] == "study" || path[0] == "soil")) {
                std::vector<std::string> names;
                for (const Node::Entry& known : node->entries) {
                    names.push_back(known.key);
                }
                return fmt::format("there is no {} \"{}\"; known are {}", path[0], path[1], fmt::join(names, ", "));
            }
            node->set(path[k], Node{}, place);
            entry = node->find(path[k]);
            entry->value.place = place;
        }
        node = &entry->value;
        if (node->is_array() && path[k] == "stage" && k + 2 < path.size()) {
            const auto stage = std::find_if(node->items.begin(), node->items.end(), [&](const Node& item) {
                return text_of(item, "name") == path[k + 1];
            });
            if (stage == node->items.end()) {
                return fmt::format("there is no stage \"{}\"", path[k + 1]);
            }
            node = &*stage;
            ++k;
        }
        if (!node->is_table()) {
            return fmt::format("`{}` is not a table and has no `{}`", path[k], path[k + 1]);
        }
    }
    node->set(path.back(), value, place);
    return std::nullopt;
}

void apply_override(Node& root, const std::string& text, Problems& problems) {
    const Place whole = place_of_key(text);
    if (!check_encoding(whole.source, problems)) {
        return;
    }
    const std::size_t mark = text.find('=');
    const std::vector<std::string> path = override_path(text);
    const bool has_gap = std::find(path.begin(), path.end(), "") != path.end();
    if (mark == std::string::npos || has_gap) {
        problems.error("E405", whole, "--set needs KEY=VALUE", "as in --set study.erosion.particles=4000");
        return;
    }
    // The value as TOML; what is no TOML is a text, so that nobody needs quotes within quotes: --set soil.a.psd=b.csv
    Problems ignored;
    const std::string written = text.substr(mark + 1);
    const auto parsed = read_toml(std::make_shared<Source>(Source{"--set", "v = " + written}), ignored);
    const bool is_one = parsed && parsed->entries.size() == 1;
    Node value = is_one ? parsed->entries[0].value : make_node(Scalar(written));
    const Place place{
        whole.source, 1, static_cast<int>(mark) + 2, static_cast<int>(std::max<std::size_t>(1, written.size()))};
    const auto put_place = [&](auto& self, Node& node) -> void {
        node.place = place;
        for (Node& item : node.items) {
            self(self, item);
        }
        for (Node::Entry& entry : node.entries) {
            entry.place = place;
            self(self, entry.value);
        }
    };
    put_place(put_place, value);
    if (const auto problem = set_at(root, path, value, whole)) {
        problems.error(
            "E405", whole, *problem,
            "--set KEY=VALUE takes the path of a key, as in study.erosion.stage.probe.watch=4000"
        );
    }
}

bool sets_gravity(const std::string& text) {
    return split_path(text.substr(0, text.find('='))).front() == "gravity";
}

bool sets_preset(const std::string& text) {
    const std::string first = split_path(text.substr(0, text.find('='))).front();
    return first == "preset" || first == "presets";
}

void check_preset_override(const std::string& text, const std::string& in_force, Problems& problems) {
    const std::vector<std::string> path = override_path(text);
    if (text.find('=') == std::string::npos || path.size() < 2 || path[1] == in_force) {
        return;
    }
    problems.error(
        "E405", place_of_key(text),
        fmt::format("the preset in force is \"{}\", so \"{}\" has no effect", in_force, path[1]),
        fmt::format(
            "add --preset {}, or set presets.{}.{}, or the intended key, as in study.erosion.particles", path[1],
            in_force, path.back()
        )
    );
}

namespace {

bool sweeps_over(const Node& study, const std::string& key) {
    return std::ranges::any_of(std::array{"sweep", "rows"}, [&](const char* name) {
        const Node::Entry* const swept = study.find(name);
        return swept != nullptr && swept->value.is_table() && swept->value.find(key) != nullptr;
    });
}

/// Names under which a study can sweep what an override sets; none where it is of another study or soil.
std::vector<std::string>
names_in_sweep(const std::vector<std::string>& path, const std::string& study, const std::string& soil) {
    const auto from = [&](std::ptrdiff_t first) {
        return fmt::format("{}", fmt::join(path.begin() + first, path.end(), "."));
    };
    if (path[0] == "contact" || path == std::vector<std::string>{"seed"}) {
        return {from(0)};
    }
    if (path.size() < 3 || path[1] != (path[0] == "study" ? study : soil)) {
        return {};
    }
    return path[0] == "study"  ? std::vector{from(2)}
           : path[0] == "soil" ? std::vector{from(2), path.back()}
                               : std::vector<std::string>{};
}

} // namespace

void check_swept_override(const Node& root, const std::string& text, Problems& problems) {
    const std::vector<std::string> path = override_path(text);
    const Node::Entry* const studies = root.find("study");
    if (studies == nullptr) {
        return;
    }
    std::string sweeping, key;
    for (const Node::Entry& study : studies->value.entries) {
        const std::vector<std::string> names = names_in_sweep(path, study.key, text_of(study.value, "soil"));
        const auto swept =
            std::ranges::find_if(names, [&](const std::string& name) { return sweeps_over(study.value, name); });
        if (!names.empty() && swept == names.end()) {
            return; // this study takes the value
        }
        if (!names.empty()) {
            sweeping = study.key, key = *swept;
        }
    }
    if (!sweeping.empty()) {
        problems.error(
            "E405", place_of_key(text),
            fmt::format("the study \"{}\" has values of its own for `{}`, so this one has no effect", sweeping, key),
            fmt::format("set the list instead, as in --set 'study.{}.sweep.{}=[VALUE, VALUE]'", sweeping, key)
        );
    }
}

bool apply_sweep_value(SweepTarget target, const std::string& key, const Node& value) {
    if (key == "seed") { // list_variants has taken it
        return value.kind == Node::Kind::Integer && value.integer >= 0;
    }
    if (key == "particles" || key == "soil") {
        target.study.set(key, value, value.place);
        return true;
    }
    const std::vector<std::string> path = split_path(key);
    if (path.size() > 2 && path[0] == "stage") {
        return !set_at(target.study, path, value, value.place);
    }
    if (path.size() > 1 && path[0] == "contact") {
        return !set_at(target.contact, {path.begin() + 1, path.end()}, value, value.place);
    }
    if (target.soil == nullptr) {
        return false;
    }
    if (key == "finer_than" || key == "fines.finer_than") {
        return !set_at(*target.soil, {"fines", "finer_than"}, value, value.place);
    }
    for (const char* const name : {"size_ratio", "coarse_width", "fines_width"}) {
        if (key == name || key == std::string("surrogate.") + name) {
            return !set_at(*target.soil, {"surrogate", name}, value, value.place);
        }
    }
    const Key* soil_key = find_key("soil.*", key);
    if (soil_key == nullptr || soil_key->kind != ValueKind::Ratio) {
        return false;
    }
    target.soil->set(key, value, value.place);
    return true;
}

} // namespace suffuse::casefile
