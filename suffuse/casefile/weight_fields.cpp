#include "suffuse/casefile/weight_fields.hpp"

#include "suffuse/casefile/names.hpp"
#include "suffuse/erosion/ramp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <span>

namespace suffuse::casefile {

namespace {

constexpr double usual_last_gradient = 1.2;
constexpr std::int64_t usual_steps = 24;

/// The values of a key that may be a list, each read by `read(node)`.
template <class T, class Read>
std::vector<T> one_or_list(Reader& v, std::string_view key, Read read) {
    std::vector<T> values;
    const Node* node = v.take(key);
    if (node == nullptr) {
        return values;
    }
    if (node->is_array() && node->items.empty()) {
        v.error(
            "E205", node->place, fmt::format("`{}` is an empty list", key),
            "write one value, or one for each pass, or leave the key out"
        );
    }
    for (const Node& item : node->is_array() ? node->items : std::vector<Node>{*node}) {
        if (std::optional<T> value = read(item)) {
            values.push_back(std::move(*value));
        }
    }
    return values;
}

std::vector<erosion::DetachSpec> read_rules(Reader& v) {
    return one_or_list<erosion::DetachSpec>(v, "detached", [&](const Node& node) -> std::optional<erosion::DetachSpec> {
        if (!node.is_table()) {
            v.wrong_type("detached", node, "a table, { ... }, or a list of them");
            return std::nullopt;
        }
        erosion::DetachSpec rule;
        Reader inner(v.context(), node, node.place, {"stage.erode.detached"}, v.path() + ".detached");
        fields(inner, rule);
        inner.finish();
        return rule;
    });
}

/// Lists of several passes must agree on how many.
void check_lengths(Reader& v, std::size_t passes, std::initializer_list<std::size_t> lengths) {
    for (const std::size_t length : lengths) {
        if (length > 1 && length != passes) {
            v.error(
                "E207", v.place(), fmt::format("{} has lists for {} passes and for {}", v.title(), length, passes),
                "give `gradient`, `hold` and `detached` one entry a pass each, or a single value"
            );
            return;
        }
    }
}

template <class T>
T entry(const std::vector<T>& values, std::size_t pass, const T& otherwise) {
    return values.empty() ? otherwise : values[std::min(pass, values.size() - 1)];
}

/// What `print` makes of each pass, or of one where it is the same for all.
template <class Print>
Node node_of_passes(const erosion::ErodeSpec& s, Print print) {
    std::vector<Node> items{print({s.gradient, s.detached, s.probe.hold_coarse})};
    std::ranges::transform(s.later_passes, std::back_inserter(items), print);
    const std::string first = print_value(items.front());
    const bool are_same = std::ranges::all_of(items, [&](const Node& item) { return print_value(item) == first; });
    return are_same ? items.front() : make_array(std::move(items));
}

/// Each of the keys that the stage gives is an error.
void refuse(Reader& v, std::span<const std::string_view> keys, std::string_view reason, const std::string& advice) {
    for (const std::string_view key : keys) {
        if (const Node* node = v.take(key)) {
            v.error("E207", node->place, fmt::format("{} gives `{}`, {}", v.title(), key, reason), advice);
        }
    }
}

} // namespace

void take_gravity(Reader& v, std::optional<erosion::Gravity>& gravity) {
    gravity = v.context().gravity;
}

void check_weightless(Reader& v, const erosion::ProbeSpec& probe) {
    constexpr std::array<std::string_view, 5> keys = {
        "detached", "ramp", "watch", "probe_unbalanced_force", "relax_limit"};
    if (probe.gravity) {
        refuse(
            v, keys, "which has no meaning where fines have weight",
            "remove it: with [gravity] fines that move half a diameter against their weight are mobile; or leave "
            "[gravity] out"
        );
    }
}

void check_weighed(Reader& v, const erosion::ProbeSpec& probe) {
    constexpr std::array<std::string_view, 4> keys = {"hold_at_most", "fluid_drag", "moved", "softness"};
    if (!probe.gravity) {
        refuse(
            v, keys, "which has no meaning where fines have no weight", "add [gravity] with down = \"-z\", or remove it"
        );
    }
}

void check_hold(Reader& v, const erosion::ProbeSpec& probe, bool holds_coarse) {
    const Node* node = v.take("hold");
    if (probe.gravity && !holds_coarse && node != nullptr) {
        v.error(
            "E207", node->place, fmt::format("{} holds no grain, and its fines have weight: all would fall", v.title()),
            "leave `hold` out: the coarse grains are held; or leave [gravity] out"
        );
    }
}

void check_migration(Reader& v, const erosion::MigrateSpec& s) {
    if (!s.gravity) {
        v.error(
            "E207", v.place(),
            fmt::format("{} moves fines with the water, but the case gives them no weight", v.title()),
            "add [gravity] with down = \"-z\": weight decides which fines the water lifts, and where they rest"
        );
    }
}

void gradients_field(Reader& v, erosion::DetachStageSpec& s) {
    if (s.probe.gravity) {
        s.gradients = erosion::even_gradients(usual_last_gradient, usual_steps);
    }
    const Node* node = v.take("gradients");
    if (node == nullptr) {
        return;
    }
    if (!node->is_table()) {
        return v.field("gradients", s.gradients);
    }
    double up_to = 0;
    std::int64_t steps = 0;
    Reader inner(v.context(), *node, node->place, {"stage.detach.gradients"}, v.path() + ".gradients");
    inner.field("up_to", up_to);
    inner.field("steps", steps);
    inner.finish();
    if (up_to > 0 && steps > 0) {
        s.gradients = erosion::even_gradients(up_to, steps);
    }
}

void gradients_field(Writer& v, const erosion::DetachStageSpec& s) {
    v.field("gradients", s.gradients);
}

void check_ramp(Reader& v, const erosion::DetachStageSpec& s) {
    const auto place = [&](const char* key) { return v.context().places[fmt::format("{}.{}", v.path(), key)]; };
    const auto falls = [](double a, double b) { return !(a < b); };
    if (!s.probe.gravity) {
        if (s.specified_gradient) {
            v.error(
                "E207", place("asked_gradient"),
                fmt::format("{} specifies a gradient for a factor of safety, but its fines have no weight", v.title()),
                "add [gravity] with down = \"-z\", or remove `asked_gradient`: without weight any gradient removes the "
                "same grains"
            );
        }
    } else if (std::ranges::adjacent_find(s.gradients, falls) != s.gradients.end() || s.gradients.front() <= 0) {
        v.error(
            "E207", place("gradients"), fmt::format("{} has `gradients` that do not rise from above 0", v.title()),
            "with [gravity] the gradients are applied one after the other: write them in rising order, or { up_to = "
            "1.2, steps = 24 }"
        );
    }
}

void gradient_of_passes(Reader& v, erosion::ErodeSpec& s) {
    const auto gradients =
        one_or_list<double>(v, "gradient", [&](const Node& node) { return v.number("gradient", node); });
    const auto holds = one_or_list<bool>(v, "hold", [&](const Node& node) -> std::optional<bool> {
        const auto word = v.find_word("hold", node, names::words_of(names::hold));
        return word ? std::optional(names::hold[*word].value) : std::nullopt;
    });
    const std::vector<erosion::DetachSpec> rules = read_rules(v);
    const std::size_t passes = std::max({gradients.size(), holds.size(), rules.size()});
    check_lengths(v, passes, {gradients.size(), holds.size(), rules.size()});
    const auto at = [&](std::size_t pass) -> erosion::PassSpec {
        return {
            entry(gradients, pass, s.gradient), entry(rules, pass, s.detached),
            entry(holds, pass, s.probe.hold_coarse)};
    };
    const erosion::PassSpec first = at(0);
    for (std::size_t pass = 1; pass < passes; ++pass) {
        s.later_passes.push_back(at(pass));
    }
    s.gradient = first.gradient;
    s.detached = first.detached;
    s.probe.hold_coarse = first.hold_coarse;
    check_hold(v, s.probe, first.hold_coarse && std::ranges::all_of(s.later_passes, &erosion::PassSpec::hold_coarse));
    if (passes > 1 && !v.has("passes")) {
        s.passes = static_cast<int>(passes);
    } else if (passes > static_cast<std::size_t>(s.passes) && !v.context().is_resolved) {
        v.context().problems.warning(
            "W614", v.context().places[v.path() + ".passes"],
            fmt::format("{} has entries for {} passes, and makes {} of them", v.title(), passes, s.passes),
            "leave `passes` out: there are as many as the longest list has entries"
        );
    }
}

void gradient_of_passes(Writer& v, const erosion::ErodeSpec& s) {
    v.set("gradient", node_of_passes(s, [&](const erosion::PassSpec& p) { return v.number("gradient", p.gradient); }));
}

void hold_of_passes(Writer& v, const erosion::ErodeSpec& s) {
    v.set("hold", node_of_passes(s, [](const erosion::PassSpec& p) {
              return make_node(Scalar(names::word_for(names::hold, p.hold_coarse)));
          }));
}

void rule_of_passes(Writer& v, const erosion::ErodeSpec& s) {
    if (s.probe.gravity) {
        return;
    }
    v.set("detached", node_of_passes(s, [](const erosion::PassSpec& p) {
              Writer inner({"stage.erode.detached"});
              erosion::DetachSpec copy = p.detached;
              fields(inner, copy);
              return inner.node();
          }));
}

} // namespace suffuse::casefile
