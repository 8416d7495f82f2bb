#pragma once
// A case file as a neutral tree: tables, arrays and values, each with the place where it was written.

#include "suffuse/base/place.hpp"
#include "suffuse/casefile/case.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace suffuse::casefile {

struct Node {
    enum class Kind { Table, Array, Text, Integer, Number, Flag, Date };
    struct Entry;

    Kind kind = Kind::Table;
    Place place;
    std::string text;
    std::int64_t integer = 0;
    double number = 0;
    bool flag = false;
    std::vector<Node> items;    ///< of an array
    std::vector<Entry> entries; ///< of a table, in the order of the file

    [[nodiscard]] bool is_table() const { return kind == Kind::Table; }

    [[nodiscard]] bool is_array() const { return kind == Kind::Array; }

    [[nodiscard]] bool is_text() const { return kind == Kind::Text; }

    [[nodiscard]] bool is_scalar() const { return !is_table() && !is_array(); }

    [[nodiscard]] const Entry* find(std::string_view key) const;
    [[nodiscard]] Entry* find(std::string_view key);

    /// Sets the entry, in its old place where there is one.
    void set(std::string_view key, Node value, Place key_place = {});
};

struct Node::Entry {
    std::string key;
    Place place;
    Node value;
};

Node make_node(const Scalar& value);
Node make_node(const char* text);
Node make_array(std::vector<Node> items);

/// The value of a node that is neither a table, an array nor a date.
Scalar scalar_of(const Node& node);

/// The node as it would be written behind "key = ".
std::string print_value(const Node& node);

/// A whole case file: [contact], [soil.NAME], [[study.NAME.stage]] have headers, smaller tables stay on one line.
std::string print_file(const Node& root);

} // namespace suffuse::casefile
