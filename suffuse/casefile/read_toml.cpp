#include "suffuse/casefile/read_toml.hpp"

#include "suffuse/base/read_text.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/io/text_file.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <sstream>
#include <string_view>

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

struct Slip {
    std::string message, help;
};

/// What is wrong with `key = value`, where it is one of the slips that people make most, and of which the parser
/// reports only how it stumbled: a text or a unit without quotes, a quote that is missing at the end, a decimal comma.
std::optional<Slip> find_slip(std::string_view line) {
    const std::size_t mark = line.find('=');
    const std::string_view key = io::trimmed(line.substr(0, mark));
    const std::string_view whole = mark == std::string_view::npos ? "" : io::trimmed(line.substr(mark + 1));
    constexpr std::size_t longest = 200; // of a line, or the message would bury what it says
    if (whole.empty() || line.size() > longest || std::string_view("[{").find(whole[0]) != std::string_view::npos) {
        return std::nullopt;
    }
    const char quote = whole[0];
    if (quote == '"' || quote == '\'') {
        const bool is_open = whole.find(quote, 1) == std::string_view::npos;
        return is_open ? std::optional(Slip{"the text is not closed", fmt::format("end it on its line with {}", quote)})
                       : std::nullopt;
    }
    const std::string_view value = io::trimmed(whole.substr(0, whole.find('#')));
    const std::size_t comma = value.find(',');
    const bool is_decimal = comma != std::string_view::npos && comma > 0 && comma + 1 < value.size() &&
                            is_digit(value[comma - 1]) && is_digit(value[comma + 1]);
    if (is_decimal) {
        return Slip{fmt::format("{} has a decimal comma", value), "write a decimal point"};
    }
    if (edit_distance(value, "true") == 0 || edit_distance(value, "false") == 0) { // in capitals
        return Slip{fmt::format("{} is no value", value), "write true or false, in small letters"};
    }
    const bool has_letter =
        std::ranges::any_of(value, [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%'; });
    return has_letter ? std::optional(Slip{
                            fmt::format("{} is neither a number nor a text in quotes", value),
                            fmt::format("write {} = \"{}\"", key, value)})
                      : std::nullopt;
}

/// Why the text is no TOML, and one thing to do.
Slip explain_error(const Text& source, const toml::parse_error& error) {
    const std::string plain = plain_description(error.description());
    if (plain.find("64 bits") != std::string::npos) {
        return {plain, "a whole number goes up to 9223372036854775807"};
    }
    if (plain.find("escape sequence") != std::string::npos) {
        return {plain, "in a path write / for \\, or put the text between single quotes"};
    }
    const bool is_known = plain.find("redefine") != std::string::npos;
    const auto slip =
        is_known ? std::nullopt : find_slip(line_of(*source, static_cast<int>(error.source().begin.line)));
    return slip.value_or(Slip{plain, "a case is a TOML file: key = value, texts in quotes, tables in [brackets]"});
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
        const Slip slip = explain_error(source, error);
        problems.error("E101", place_of(source, error.source()), slip.message, slip.help);
        return std::nullopt;
    }
}

} // namespace suffuse::casefile
