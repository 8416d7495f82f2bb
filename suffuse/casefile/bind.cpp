#include "suffuse/casefile/bind.hpp"

#include "suffuse/casefile/calibrate_fields.hpp"
#include "suffuse/casefile/check_name.hpp"
#include "suffuse/casefile/fields.hpp"
#include "suffuse/casefile/soil_fields.hpp"
#include "suffuse/casefile/study_fields.hpp"

#include <fmt/format.h>

namespace suffuse::casefile {

namespace {

/// Reads a table of settings that may be missing.
template <class Body>
void read_table(ReadContext& context, const Node& root, const std::string& name, Body body) {
    const Node::Entry* entry = root.find(name);
    if (entry == nullptr) {
        return;
    }
    if (!entry->value.is_table()) {
        context.problems.error(
            "E205", entry->value.place, fmt::format("`{}` needs a table, and this is a value", name),
            fmt::format("write [{}] on a line of its own", name)
        );
        return;
    }
    Reader v(context, entry->value, entry->place, {name}, name);
    body(v);
    v.finish();
}

/// Calls `visit(entry)` for each [group.NAME].
template <class Visit>
void for_each_member(ReadContext& context, const Node& root, const std::string& group, Visit visit) {
    const Node::Entry* entry = root.find(group);
    if (entry == nullptr) {
        return;
    }
    const std::string form = fmt::format("write [{}.NAME] on a line of its own", group);
    if (!entry->value.is_table()) {
        context.problems.error(
            "E205", entry->value.place, fmt::format("`{}` needs named tables, and this is a value", group), form
        );
        return;
    }
    for (const Node::Entry& member : entry->value.entries) {
        if (member.value.is_table()) {
            visit(member);
        } else {
            context.problems.error(
                "E205", member.place, fmt::format("[{}] holds named tables, and `{}` is a value", group, member.key),
                form
            );
        }
    }
}

void check_preset(ReadContext& context, const Node::Entry& entry) {
    check_name(context, "preset", entry.key, entry.place);
    Reader v(context, entry.value, entry.place, {"presets.*"}, "presets." + entry.key);
    for (const Key& key : schema()) {
        if (key.table != "presets.*" || !v.has(key.name)) {
            continue;
        }
        double ratio = 0;
        std::int64_t count = 0;
        std::vector<double> ratios;
        std::vector<std::string> names;
        if (key.kind == ValueKind::Text) {
            v.field(key.name, names);
        } else if (key.is_list) {
            v.field(key.name, ratios);
        } else if (key.kind == ValueKind::Count) {
            v.field(key.name, count);
        } else if (key.name == "inertial_number") {
            inertial_number_field(v, ratio);
        } else {
            v.field(key.name, ratio);
        }
    }
    v.finish();
}

void read_top(ReadContext& context, const Node& root, Case& c) {
    Node values = root;
    std::erase_if(values.entries, [](const Node::Entry& entry) {
        constexpr std::array<std::string_view, 11> tables = {"grain",   "contact", "balance",  "fluid",
                                                             "gravity", "soil",    "study",    "output",
                                                             "report",  "presets", "calibrate"};
        return std::find(tables.begin(), tables.end(), entry.key) != tables.end();
    });
    Reader v(context, values, root.place, {""}, "");
    top_fields(v, c);
    std::string ignored;
    v.field("preset", ignored); // applied before
    v.field("applied_preset", ignored);
    v.finish();
}

/// Densities whose unit was mistaken by a thousand pass every other check.
void check_densities(ReadContext& context, const Case& c) {
    constexpr double water = 1000, lightest = 500, heaviest = 2000; // [kg/m3]; of liquids, bromoform is heavier
    const auto warn = [&](const char* key, const std::string& what, const char* usual) {
        const auto found = context.places.find(key);
        context.problems.warning("W622", found == context.places.end() ? Place{} : found->second, what, usual);
    };
    const std::string fluid = print_quantity(c.fluid.density, dimension::density),
                      grains = print_quantity(c.material.density, dimension::density);
    if (c.fluid.density < lightest || c.fluid.density > heaviest) {
        warn(
            "fluid.density", fmt::format("a fluid of {} is no usual liquid", fluid),
            "water is \"1000 kg/m^3\", which is \"1 g/cm^3\""
        );
    }
    if (c.material.density < water) {
        warn(
            "grain.density", fmt::format("grains of {} are lighter than water", grains),
            "quartz is \"2650 kg/m^3\", which is \"2.65 g/cm^3\""
        );
    }
}

/// Grains that do not sink have no weight that could hold them.
void check_sinking(ReadContext& context, const Case& c) {
    if (c.material.density > c.fluid.density) {
        return;
    }
    const auto place = [&](const char* key) {
        const auto found = context.places.find(key);
        return found == context.places.end() ? std::optional<Place>() : found->second;
    };
    context.problems.error(
        "E617", place("grain.density").value_or(place("fluid.density").value_or(Place{})),
        fmt::format(
            "[gravity] gives fines weight, and grains of {} do not sink in a fluid of {}",
            print_quantity(c.material.density, dimension::density), print_quantity(c.fluid.density, dimension::density)
        ),
        "quartz is density = \"2650 kg/m3\", water \"1000 kg/m3\"; without [gravity] the fines have no weight"
    );
}

void read_gravity(ReadContext& context, const Node& root, Case& c) {
    if (root.find("gravity") == nullptr) {
        return;
    }
    c.gravity.emplace();
    read_table(context, root, "gravity", [&](Reader& v) { fields(v, *c.gravity); });
    context.gravity = c.gravity;
    check_sinking(context, c);
}

} // namespace

Case bind_case(const Node& root, const std::string& folder, const std::string& preset, Problems& problems) {
    ReadContext context{problems, folder, {}, {}, root.find("applied_preset") != nullptr, {}};
    Case c;
    c.preset = preset;
    read_top(context, root, c);
    read_table(context, root, "grain", [&](Reader& v) { grain_fields(v, c.material); });
    read_table(context, root, "contact", [&](Reader& v) { contact_fields(v, c.material, c.damping); });
    read_table(context, root, "balance", [&](Reader& v) { fields(v, c.balance); });
    read_table(context, root, "fluid", [&](Reader& v) { fluid_fields(v, c); });
    check_densities(context, c);
    read_gravity(context, root, c);
    read_table(context, root, "output", [&](Reader& v) { fields(v, c.output); });
    read_table(context, root, "report", [&](Reader& v) { fields(v, c.report); });
    for_each_member(context, root, "presets", [&](const Node::Entry& entry) { check_preset(context, entry); });
    for_each_member(context, root, "soil", [&](const Node::Entry& entry) {
        check_name(context, "soil", entry.key, entry.place);
        c.soils[entry.key] = read_soil(context, entry.value, entry.place, "soil." + entry.key);
    });
    const auto tree_at = [&](std::string_view name) {
        const Node::Entry* entry = root.find(name);
        return entry != nullptr && entry->value.is_table() ? &entry->value : nullptr;
    };
    const StudySurroundings around{c, tree_at("soil"), tree_at("contact")};
    for_each_member(context, root, "study", [&](const Node::Entry& entry) {
        c.studies.push_back(read_study(context, around, entry));
    });
    const Node::Entry* calibrate = root.find("calibrate");
    if (calibrate != nullptr) {
        read_calibrate(context, *calibrate);
    }
    if (root.find("study") == nullptr) {
        problems.error(
            "E201", root.place, "the case has no study",
            calibrate != nullptr ? "suffuse calibrate CASE runs the samples of [calibrate]"
                                 : "add a [study.NAME] with its stages; suffuse new DIR writes an example"
        );
    }
    return c;
}

Node tree_of(const Case& c) {
    Case copy = c;
    const auto write = [](const std::string& pattern, auto body) {
        Writer v({pattern});
        body(v);
        return v.node();
    };
    Node root = write("", [&](Writer& v) {
        top_fields(v, copy);
        v.field("applied_preset", copy.preset);
    });
    root.set("grain", write("grain", [&](Writer& v) { grain_fields(v, copy.material); }));
    root.set("contact", write("contact", [&](Writer& v) { contact_fields(v, copy.material, copy.damping); }));
    root.set("balance", write("balance", [&](Writer& v) { fields(v, copy.balance); }));
    root.set("fluid", write("fluid", [&](Writer& v) { fluid_fields(v, copy); }));
    if (copy.gravity) {
        root.set("gravity", write("gravity", [&](Writer& v) { fields(v, *copy.gravity); }));
    }
    Node soils, studies;
    for (const auto& [name, soil] : c.soils) {
        soils.set(name, write_soil(soil));
    }
    for (const Study& study : c.studies) {
        studies.set(study.name, write_study(study));
    }
    if (!c.soils.empty()) {
        root.set("soil", std::move(soils));
    }
    root.set("study", std::move(studies));
    root.set("output", write("output", [&](Writer& v) { fields(v, copy.output); }));
    root.set("report", write("report", [&](Writer& v) { fields(v, copy.report); }));
    return root;
}

std::string resolved_toml(const Case& c) {
    return print_file(tree_of(c));
}

} // namespace suffuse::casefile
