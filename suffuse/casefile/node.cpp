#include "suffuse/casefile/node.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace suffuse::casefile {

namespace {

std::string print_text(std::string_view text) {
    std::string printed = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            printed += '\\';
            printed += c;
        } else if (code < 0x20 || code == 0x7f) {
            printed += fmt::format("\\u{:04x}", code);
        } else {
            printed += c;
        }
    }
    return printed + '"';
}

std::string print_key(const std::string& key) {
    const bool is_bare = !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
    });
    return is_bare ? key : print_text(key);
}

std::string print_number(double number) {
    const std::string text = fmt::format("{}", number);
    // Without a point or an exponent it would be read back as an integer.
    return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

bool is_list_of_tables(const Node& node) {
    return node.is_array() && !node.items.empty() &&
           std::all_of(node.items.begin(), node.items.end(), [](const Node& item) { return item.is_table(); });
}

/// Values on their line, then lists of tables under headers of their own.
void print_entries(const Node& table, const std::string& path, std::string& out) {
    for (const auto& [key, place, value] : table.entries) {
        if (!is_list_of_tables(value)) {
            out += fmt::format("{} = {}\n", print_key(key), print_value(value));
        }
    }
    for (const auto& [key, place, value] : table.entries) {
        if (!is_list_of_tables(value)) {
            continue;
        }
        const std::string inner = fmt::format("{}.{}", path, print_key(key));
        for (const Node& item : value.items) {
            out += fmt::format("\n[[{}]]\n", inner);
            print_entries(item, inner, out);
        }
    }
}

} // namespace

const Node::Entry* Node::find(std::string_view key) const {
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.key == key; });
    return found == entries.end() ? nullptr : &*found;
}

Node::Entry* Node::find(std::string_view key) {
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.key == key; });
    return found == entries.end() ? nullptr : &*found;
}

void Node::set(std::string_view key, Node value, Place key_place) {
    if (Entry* entry = find(key)) {
        entry->value = std::move(value);
        if (key_place.source) {
            entry->place = std::move(key_place);
        }
        return;
    }
    entries.push_back({std::string(key), std::move(key_place), std::move(value)});
}

Node make_node(const Scalar& value) {
    Node node;
    if (const auto* flag = std::get_if<bool>(&value)) {
        node.kind = Node::Kind::Flag;
        node.flag = *flag;
    } else if (const auto* integer = std::get_if<std::int64_t>(&value)) {
        node.kind = Node::Kind::Integer;
        node.integer = *integer;
    } else if (const auto* number = std::get_if<double>(&value)) {
        node.kind = Node::Kind::Number;
        node.number = *number;
    } else {
        node.kind = Node::Kind::Text;
        node.text = std::get<std::string>(value);
    }
    return node;
}

Node make_node(const char* text) {
    return make_node(Scalar(std::string(text)));
}

Node make_array(std::vector<Node> items) {
    Node node;
    node.kind = Node::Kind::Array;
    node.items = std::move(items);
    return node;
}

Scalar scalar_of(const Node& node) {
    switch (node.kind) {
    case Node::Kind::Flag:
        return node.flag;
    case Node::Kind::Integer:
        return node.integer;
    case Node::Kind::Number:
        return node.number;
    default:
        return node.text;
    }
}

std::string print_value(const Node& node) {
    std::string list;
    const auto add = [&](const std::string& text) { list += (list.empty() ? "" : ", ") + text; };
    switch (node.kind) {
    case Node::Kind::Table:
        for (const auto& [key, place, value] : node.entries) {
            add(print_key(key) + " = " + print_value(value));
        }
        return list.empty() ? "{}" : "{ " + list + " }";
    case Node::Kind::Array:
        for (const Node& item : node.items) {
            add(print_value(item));
        }
        return "[" + list + "]";
    case Node::Kind::Text:
        return print_text(node.text);
    case Node::Kind::Integer:
        return fmt::format("{}", node.integer);
    case Node::Kind::Number:
        return print_number(node.number);
    case Node::Kind::Flag:
        return node.flag ? "true" : "false";
    case Node::Kind::Date:
        return node.text;
    }
    return {};
}

std::string print_file(const Node& root) {
    std::string out;
    for (const auto& [key, place, value] : root.entries) {
        if (!value.is_table()) {
            out += fmt::format("{} = {}\n", print_key(key), print_value(value));
        }
    }
    for (const auto& [key, place, value] : root.entries) {
        if (!value.is_table()) {
            continue;
        }
        const bool has_members = key == "soil" || key == "study" || key == "presets";
        if (!has_members) {
            out += fmt::format("\n[{}]\n", print_key(key));
            print_entries(value, print_key(key), out);
            continue;
        }
        for (const auto& [name, name_place, member] : value.entries) {
            const std::string path = print_key(key) + "." + print_key(name);
            out += fmt::format("\n[{}]\n", path);
            print_entries(member, path, out);
        }
    }
    return out;
}

} // namespace suffuse::casefile
