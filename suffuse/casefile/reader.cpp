// Values of a table: numbers with and without units, words, lists.

#include "suffuse/casefile/reader.hpp"

#include "suffuse/base/spelling.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace suffuse::casefile {

namespace {

std::string kind_of(const Node& node) {
    switch (node.kind) {
    case Node::Kind::Table:
        return "a table";
    case Node::Kind::Array:
        return "a list";
    case Node::Kind::Text:
        return "a text";
    case Node::Kind::Integer:
    case Node::Kind::Number:
        return "a number";
    case Node::Kind::Flag:
        return "true or false";
    case Node::Kind::Date:
        return "a date";
    }
    return "something else";
}

bool is_number(const Node& node) {
    return node.kind == Node::Kind::Integer || node.kind == Node::Kind::Number;
}

double number_of(const Node& node) {
    return node.kind == Node::Kind::Integer ? static_cast<double>(node.integer) : node.number;
}

std::string listed(const std::vector<std::string>& words) {
    return fmt::format("{}", fmt::join(words, ", "));
}

/// A long value would bury the message.
std::string shown(const Node& node) {
    const std::string text = print_value(node);
    if (text.size() <= 60) {
        return text;
    }
    std::size_t end = 57;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) { // not within a character
        --end;
    }
    return text.substr(0, end) + "...";
}

/// The usual units, first the one in which the number comes nearest to the key's default: a viscosity of 1e-3 is meant
/// in Pa*s, one of 1 in mPa*s. Only by that a unit is proposed, never assumed.
std::vector<std::string> likely_units(const Key& key, const std::string& digits) {
    std::vector<std::string> units = usual_units(key.dimension);
    const auto known = std::ranges::find_if(schema(), [&](const Key& row) { // with its default, which `key` lacks
        return row.table == key.table && row.name == key.name;
    });
    const std::string usual = known == schema().end() ? "" : known->default_text; // in quotes
    try {
        const double nearest = usual.size() > 2 ? parse_quantity(usual.substr(1, usual.size() - 2), key.dimension) : 0;
        const auto distance = [&](const std::string& unit) {
            return std::abs(std::log(parse_quantity(digits + " " + unit, key.dimension) / nearest));
        };
        const bool is_density = key.dimension == dimension::density;
        if (is_density) { // as textbooks give it
            units.emplace_back("g/cm^3");
        }
        if (nearest > 0 && parse_quantity(digits).value > 0) {
            std::ranges::stable_sort(units, {}, distance);
            units.resize(is_density ? 1 : units.size()); // the other one is off by a thousand
        }
    } catch (const UnitError&) { // a default that is a word: "computed"
    }
    return units;
}

std::string quantity_advice(const Key& key, const std::string& digits) {
    const std::vector<std::string> usual = likely_units(key, digits);
    std::string advice = usual.size() > 1
                             ? fmt::format("write \"{} {}\" (or \"{} {}\")", digits, usual[0], digits, usual[1])
                             : fmt::format("write \"{} {}\"", digits, usual.empty() ? "" : usual[0]);
    return advice + "; suffuse explain " + key.name;
}

} // namespace

void Reader::wrong_type(std::string_view key, const Node& node, const std::string& needed) {
    error(
        "E205", node.place, fmt::format("`{}` needs {}, and {} is {}", key, needed, shown(node), kind_of(node)),
        fmt::format("suffuse explain {}", key)
    );
}

bool Reader::in_range(const Key& key, double value, const Node& node) {
    if (!std::isfinite(value)) {
        error(
            "E313", node.place, fmt::format("`{}` is {}, which is not a finite number", key.name, shown(node)),
            "write " + value_text(key)
        );
        return false;
    }
    if (key.range.contains(value)) {
        return true;
    }
    std::string advice = "it must be " + range_text(key);
    if (key.dimension == dimension::pressure && value < 0) {
        advice += "; compression is positive";
    } else if (key.kind == ValueKind::Ratio && value > 1 && key.range.contains(value / 100)) {
        advice += fmt::format("; {:g} percent is \"{:g} %\"", value, value);
    }
    error(
        "E312", node.place, fmt::format("`{}` is {}, out of its range", key.name, shown(node)), advice, range_text(key)
    );
    return false;
}

std::optional<double> Reader::number(std::string_view key, const Node& node) {
    return number(key_of(key), node);
}

std::optional<double> Reader::number(const Key& key, const Node& node) {
    const bool has_unit = key.kind == ValueKind::Quantity;
    if (is_number(node)) {
        if (!has_unit) {
            return in_range(key, number_of(node), node) ? std::optional(number_of(node)) : std::nullopt;
        }
        error(
            "E310", node.place,
            fmt::format("`{}` needs {}, and {} has no unit", key.name, with_article(key.dimension), shown(node)),
            quantity_advice(key, shown(node))
        );
        return std::nullopt;
    }
    if (!node.is_text()) {
        wrong_type(key.name, node, value_text(key));
        return std::nullopt;
    }
    try {
        const Quantity quantity = parse_quantity(node.text);
        if (has_unit && !quantity.has_unit) {
            error(
                "E310", node.place,
                fmt::format("`{}` needs {}, and {} has no unit", key.name, with_article(key.dimension), shown(node)),
                quantity_advice(key, node.text)
            );
            return std::nullopt;
        }
        if (quantity.dimension != key.dimension) {
            error(
                "E311", node.place,
                fmt::format(
                    "`{}` needs {}, and {} is {}", key.name, with_article(key.dimension), shown(node),
                    with_article(quantity.dimension)
                ),
                has_unit ? "write it in " + listed(usual_units(key.dimension)) : "write a bare number, or one with %"
            );
            return std::nullopt;
        }
        return in_range(key, quantity.value, node) ? std::optional(quantity.value) : std::nullopt;
    } catch (const UnitError& problem) {
        error(
            "E301", node.place, fmt::format("`{}`: {}", key.name, problem.what()),
            has_unit ? problem.help : "write " + value_text(key)
        );
        return std::nullopt;
    }
}

std::optional<std::int64_t> Reader::whole(std::string_view name, const Node& node) {
    const Key& key = key_of(name);
    if (!is_number(node)) {
        wrong_type(name, node, "a whole number");
        return std::nullopt;
    }
    const double value = number_of(node);
    if (!in_range(key, value, node)) {
        return std::nullopt;
    }
    if (node.kind == Node::Kind::Integer) {
        return node.integer;
    }
    if (value != std::floor(value) || std::abs(value) > 9e15) {
        wrong_type(name, node, "a whole number");
        return std::nullopt;
    }
    return static_cast<std::int64_t>(value);
}

std::optional<std::string> Reader::text(std::string_view key, const Node& node) {
    if (node.is_text()) {
        return node.text;
    }
    wrong_type(key, node, "a text in quotes");
    return std::nullopt;
}

std::optional<std::size_t>
Reader::find_word(std::string_view key, const Node& node, const std::vector<std::string>& words) {
    const auto word = text(key, node);
    if (!word) {
        return std::nullopt;
    }
    const auto found = std::find(words.begin(), words.end(), *word);
    if (found != words.end()) {
        return static_cast<std::size_t>(found - words.begin());
    }
    auto nearest = nearest_word(*word, words);
    constexpr std::size_t least = 4; // letters of an abbreviation: triax for triaxial
    if (!nearest && word->size() >= least) {
        const auto begun =
            std::ranges::find_if(words, [&](const std::string& known) { return known.starts_with(*word); });
        nearest = begun != words.end() ? std::optional(*begun) : std::nullopt;
    }
    error(
        "E206", node.place, fmt::format("`{}` cannot be {}", key, shown(node)),
        nearest ? fmt::format("a word with a similar name exists: \"{}\"; known are {}", *nearest, listed(words))
                : fmt::format("known are {}", listed(words))
    );
    return std::nullopt;
}

const std::vector<Node>* Reader::list(std::string_view key, const Node& node) {
    if (node.is_array()) {
        return &node.items;
    }
    wrong_type(key, node, "a list, [ ... ]");
    return nullptr;
}

std::optional<Vec3> Reader::vector(std::string_view key, const Node& node) {
    const std::vector<Node>* items = list(key, node);
    if (items == nullptr) {
        return std::nullopt;
    }
    if (items->size() != 3) {
        error(
            "E205", node.place, fmt::format("`{}` needs three values, and there are {}", key, items->size()),
            "one for each axis, x, y, z"
        );
        return std::nullopt;
    }
    Vec3 value;
    bool is_good = true;
    for (int a = 0; a < 3; ++a) {
        const auto component = number(key, (*items)[static_cast<std::size_t>(a)]);
        is_good = is_good && component;
        value[a] = component.value_or(0);
    }
    return is_good ? std::optional(value) : std::nullopt;
}

void Reader::field(std::string_view key, double& value) {
    if (const Node* node = take(key)) {
        value = number(key, *node).value_or(value);
    }
}

void Reader::field(std::string_view key, std::optional<double>& value) {
    if (const Node* node = take(key)) {
        value = number(key, *node);
    }
}

void Reader::field(std::string_view key, std::int64_t& value) {
    if (const Node* node = take(key)) {
        value = whole(key, *node).value_or(value);
    }
}

void Reader::field(std::string_view key, std::optional<std::int64_t>& value) {
    if (const Node* node = take(key)) {
        value = whole(key, *node);
    }
}

void Reader::field(std::string_view key, std::uint64_t& value) {
    if (const Node* node = take(key)) {
        if (const auto number = whole(key, *node)) {
            value = static_cast<std::uint64_t>(*number);
        }
    }
}

void Reader::field(std::string_view key, int& value) {
    if (const Node* node = take(key)) {
        if (const auto number = whole(key, *node)) {
            value = static_cast<int>(*number);
        }
    }
}

void Reader::field(std::string_view key, bool& value) {
    const Node* node = take(key);
    if (node == nullptr) {
        return;
    }
    if (node->kind == Node::Kind::Flag) {
        value = node->flag;
    } else {
        wrong_type(key, *node, "true or false");
    }
}

void Reader::field(std::string_view key, std::string& value) {
    if (const Node* node = take(key)) {
        value = text(key, *node).value_or(value);
    }
}

void Reader::field(std::string_view key, std::vector<double>& value) {
    const Node* node = take(key);
    const std::vector<Node>* items = node != nullptr ? list(key, *node) : nullptr;
    if (items == nullptr) {
        return;
    }
    value.clear();
    for (const Node& item : *items) {
        if (const auto one = number(key, item)) {
            value.push_back(*one);
        }
    }
    if (items->empty()) {
        error(
            "E205", node->place, fmt::format("`{}` is an empty list", key),
            "write at least one value, or leave the key out"
        );
    }
}

void Reader::field(std::string_view key, std::vector<std::string>& value) {
    const Node* node = take(key);
    const std::vector<Node>* items = node != nullptr ? list(key, *node) : nullptr;
    if (items == nullptr) {
        return;
    }
    const Key& known = key_of(key);
    value.clear();
    for (const Node& item : *items) {
        const bool is_good = known.kind == ValueKind::Choice ? find_word(key, item, known.choices).has_value()
                                                             : text(key, item).has_value();
        if (is_good) {
            value.push_back(item.text);
        }
    }
}

void Reader::direction(Vec3& value, std::string_view key) {
    const Node* node = take(key);
    if (node == nullptr) {
        return;
    }
    if (node->is_array()) {
        const auto given = vector(key, *node);
        if (!given) {
            return;
        }
        const Vec3 along = squarable(*given);
        const double length = norm(along);
        if (!(length > 0) || !std::isfinite(length)) {
            error(
                "E312", node->place, fmt::format("`{}` has no length", key),
                "write \"z\", or three numbers that are not all zero"
            );
            return;
        }
        // A unit vector stays as it is, so that a case that was written back reads as the same bits.
        value = std::abs(length - 1) < 1e-12 ? along : along / length;
        return;
    }
    static const std::vector<std::string> axes{"x", "y", "z", "+x", "+y", "+z", "-x", "-y", "-z"};
    if (const auto found = find_word(key, *node, axes)) {
        value = {};
        value[static_cast<int>(*found % 3)] = *found >= 6 ? -1 : 1;
    }
}

void Reader::time_step(double& value) {
    const Node* node = take("time_step");
    if (node == nullptr) {
        return;
    }
    value = node->is_text() && node->text == "computed" ? 0 : number("time_step", *node).value_or(value);
}

} // namespace suffuse::casefile
