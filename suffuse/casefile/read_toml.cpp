#include "suffuse/casefile/read_toml.hpp"

#include "suffuse/casefile/read_text.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <sstream>

namespace suffuse::casefile {

namespace {

using Text = std::shared_ptr<const Source>;

Place place_of(const Text& source, const toml::source_region& region) {
    Place place{source, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column), 1};
    if (region.end.line == region.begin.line && region.end.column > region.begin.column) {
        place.length = static_cast<int>(region.end.column - region.begin.column);
    }
    return place;
}

bool stands_before(const Place& a, const Place& b) {
    return a.line < b.line || (a.line == b.line && a.column < b.column);
}

Node convert(const Text& source, const toml::node& value);

Node convert_table(const Text& source, const toml::table& table) {
    Node node;
    for (const auto& [key, value] : table) {
        node.entries.push_back({std::string(key.str()), place_of(source, key.source()), convert(source, value)});
    }
    // The library sorts by name; people think in the order of their file.
    std::stable_sort(node.entries.begin(), node.entries.end(), [](const Node::Entry& a, const Node::Entry& b) {
        return stands_before(a.place, b.place);
    });
    return node;
}

Node convert_value(const Text& source, const toml::node& value) {
    if (const auto* table = value.as_table()) {
        return convert_table(source, *table);
    }
    if (const auto* array = value.as_array()) {
        std::vector<Node> items;
        for (const toml::node& item : *array) {
            items.push_back(convert(source, item));
        }
        return make_array(std::move(items));
    }
    if (const auto* text = value.as_string()) {
        return make_node(Scalar(text->get()));
    }
    if (const auto* integer = value.as_integer()) {
        return make_node(Scalar(integer->get()));
    }
    if (const auto* number = value.as_floating_point()) {
        return make_node(Scalar(number->get()));
    }
    if (const auto* flag = value.as_boolean()) {
        return make_node(Scalar(flag->get()));
    }
    Node date;
    date.kind = Node::Kind::Date;
    std::ostringstream text;
    value.visit([&](const auto& v) {
        if constexpr (toml::is_chronological<decltype(v)>) {
            text << v.get();
        }
    });
    date.text = text.str();
    return date;
}

Node convert(const Text& source, const toml::node& value) {
    Node node = convert_value(source, value);
    node.place = place_of(source, value.source());
    return node;
}

/// "Error while parsing key: expected ..." says more without its head.
std::string plain_description(std::string_view description) {
    const std::size_t mark = description.find(": ");
    return std::string(
        description.starts_with("Error while parsing") && mark != std::string_view::npos ? description.substr(mark + 2)
                                                                                         : description
    );
}

} // namespace

std::optional<Node> read_toml(const Text& source, Problems& problems) {
    if (!check_encoding(source, problems)) {
        return std::nullopt;
    }
    if (source->text.find_first_not_of(" \t\r\n") == std::string::npos) {
        problems.error("E100", {source, 0, 0, 1}, "the file is empty", "suffuse new DIR writes a case to start from");
        return std::nullopt;
    }
    if (!check_toml_characters(source, problems)) {
        return std::nullopt;
    }
    try {
        const toml::table table = toml::parse(std::string_view(source->text), std::string_view(source->name));
        Node root = convert_table(source, table);
        root.place = {source, 0, 0, 1};
        return root;
    } catch (const toml::parse_error& error) {
        const std::string description = plain_description(error.description());
        const bool is_large = description.find("64 bits") != std::string::npos;
        problems.error(
            "E101", place_of(source, error.source()), description,
            is_large ? "a whole number goes up to 9223372036854775807"
                     : "a case is a TOML file: key = value, texts in quotes, tables in [brackets]"
        );
        return std::nullopt;
    }
}

} // namespace suffuse::casefile
