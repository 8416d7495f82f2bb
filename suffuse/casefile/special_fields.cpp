// Special fields of output, imports, thresholds and sweeps.

#include "suffuse/casefile/special_fields.hpp"

#include "suffuse/casefile/names.hpp"
#include "suffuse/contact/springs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <type_traits>

namespace suffuse::casefile {

namespace {

Key over_key(Dimension dimension) {
    Key key;
    key.name = "over";
    key.kind = dimension == dimension::none ? ValueKind::Ratio : ValueKind::Quantity;
    key.dimension = dimension;
    key.range = {0, std::numeric_limits<double>::infinity(), true, false};
    return key;
}

void check_file(Reader& v, const Place& place, const std::string& path) {
    std::error_code failed;
    if (!std::filesystem::is_regular_file(path, failed)) {
        v.error(
            "E501", place,
            fmt::format(
                "there is no file {}{}", path, std::filesystem::is_directory(path, failed) ? ": it is a folder" : ""
            ),
            "paths start at the folder of the case"
        );
    }
}

/// What to do about a key that the law lacks.
std::string advice_without(const contact::Spring& spring, std::string_view key) {
    const auto shears_by = [&](const contact::Spring& other) { return other.words.shear_key == key; };
    if (!contact::laws_where(shears_by).empty()) {
        return std::string(spring.words.shear);
    }
    const auto has_key = [&](const contact::Spring& other) { return has_own(other, key); };
    return fmt::format("leave it out, or take law = \"{}\"", fmt::join(contact::laws_where(has_key), "\" or \""));
}

} // namespace

std::string resolved_path(const std::string& folder, const std::string& path) {
    std::error_code failed; // a path too odd for the system is kept as it is, and reported where it is opened
    const std::filesystem::path joined = std::filesystem::path(folder) / path;
    const std::filesystem::path absolute = std::filesystem::absolute(joined, failed);
    return (failed ? joined : absolute).lexically_normal().string();
}

void snapshot_field(Reader& v, Snapshots& s) {
    const Node* node = v.take("snapshots");
    if (node == nullptr) {
        return;
    }
    if (node->is_table()) {
        Reader inner(v.context(), *node, node->place, {"output.snapshots"}, v.path() + ".snapshots");
        s.when = Snapshots::When::Strain;
        inner.field("every", s.every);
        inner.finish();
    } else if (const auto word = v.find_word("snapshots", *node, names::words_of(names::snapshots))) {
        s.when = names::snapshots[*word].value;
    }
}

void snapshot_field(Writer& v, const Snapshots& s) {
    if (s.when != Snapshots::When::Strain) {
        return v.choice("snapshots", s.when, names::snapshots);
    }
    Node table;
    table.set("every", make_node(Scalar(s.every)));
    v.set("snapshots", std::move(table));
}

void overlay_field(Reader& v, std::map<std::string, std::string>& overlay) {
    const Node* node = v.take("overlay");
    if (node == nullptr) {
        return;
    }
    if (!node->is_table()) {
        return v.wrong_type("overlay", *node, "a table, { figure-2 = \"data/points.csv\" }");
    }
    for (const auto& [figure, place, file] : node->entries) {
        if (const auto path = v.text("overlay", file)) {
            overlay[figure] = resolved_path(v.context().folder, *path);
            if (!v.context().is_resolved) { // a run whose points have gone meanwhile still has its report
                check_file(v, file.place, overlay[figure]);
            }
        }
    }
}

void overlay_field(Writer& v, const std::map<std::string, std::string>& overlay) {
    Node table;
    for (const auto& [figure, path] : overlay) {
        table.set(figure, make_node(Scalar(path)));
    }
    if (!overlay.empty()) {
        v.set("overlay", std::move(table));
    }
}

void packing_field(Reader& v, ImportSpec& s) {
    const Node* node = v.take("packing");
    if (node == nullptr) {
        return;
    }
    s.place = to_string(node->place);
    const auto path = v.text("packing", *node);
    if (!path) {
        return;
    }
    s.path = resolved_path(v.context().folder, *path);
    check_file(v, node->place, s.path);
}

void packing_field(Writer& v, const ImportSpec& s) {
    v.field("packing", s.path);
}

void contacts_field(Reader& v, ImportSpec& s) {
    const Node* node = v.take("contacts");
    const auto path = node == nullptr ? std::nullopt : v.text("contacts", *node);
    if (path) {
        s.contacts = resolved_path(v.context().folder, *path);
        check_file(v, node->place, s.contacts);
    }
}

/// Only where there is one: imports without keep their cases.
void contacts_field(Writer& v, const ImportSpec& s) {
    if (!s.contacts.empty()) {
        v.field("contacts", s.contacts);
    }
}

void inertial_number_field(Reader& v, double& value) {
    const Node* node = v.take("inertial_number");
    if (node == nullptr) {
        return;
    }
    const auto named = std::ranges::find_if(names::inertial_number, [&](const auto& known) {
        return node->is_text() && known.word == node->text;
    });
    value = named != names::inertial_number.end() ? named->value : v.number("inertial_number", *node).value_or(value);
}

void inertial_number_field(Writer& v, double value) {
    v.field("inertial_number", value);
}

void velocity_rule_field(Reader& v, erosion::DetachSpec& s) {
    const bool is_given = v.has("rule");
    v.choice("rule", s.rule, names::velocity_rule);
    if (is_given && s.by == erosion::DetachBy::Displacement) {
        v.error(
            "E207", v.place(), "`rule` belongs to by = \"velocity\"", "leave `rule` out, or write by = \"velocity\""
        );
    }
}

void velocity_rule_field(Writer& v, const erosion::DetachSpec& s) {
    if (s.by == erosion::DetachBy::Velocity) {
        v.choice("rule", s.rule, names::velocity_rule);
    }
}

void over_field(Reader& v, erosion::DetachSpec& s) {
    using erosion::DetachBy;
    using erosion::VelocityRule;
    const bool needs_speed = s.by == DetachBy::Velocity && s.rule == VelocityRule::Above;
    const Node* node = v.take("over");
    if (node == nullptr) {
        if (needs_speed) {
            v.error("E201", v.place(), "rule = \"above\" needs a speed in `over`", "as in over = \"1e-5 m/s\"");
        }
        return;
    }
    if (s.by == DetachBy::Velocity && s.rule == VelocityRule::Rising) {
        return v.error(
            "E207", node->place, "rule = \"rising\" compares with nothing, and `over` is given", "leave `over` out"
        );
    }
    if (s.by == DetachBy::Displacement && node->is_text() && node->text.ends_with('d')) {
        Node number = *node;
        number.text.pop_back();
        s.over_diameters = v.number(over_key(dimension::none), number);
    } else if (needs_speed) {
        s.over_speed = v.number(over_key(dimension::velocity), *node);
    } else {
        s.over = v.number(over_key(dimension::none), *node).value_or(s.over);
    }
}

void over_field(Writer& v, const erosion::DetachSpec& s) {
    using erosion::DetachBy;
    if (s.by == DetachBy::Velocity && s.rule == erosion::VelocityRule::Rising) {
        return;
    }
    if (s.by == DetachBy::Displacement && s.over_diameters) {
        v.set("over", make_node(Scalar(fmt::format("{} d", *s.over_diameters))));
    } else if (s.by == DetachBy::Velocity && s.rule == erosion::VelocityRule::Above && s.over_speed) {
        v.set("over", make_node(Scalar(print_quantity(*s.over_speed, dimension::velocity))));
    } else {
        v.set("over", make_node(Scalar(s.over)));
    }
}

void sweep_field(Reader& v, std::string_view key, std::vector<Sweep>& sweeps) {
    const Node* node = v.take(key);
    if (node == nullptr) {
        return;
    }
    if (!node->is_table()) {
        return v.wrong_type(key, *node, "a table of lists, { KEY = [values] }");
    }
    for (const auto& [name, place, values] : node->entries) {
        Sweep sweep{name, {}};
        const std::vector<Node>* items = v.list(key, values);
        if (items == nullptr) {
            continue;
        }
        if (items->empty()) {
            v.error(
                "E205", values.place, fmt::format("`{}` sweeps over an empty list", name), "write at least one value"
            );
        }
        for (const Node& item : *items) {
            if (item.is_scalar() && item.kind != Node::Kind::Date) {
                sweep.values.push_back(scalar_of(item));
            } else {
                v.wrong_type(key, item, "plain values in its lists");
            }
        }
        sweeps.push_back(std::move(sweep));
    }
}

void sweep_field(Writer& v, std::string_view key, const std::vector<Sweep>& sweeps) {
    Node table;
    for (const Sweep& sweep : sweeps) {
        std::vector<Node> items;
        for (const Scalar& value : sweep.values) {
            items.push_back(make_node(value));
        }
        table.set(sweep.key, make_array(std::move(items)));
    }
    if (!sweeps.empty()) {
        v.set(key, std::move(table));
    }
}

void spring_fields(Reader& v, grains::Material& m) {
    const contact::Spring& spring = contact::spring_of(m);
    const auto owned_by_some = [](std::string_view key) {
        return !contact::laws_where([&](const contact::Spring& any) { return has_own(any, key); }).empty();
    };
    std::vector<std::string_view> foreign;
    grains::list_members(m, [&](const grains::Member& member, auto& value) {
        if constexpr (std::is_same_v<decltype(value), double&>) {
            if (owned_by_some(member.name)) {
                v.field(member.name, value);
                if (!has_own(spring, member.name)) {
                    foreign.emplace_back(member.name);
                }
            }
        }
    });
    for (const std::string_view key : foreign) {
        if (const Node* node = v.take(key)) {
            v.error(
                "E207", node->place, fmt::format("the law \"{}\" has no `{}`", spring.words.name, key),
                advice_without(spring, key)
            );
        }
    }
}

void spring_fields(Writer& v, const grains::Material& m) {
    const contact::Spring& spring = contact::spring_of(m);
    grains::list_members(m, [&](const grains::Member& member, const auto& value) {
        if constexpr (std::is_same_v<decltype(value), const double&>) {
            if (has_own(spring, member.name)) {
                v.field(member.name, value);
            }
        }
    });
}

void check_law(Reader& v, const grains::Material& m) {
    const contact::Spring& spring = contact::spring_of(m);
    for (const contact::NeededKey& key : spring.words.needs) {
        if (!v.has(key.name)) {
            v.error(
                "E201", v.place(), fmt::format("the law \"{}\" needs {}", spring.words.name, key.what),
                std::string(key.advice)
            );
        }
    }
    if (!spring.may_adhere && adheres(m)) {
        v.error(
            "E207", v.place(), fmt::format("grains under the law \"{}\" do not adhere", spring.words.name),
            fmt::format("leave `adhesion` out, or take law = \"{}\"", contact::laws_that_adhere())
        );
    }
}

void check_law(Writer&, const grains::Material&) {}

} // namespace suffuse::casefile
