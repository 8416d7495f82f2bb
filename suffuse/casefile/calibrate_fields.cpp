#include "suffuse/casefile/calibrate_fields.hpp"

#include "suffuse/casefile/check_name.hpp"
#include "suffuse/casefile/sweep_value.hpp"
#include "suffuse/casefile/writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

namespace suffuse::casefile {
namespace {

constexpr std::array calibrate_tests = {
    names::Word<CalibrateTest>{CalibrateTest::Drained, "drained"},
    names::Word<CalibrateTest>{CalibrateTest::Undrained, "undrained"},
    names::Word<CalibrateTest>{CalibrateTest::Oedometer, "oedometer"}};

constexpr std::size_t most_unknowns = 16; // designs of samples are stored for as many

/// "data/drained.csv" -> "drained": letters that a folder may have.
std::string plain_stem(const std::string& file) {
    std::string plain;
    for (const char c : std::filesystem::path(file).stem().string()) {
        plain += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' ? c : '-';
    }
    return plain.substr(0, 40);
}

constexpr std::array contractions = {names::Word<bool>{true, "positive"}, names::Word<bool>{false, "negative"}};

void contraction_field(Reader& v, std::optional<bool>& is_positive) {
    if (v.has("contraction")) {
        v.choice("contraction", is_positive.emplace(true), contractions);
    } else {
        v.take("contraction");
    }
}

void contraction_field(Writer&, const std::optional<bool>&) {} // no default

template <class V, class Target>
void target_fields(V& v, Target& target) {
    v.field("name", target.name);
    v.field("file", target.file);
    v.choice("test", target.test, calibrate_tests);
    v.field("sample", target.sample);
    contraction_field(v, target.contraction_is_positive);
    v.field("pressure", target.pressure);
    v.field("void_ratio", target.void_ratio);
    v.field("void_ratio_of", target.void_ratio_of);
    v.field("void_ratio_tolerance", target.void_ratio_tolerance);
    v.field("strain", target.strain);
    v.field("scatter", target.scatter);
    v.field("weight", target.weight);
    v.field("held_out", target.is_held_out);
}

template <class V, class Spec>
void plain_fields(V& v, Spec& spec) {
    v.field("soil", spec.soil);
    v.field("particles", spec.particles);
    v.field("samples", spec.samples);
    v.field("fix_void_ratio", spec.fix_void_ratio);
}

/// Targets without a name are called by their test, or their file, and numbered where that names several.
void name_targets(ReadContext& context, std::vector<CalibrateTarget>& targets) {
    std::set<std::string> taken;
    for (CalibrateTarget& target : targets) {
        const bool is_given = !target.name.empty();
        const std::string base = is_given                ? target.name
                                 : target.sample.empty() ? plain_stem(target.file)
                                                         : plain_stem(target.sample);
        target.name = base.empty() ? "target" : base;
        for (int k = 2; !is_given && taken.contains(target.name); ++k) {
            target.name = fmt::format("{}-{}", base, k);
        }
        if (!check_name(context, "target", target.name, target.place)) {
            continue;
        }
        if (!taken.insert(target.name).second) {
            context.problems.error(
                "E204", target.place, fmt::format("two targets are called \"{}\"", target.name),
                "give each its own name"
            );
        }
    }
}

void read_targets(ReadContext& context, Reader& v, CalibrateSpec& spec) {
    const Node* node = v.take("targets");
    const std::vector<Node>* items = node == nullptr ? nullptr : v.list("targets", *node);
    if (items == nullptr) {
        return;
    }
    for (const Node& item : *items) {
        if (!item.is_table()) {
            v.wrong_type("targets", item, "tables, { file = ..., test = ..., pressure = ... }");
            continue;
        }
        CalibrateTarget target;
        target.place = item.place;
        Reader inner(context, item, item.place, {"calibrate.targets"}, v.path() + ".targets");
        target_fields(inner, target);
        inner.finish();
        if (spec.fix_void_ratio && !target.void_ratio) {
            v.error(
                "E201", item.place, "fix_void_ratio = true needs the `void_ratio` of every target",
                "add void_ratio = 0.7, or leave `fix_void_ratio` out: then it is an unknown"
            );
        }
        target.file = (std::filesystem::path(context.folder) / target.file).string();
        spec.targets.push_back(std::move(target));
    }
    if (std::ranges::all_of(spec.targets, &CalibrateTarget::is_held_out)) {
        v.error(
            "E205", node->place, "`targets` names no test to fit", "add a target that is not held out: { file = ... }"
        );
    }
    name_targets(context, spec.targets);
}

/// ["20 deg", "40 deg"], or with "log" at the end.
std::optional<CalibrateUnknown> read_unknown(Reader& v, const Node::Entry& entry) {
    const std::vector<Node>& items = entry.value.items;
    CalibrateUnknown unknown;
    unknown.key = entry.key;
    unknown.place = entry.value.place;
    unknown.is_log = items.size() == 3 && items[2].is_text() && items[2].text == "log";
    if (!entry.value.is_array() || (items.size() != 2 && !unknown.is_log) || !items[0].is_scalar() ||
        !items[1].is_scalar()) {
        v.wrong_type(
            "unknowns", entry.value, "ranges in its table, KEY = [LEAST, MOST] or KEY = [LEAST, MOST, \"log\"]"
        );
        return std::nullopt;
    }
    unknown.low = scalar_of(items[0]);
    unknown.high = scalar_of(items[1]);
    const std::optional<Quantity> low = quantity_of(unknown.low), high = quantity_of(unknown.high);
    const char* problem = !low || !high                       ? "its ends must be numbers or quantities"
                          : low->dimension != high->dimension ? "its ends are of two dimensions"
                          : low->value >= high->value         ? "its first end must be the lower one"
                          : unknown.is_log && low->value <= 0 ? "with \"log\" both ends must be above 0"
                                                              : nullptr;
    if (problem != nullptr) {
        v.error(
            "E312", entry.value.place, fmt::format("the range of `{}` is no range: {}", entry.key, problem),
            "write [\"20 deg\", \"40 deg\"], or [\"50 MPa\", \"2 GPa\", \"log\"]"
        );
        return std::nullopt;
    }
    unknown.least = low->value;
    unknown.most = high->value;
    unknown.dimension = low->dimension;
    return unknown;
}

/// Where the case does not say: from dense to loose for spheres.
CalibrateUnknown usual_void_ratio(const Place& place) {
    return {void_ratio_key, Scalar(0.55), Scalar(0.8), 0.55, 0.8, dimension::none, false, place};
}

/// Each fitted target that shares no other's has a void ratio of its own, with the range of its name, or of
/// `void_ratio`.
void add_void_ratios(ReadContext& context, CalibrateSpec& spec, CalibrateUnknown usual) {
    const auto has_own = [](const CalibrateTarget& target) {
        return target.void_ratio_of.empty() && !target.is_held_out;
    };
    std::vector<std::string> own; // keys
    for (const CalibrateTarget& target : spec.targets) {
        if (has_own(target)) {
            own.push_back(fmt::format("{}.{}", void_ratio_key, target.name));
        }
    }
    const bool is_one = own.size() == 1;
    for (const CalibrateUnknown& unknown : spec.unknowns) {
        if (is_void_ratio(unknown.key) && std::erase(own, unknown.key) == 0) {
            context.problems.error(
                "E401", unknown.place,
                fmt::format("`{}`: no target of this name has a void ratio of its own", unknown.key),
                "name a target that is fitted, without void_ratio_of"
            );
        }
    }
    for (const std::string& key : own) {
        usual.key = is_one ? std::string(void_ratio_key) : key;
        spec.unknowns.push_back(usual);
    }
}

/// A target whose samples share the void ratio of another names one that has its own.
void check_void_ratios(ReadContext& context, const CalibrateSpec& spec) {
    for (const CalibrateTarget& target : spec.targets) {
        const auto named = std::ranges::find(spec.targets, target.void_ratio_of, &CalibrateTarget::name);
        const bool is_lost = !target.void_ratio_of.empty() &&
                             (named == spec.targets.end() || named->is_held_out || !named->void_ratio_of.empty());
        if (is_lost) {
            context.problems.error(
                "E401", target.place,
                fmt::format("`void_ratio_of` names \"{}\", which has no void ratio of its own", target.void_ratio_of),
                "name a target that is fitted"
            );
        } else if (target.is_held_out && target.void_ratio_of.empty() && !target.void_ratio) {
            context.problems.error(
                "E201", target.place,
                fmt::format("nothing gives the void ratio of \"{}\", which is held out", target.name),
                "add void_ratio_of = \"NAME\" of a fitted target of the same density, or void_ratio = 0.7"
            );
        }
    }
}

void read_unknowns(Reader& v, CalibrateSpec& spec) {
    const Node* node = v.take("unknowns");
    if (node == nullptr) {
        return;
    }
    if (!node->is_table()) {
        return v.wrong_type("unknowns", *node, "a table of ranges, { KEY = [LEAST, MOST] }");
    }
    CalibrateUnknown void_ratio = usual_void_ratio(node->place);
    for (const Node::Entry& entry : node->entries) {
        std::optional<CalibrateUnknown> unknown = read_unknown(v, entry);
        if (!unknown) {
            continue;
        }
        if (is_void_ratio(entry.key) && spec.fix_void_ratio) {
            v.error(
                "E207", entry.place, "the void ratio is an unknown and fixed as well",
                "leave `fix_void_ratio` or this range out"
            );
        } else if (entry.key == void_ratio_key) {
            void_ratio = std::move(*unknown);
        } else {
            spec.unknowns.push_back(std::move(*unknown));
        }
    }
    if (!spec.fix_void_ratio) {
        add_void_ratios(v.context(), spec, std::move(void_ratio));
        check_void_ratios(v.context(), spec);
    }
    if (spec.unknowns.empty() || spec.unknowns.size() > most_unknowns) {
        v.error(
            "E312", node->place, fmt::format("there are {} unknowns, void ratios included", spec.unknowns.size()),
            "calibrate from 1 to 16 of them at once"
        );
    }
}

/// One side of a constraint: "0.5 * KEY", "KEY", or a number or quantity, whose key is empty.
std::optional<std::pair<std::string, double>> side_of(std::string text, const CalibrateSpec& spec) {
    const auto trim = [](std::string& t) {
        t.erase(0, std::min(t.find_first_not_of(' '), t.size()));
        t.erase(t.find_last_not_of(' ') + 1);
    };
    trim(text);
    const auto is_unknown = [&](const std::string& key) {
        return std::ranges::any_of(spec.unknowns, [&](const CalibrateUnknown& u) { return u.key == key; });
    };
    if (is_unknown(text)) {
        return std::pair(text, 1.0);
    }
    if (const std::size_t star = text.find('*'); star != std::string::npos && text.find("**") == std::string::npos) {
        std::string key = text.substr(star + 1), factor = text.substr(0, star);
        trim(key), trim(factor);
        const std::optional<Quantity> number = quantity_of(Scalar(factor));
        if (is_unknown(key) && number && number->dimension == dimension::none) {
            return std::pair(key, number->value);
        }
    }
    const std::optional<Quantity> value = quantity_of(Scalar(text));
    return value ? std::optional(std::pair(std::string(), value->value)) : std::nullopt;
}

std::optional<CalibrateConstraint> constraint_of(const std::string& text, const CalibrateSpec& spec) {
    const std::size_t at = text.find('=');
    if (at == std::string::npos || at == 0 || (text[at - 1] != '<' && text[at - 1] != '>')) {
        return std::nullopt;
    }
    auto left = side_of(text.substr(0, at - 1), spec), right = side_of(text.substr(at + 1), spec);
    if (text[at - 1] == '>') {
        std::swap(left, right);
    }
    if (!left || !right || (left->first.empty() && right->first.empty())) {
        return std::nullopt;
    }
    return CalibrateConstraint{left->first, right->first, left->second, right->second, text};
}

void read_constraints(Reader& v, CalibrateSpec& spec) {
    const Node* node = v.take("constraints");
    const std::vector<Node>* items = node == nullptr ? nullptr : v.list("constraints", *node);
    if (items == nullptr) {
        return;
    }
    for (const Node& item : *items) {
        const auto constraint = item.is_text() ? constraint_of(item.text, spec) : std::nullopt;
        if (constraint) {
            spec.constraints.push_back(*constraint);
        } else {
            v.error(
                "E205", item.place, fmt::format("{} is no constraint of these unknowns", print_value(item)),
                "compare unknowns in SI, as in \"contact.rolling_friction <= 0.5 * contact.friction\" or "
                "\"contact.friction >= 25 deg\""
            );
        }
    }
}

} // namespace

CalibrateSpec read_calibrate(ReadContext& context, const Node::Entry& entry) {
    CalibrateSpec spec;
    if (!entry.value.is_table()) {
        context.problems.error(
            "E205", entry.value.place, "`calibrate` needs a table, and this is a value",
            "write [calibrate] on a line of its own"
        );
        return spec;
    }
    Reader v(context, entry.value, entry.place, {"calibrate"}, "calibrate");
    plain_fields(v, spec);
    const Node::Entry* particles = entry.value.find("particles");
    spec.particles_place = particles == nullptr ? entry.place : particles->place;
    read_targets(context, v, spec);
    read_unknowns(v, spec);
    read_constraints(v, spec);
    v.finish();
    return spec;
}

Node calibrate_defaults() {
    Writer v({"calibrate"});
    const CalibrateSpec spec;
    plain_fields(v, spec);
    return v.node();
}

Node calibrate_target_defaults() {
    Writer v({"calibrate.targets"});
    const CalibrateTarget target;
    target_fields(v, target);
    return v.node();
}

bool is_void_ratio(const std::string& key) {
    return key == void_ratio_key || key.starts_with(fmt::format("{}.", void_ratio_key));
}

double value_at(const CalibrateUnknown& unknown, double share) {
    return unknown.is_log ? unknown.least * std::pow(unknown.most / unknown.least, share)
                          : unknown.least + share * (unknown.most - unknown.least);
}

int void_ratio_of(const CalibrateSpec& spec, const CalibrateTarget& target) {
    const std::string& owner = target.void_ratio_of.empty() ? target.name : target.void_ratio_of;
    for (std::size_t k = 0; k < spec.unknowns.size(); ++k) {
        const std::string& key = spec.unknowns[k].key;
        if (key == fmt::format("{}.{}", void_ratio_key, owner) ||
            (key == void_ratio_key && (!target.is_held_out || !target.void_ratio_of.empty()))) {
            return static_cast<int>(k);
        }
    }
    return -1;
}

bool meets(const CalibrateConstraint& constraint, const CalibrateSpec& spec, const std::vector<double>& values) {
    const auto side = [&](const std::string& key, double factor) {
        for (std::size_t k = 0; k < spec.unknowns.size(); ++k) {
            if (spec.unknowns[k].key == key) {
                return factor * values[k];
            }
        }
        return factor; // a number
    };
    return side(constraint.left, constraint.left_factor) <= side(constraint.right, constraint.right_factor);
}

} // namespace suffuse::casefile
