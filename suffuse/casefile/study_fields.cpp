#include "suffuse/casefile/study_fields.hpp"

#include "suffuse/casefile/check_name.hpp"
#include "suffuse/casefile/fields.hpp"
#include "suffuse/casefile/overrides.hpp"
#include "suffuse/casefile/physics_checks.hpp"
#include "suffuse/casefile/prepared_as.hpp"
#include "suffuse/casefile/row_fields.hpp"
#include "suffuse/casefile/sample_checks.hpp"
#include "suffuse/casefile/soil_fields.hpp"
#include "suffuse/casefile/stage_list.hpp"
#include "suffuse/casefile/stage_traits.hpp"
#include "suffuse/casefile/sweep_value.hpp"
#include "suffuse/casefile/variants.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace suffuse::casefile {

namespace {

constexpr std::size_t most_variants = 10'000;

template <class V>
void fields(V& v, Refine& refine) {
    v.field("key", refine.key);
    v.choice("around", refine.maximum, names::extreme);
    v.field("of", refine.of);
    v.field("at", refine.at);
    v.field("add", refine.add);
}

template <class V>
void fields(V& v, grains::SampleSizeSpec& size) {
    v.field("coarse_grains", size.coarse_grains);
    v.field("cell_width", size.cell_width);
    v.field("at_least", size.at_least);
    v.field("at_most", size.at_most);
    v.field("least_coarse", size.least_coarse);
}

/// A study that packs has one of `particles` and `sample_size`, the latter with a soil of two fractions.
void check_size_keys(Reader& v, const StudySurroundings& around, const Study& study, bool packs) {
    if (v.has("particles") && v.has("sample_size")) {
        v.error(
            "E207", v.context().places[v.path() + ".sample_size"],
            fmt::format("{} has both `particles` and `sample_size`", v.title()), "keep one of them"
        );
    } else if (packs && !v.has("particles") && !v.has("sample_size")) {
        v.error(
            "E201", v.place(), fmt::format("{} packs grains and needs `particles`", v.title()),
            "the number of grains, as in particles = 10_000; or, for a soil of two fractions, sample_size = "
            "{ coarse_grains = 200 }"
        );
    }
    const auto soil = around.settings.soils.find(study.soil);
    if (study.sample_size && soil != around.settings.soils.end() && soil->second.whole) {
        v.error(
            "E207", v.context().places[v.path() + ".sample_size"],
            fmt::format("`sample_size` counts coarse grains, and soil \"{}\" has one grading for all", study.soil),
            "give `particles`, or a soil with `coarse`, `fines` and `fines_content`"
        );
    }
}

void check_refine(ReadContext& context, const Study& study, const std::string& path) {
    if (!study.refine || (study.refine->key.empty() && context.problems.has_errors())) {
        return; // none, or one that could not be read
    }
    const Refine& refine = *study.refine;
    const auto sweep =
        std::find_if(study.sweep.begin(), study.sweep.end(), [&](const Sweep& s) { return s.key == refine.key; });
    if (sweep == study.sweep.end()) {
        context.problems.error(
            "E406", context.places[path + ".refine.key"], fmt::format("`{}` is not swept", refine.key),
            "name a key of `sweep`"
        );
    } else if (!std::all_of(sweep->values.begin(), sweep->values.end(), quantity_of)) {
        context.problems.error(
            "E406", context.places[path + ".refine.key"],
            fmt::format("the sweep over `{}` cannot be refined", refine.key),
            "its values are quantities or numbers, not words"
        );
    }
    const std::vector<std::string> names = names_of(study.stages);
    for (const std::string& name : refine.at) {
        if (std::ranges::find(names, name) == names.end()) {
            context.problems.error(
                "E401", context.places[path + ".refine.at"],
                fmt::format("`refine` looks at \"{}\", which is no stage of this study", name),
                fmt::format("known are {}", fmt::join(names, ", "))
            );
        }
    }
}

/// A value is known by its folder: two that are written alike there would take each other's results for their own. Two
/// that are equal would count twice.
void check_folders(ReadContext& context, const Study& study, const Node& node) {
    for (const Sweep& sweep : study.sweep) {
        std::map<std::string, std::string> taken; // folder -> value
        for (auto at = sweep.values.begin(); at != sweep.values.end(); ++at) {
            const Scalar& value = *at;
            const std::string text = print_value(make_node(value)), folder = folder_of(sweep.key, value);
            const auto [known, is_new] = taken.emplace(folder, text);
            const auto same =
                std::find_if(sweep.values.begin(), at, [&](const Scalar& other) { return same_value(other, value); });
            if (!is_new || same != at) {
                context.problems.error(
                    "E204", place_in_sweep(node.find("sweep")->value.find(sweep.key)->value, value),
                    is_new
                        ? fmt::format("{} and {} of `{}` are the same", print_value(make_node(*same)), text, sweep.key)
                        : fmt::format(
                              "{} and {} of `{}` would share the folder {}", known->second, text, sweep.key, folder
                          ),
                    is_new ? "keep one of them" : "keep one of them, or values that differ in their first six digits"
                );
            }
        }
    }
}

/// A stage runs for values that are swept. A preset or --set may have left some of them out of the sweep, so that a
/// value which is not there need not be a mistake.
void check_only(ReadContext& context, const Study& study, const std::string& path) {
    constexpr std::size_t most_shown = 10;
    if (context.problems.has_errors()) {
        return; // the sweep or a file of rows may be what could not be read
    }
    std::map<std::string, std::vector<Scalar>> swept; // of `sweep` and of `rows`
    for (const std::vector<Sweep>* const sweeps : {&study.sweep, &study.rows}) {
        for (const Sweep& sweep : *sweeps) {
            swept[sweep.key] = sweep.values;
        }
    }
    std::vector<std::string> keys;
    std::ranges::transform(swept, std::back_inserter(keys), [](const auto& entry) { return "`" + entry.first + "`"; });
    for (const Stage& stage : study.stages) {
        const Place place = context.places[fmt::format("{}.stage.{}.only", path, stage.name)];
        for (const Sweep& only : stage.only) {
            const auto known = swept.find(only.key);
            if (known == swept.end()) {
                context.problems.error(
                    "E409", place,
                    fmt::format(
                        "stage \"{}\" would never run: it is for values of `{}`, which is not swept", stage.name,
                        only.key
                    ),
                    keys.empty()
                        ? "leave `only` out: this study sweeps nothing"
                        : fmt::format("leave `only` out, or name a key of the sweep: {}", fmt::join(keys, ", "))
                );
                continue;
            }
            const auto printed = [](const Scalar& value) { return print_value(make_node(value)); };
            for (const Scalar& value : only.values) {
                if (std::ranges::any_of(known->second, [&](const Scalar& one) { return same_value(one, value); })) {
                    continue;
                }
                std::vector<std::string> values;
                std::ranges::transform(known->second, std::back_inserter(values), printed);
                if (values.size() > most_shown) {
                    values.resize(most_shown);
                    values.emplace_back("...");
                }
                context.problems.warning(
                    "W409", place,
                    fmt::format(
                        "stage \"{}\" is for {} of `{}`, which is not swept", stage.name, printed(value), only.key
                    ),
                    fmt::format("take values of the sweep: {}", fmt::join(values, ", "))
                );
            }
        }
    }
}

bool is_swept(const Study& study, std::string_view key) {
    const auto is_key = [&](const Sweep& sweep) { return sweep.key == key; };
    return std::ranges::any_of(study.sweep, is_key) || std::ranges::any_of(study.rows, is_key);
}

/// The study and its soil as one variant has them.
void read_body(ReadContext& context, const StudySurroundings& around, Reader& v, Study& study) {
    v.field("soil", study.soil);
    v.field("particles", study.particles);
    v.table("sample_size", study.sample_size, [](Reader& inner, grains::SampleSizeSpec& s) { fields(inner, s); });
    sweep_field(v, "sweep", study.sweep);
    rows_field(v, study);
    v.table("refine", study.refine, [](Reader& inner, Refine& refine) { fields(inner, refine); });
    v.field("replicates", study.replicates);
    study.stages = read_stages(context, v);
    v.finish();
    if (!study.soil.empty() && !around.settings.soils.contains(study.soil)) {
        std::vector<std::string> known;
        for (const auto& [name, soil] : around.settings.soils) {
            known.push_back(name);
        }
        v.error(
            "E402", context.places[v.path() + ".soil"], fmt::format("there is no soil \"{}\"", study.soil),
            known.empty() ? fmt::format("add a table [soil.{}]", study.soil)
                          : fmt::format("known are {}", fmt::join(known, ", "))
        );
    }
    const bool packs = std::ranges::any_of(study.stages, packs_one_soil);
    const bool stacks = !packs && std::ranges::any_of(study.stages, [](const Stage& stage) {
        return traits_of(stage).origin == Origin::Soil;
    });
    for (const char* key : {"soil", "particles", "sample_size"}) {
        if (stacks && v.has(key)) {
            v.error(
                "E207", context.places[fmt::format("{}.{}", v.path(), key)],
                fmt::format("{} packs layers, and gives `{}`", v.title(), key),
                "leave it out: each layer names its soil, and has as many grains as its thickness holds"
            );
        }
    }
    if (packs && study.soil.empty() && !is_swept(study, "soil")) {
        v.error(
            "E201", v.place(), fmt::format("{} packs grains and needs `soil`", v.title()),
            "the name of a [soil.NAME] table, or several in `sweep`"
        );
    }
    check_size_keys(v, around, study, packs);
}

/// The contact law of one variant: the case's, with what is swept.
void read_contact(ReadContext& context, const StudySurroundings& around, const Node& contact, Variant& variant) {
    variant.material = around.settings.material;
    variant.damping = around.settings.damping;
    Reader v(context, contact, contact.place, {"contact"}, "contact");
    contact_fields(v, variant.material, variant.damping);
    v.finish();
}

/// One copy of the study: the tree with its sweep values set, read again.
void read_variant(
    ReadContext& context, const StudySurroundings& around, const Node::Entry& entry, Study& study, Variant variant
) {
    Node study_node = entry.value;
    const Node::Entry* soil_entry = around.soils != nullptr ? around.soils->find(study.soil) : nullptr;
    if (const auto swept = variant.values.find("soil"); swept != variant.values.end() && around.soils != nullptr) {
        if (const auto* name = std::get_if<std::string>(&swept->second)) {
            soil_entry = around.soils->find(*name);
        }
    }
    std::optional<Node> soil_node;
    if (soil_entry != nullptr && soil_entry->value.is_table()) {
        soil_node = soil_entry->value;
    }
    Node contact_node = around.contact != nullptr ? *around.contact : Node{};
    const Node& sweeps = study_node.find("sweep") != nullptr ? entry.value.find("sweep")->value : entry.value;
    for (const auto& [key, value] : variant.values) {
        if (key == row_key && !study.rows.empty()) {
            continue; // its values are here
        }
        const Node::Entry* list = sweeps.find(key);
        list = list == nullptr ? entry.value.find("rows") : list;
        Node node = make_node(value);
        node.place = place_in_sweep(list->value, value);
        if (!apply_sweep_value({study_node, soil_node ? &*soil_node : nullptr, contact_node}, key, node)) {
            context.problems.error(
                "E203", list->place,
                fmt::format("`{}` cannot be swept: study, soil and contact law have no such key", key),
                "sweep `particles`, a key of the soil such as `fines_content`, \"stage.NAME.KEY\" or "
                "\"contact.KEY\""
            );
            return;
        }
    }
    const std::string path = "study." + entry.key;
    Study copy;
    Reader v(context, study_node, entry.place, {"study.*"}, path);
    read_body(context, around, v, copy);
    if (soil_node) {
        variant.soil = read_soil(context, *soil_node, soil_entry->place, "soil." + soil_entry->key);
    }
    read_contact(context, around, contact_node, variant);
    variant.soil_name = copy.soil;
    variant.particles = copy.particles;
    if (copy.sample_size && variant.soil && variant.soil->coarse && variant.soil->fines) {
        const grains::SampleSize size = grains::size_sample(*variant.soil, *copy.sample_size);
        variant.particles = size.particles;
        variant.sized_by = size.rule;
    }
    variant.stages = chosen_stages(copy.stages, variant.values);
    check_layers(context, around.settings, variant, path);
    check_physics(context, around.settings, study, variant);
    study.variants.push_back(std::move(variant));
}

} // namespace

Study read_study(ReadContext& context, const StudySurroundings& around, const Node::Entry& entry) {
    Study study;
    study.name = entry.key;
    check_name(context, "study", entry.key, entry.place);
    Reader v(context, entry.value, entry.place, {"study.*"}, "study." + entry.key);
    read_body(context, around, v, study);
    check_refine(context, study, v.path());
    check_only(context, study, v.path());
    check_folders(context, study, entry.value);
    const auto count = count_variants(study);
    if (count > most_variants) {
        v.error(
            "E312", context.places[v.path() + ".sweep"],
            fmt::format("the sweeps and replicates of this study make {} copies", count),
            fmt::format("at most {} are made", most_variants)
        );
        return study;
    }
    for (Variant& variant : list_variants(study, around.settings.seed)) {
        read_variant(context, around, entry, study, std::move(variant));
    }
    check_sample_sizes(context, study);
    check_prepared_as(context, study);
    return study;
}

namespace {

/// A settling's pressure is written as stresses; where it is swept it stays a pressure, which the values replace.
void keep_swept_pressure(Node& stage, const std::string& name, const Study& study) {
    for (const std::vector<Sweep>* const sweeps : {&study.sweep, &study.rows}) {
        const auto swept = std::ranges::find(*sweeps, fmt::format("stage.{}.pressure", name), &Sweep::key);
        if (swept != sweeps->end() && stage.find("stress") != nullptr) {
            std::erase_if(stage.entries, [](const Node::Entry& entry) { return entry.key == "stress"; });
            stage.set("pressure", make_node(swept->values.front()));
        }
    }
}

} // namespace

Node write_study(const Study& study) {
    Writer v({"study.*"});
    v.field("soil", study.soil);
    if (study.particles > 0) {
        v.field("particles", study.particles);
    }
    std::optional<grains::SampleSizeSpec> size = study.sample_size;
    v.table("sample_size", size, [](Writer& inner, grains::SampleSizeSpec& value) { fields(inner, value); });
    sweep_field(v, "sweep", study.sweep);
    rows_field(v, study);
    std::optional<Refine> refine = study.refine;
    v.table("refine", refine, [](Writer& inner, Refine& value) { fields(inner, value); });
    v.field("replicates", study.replicates);
    std::vector<Node> stages;
    for (const Stage& stage : study.stages) {
        stages.push_back(write_stage(stage));
        keep_swept_pressure(stages.back(), stage.name, study);
    }
    v.set("stage", make_array(std::move(stages)));
    return v.node();
}

} // namespace suffuse::casefile
