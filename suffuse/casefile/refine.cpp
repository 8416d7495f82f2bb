#include "suffuse/casefile/refine.hpp"

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/casefile/bind.hpp"
#include "suffuse/casefile/node.hpp"
#include "suffuse/casefile/sweep_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace suffuse::casefile {
namespace {

/// "32.5 %" -> "%"; what follows the number of a text.
std::string unit_of(const std::string& text) {
    double number = 0;
    const auto [rest, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
    std::string unit = problem == std::errc() ? std::string(rest, text.data() + text.size()) : text;
    unit.erase(0, std::min(unit.find_first_not_of(' '), unit.size()));
    return unit;
}

double number_of(const std::string& text) {
    double number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

} // namespace

Scalar value_between(const Scalar& a, const Scalar& b, double share) {
    const auto between = [&](double x, double y) { return x + share * (y - x); };
    const auto *text_a = std::get_if<std::string>(&a), *text_b = std::get_if<std::string>(&b);
    if (text_a != nullptr && text_b != nullptr && unit_of(*text_a) == unit_of(*text_b)) {
        return fmt::format("{:.6g} {}", between(number_of(*text_a), number_of(*text_b)), unit_of(*text_a));
    }
    const Quantity x = quantity_of(a).value(), y = quantity_of(b).value();
    const double value = between(x.value, y.value);
    if (std::holds_alternative<std::int64_t>(a) && std::holds_alternative<std::int64_t>(b)) {
        return static_cast<std::int64_t>(std::llround(value));
    }
    const double rounded = number_of(fmt::format("{:.6g}", value));
    return x.dimension == dimension::none ? Scalar(rounded) : Scalar(print_quantity(rounded, x.dimension));
}

std::vector<Variant> variants_at(const Case& c, const std::string& study, const std::map<std::string, Scalar>& values) {
    Node root = tree_of(c);
    Node& table = root.find("study")->value.find(study)->value;
    for (Node::Entry& sweep : table.find("sweep")->value.entries) {
        sweep.value = make_array({make_node(values.at(sweep.key))});
    }
    std::erase_if(table.entries, [](const Node::Entry& entry) { return entry.key == "refine"; });
    Problems problems;
    const Case changed = bind_case(root, "", c.preset, problems);
    if (problems.has_errors()) {
        throw CaseProblems(problems.sorted());
    }
    const auto found =
        std::find_if(changed.studies.begin(), changed.studies.end(), [&](const Study& s) { return s.name == study; });
    return found->variants;
}

} // namespace suffuse::casefile
