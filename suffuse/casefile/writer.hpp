#pragma once
// The fields of a Spec -> one table of the tree, units by the schema: the way back of `Reader`, with the same faces.

#include "suffuse/casefile/names.hpp"
#include "suffuse/casefile/node.hpp"
#include "suffuse/casefile/schema.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::casefile {

class Writer {
public:
    static constexpr bool reads = false;

    explicit Writer(std::vector<std::string> patterns) : patterns_(std::move(patterns)) {}

    void field(std::string_view key, double value);
    void field(std::string_view key, const std::optional<double>& value);
    void field(std::string_view key, std::int64_t value);
    void field(std::string_view key, const std::optional<std::int64_t>& value);
    void field(std::string_view key, std::uint64_t value);
    void field(std::string_view key, int value);
    void field(std::string_view key, bool value);
    void field(std::string_view key, const std::string& value);
    void field(std::string_view key, const std::vector<double>& value);
    void field(std::string_view key, const std::vector<std::string>& value);
    void direction(const Vec3& value, std::string_view key = "direction");
    void time_step(double value);

    template <class Value, class Words>
    void choice(std::string_view key, const Value& value, const Words& words) {
        set(key, make_node(Scalar(names::word_for(words, value))));
    }

    template <class Body>
    void table(std::string_view key, Body body) {
        Writer inner(inner_patterns(key));
        body(inner);
        if (!inner.node_.entries.empty()) {
            set(key, std::move(inner.node_));
        }
    }

    template <class Value, class Body>
    void table(std::string_view key, std::optional<Value>& value, Body body) {
        if (value) {
            table(key, [&](Writer& inner) { body(inner, *value); });
        }
    }

    template <class Read, class Write>
    void other(std::string_view key, Read, Write write) {
        if (std::optional<Node> node = write()) {
            set(key, std::move(*node));
        }
    }

    void set(std::string_view key, Node node) { node_.set(key, std::move(node)); }

    /// A number as the key wants it: bare, or a text with its unit.
    [[nodiscard]] Node number(std::string_view key, double value) const;

    [[nodiscard]] Node vector(std::string_view key, const Vec3& value) const;

    /// The table written so far.
    [[nodiscard]] const Node& node() const { return node_; }

private:
    [[nodiscard]] const Key& key_of(std::string_view key) const;
    [[nodiscard]] std::vector<std::string> inner_patterns(std::string_view key) const;

    std::vector<std::string> patterns_;
    Node node_;
};

} // namespace suffuse::casefile
