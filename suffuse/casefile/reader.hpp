#pragma once
// One table of the tree -> the fields of a Spec, checked against the schema. A field that fails keeps its default and
// leaves a problem behind, so that one reading finds all of them. `Writer` has the same faces: see fields.hpp.

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/casefile/names.hpp"
#include "suffuse/casefile/node.hpp"
#include "suffuse/casefile/schema.hpp"
#include "suffuse/gradings/read_grading.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::casefile {

/// What all readers of one case share.
struct ReadContext {
    Problems& problems;
    std::string folder;                  ///< of the case file: relative paths start here
    std::map<std::string, Place> places; ///< "study.erosion.particles" -> where its value stands
    std::map<std::pair<std::string, gradings::CurveEnds>, std::optional<grains::Grading>>
        gradings;             ///< by path, and whether its ends may be open; empty where it could not be read
    bool is_resolved = false; ///< a run's own copy, and not what a user wrote
    std::optional<erosion::Gravity> gravity = {}; ///< of the case
};

class Reader {
public:
    static constexpr bool reads = true;

    /// `patterns` are the tables of the schema that this one may have keys of, the most special first; `path` is where
    /// it stands, "study.erosion.stage.initial".
    Reader(ReadContext& context, const Node& table, Place place, std::vector<std::string> patterns, std::string path);

    void field(std::string_view key, double& value);
    void field(std::string_view key, std::optional<double>& value);
    void field(std::string_view key, std::int64_t& value);
    void field(std::string_view key, std::optional<std::int64_t>& value);
    void field(std::string_view key, std::uint64_t& value);
    void field(std::string_view key, int& value);
    void field(std::string_view key, bool& value);
    void field(std::string_view key, std::string& value);
    void field(std::string_view key, std::vector<double>& value);
    void field(std::string_view key, std::vector<std::string>& value);
    void direction(Vec3& value, std::string_view key = "direction");

    /// 0 where the case says "computed".
    void time_step(double& value);

    template <class Value, class Words>
    void choice(std::string_view key, Value& value, const Words& words) {
        if (const Node* node = take(key)) {
            if (const auto found = find_word(key, *node, names::words_of(words))) {
                value = words[*found].value;
            }
        }
    }

    template <class Body>
    void table(std::string_view key, Body body) {
        if (const Node* node = take(key)) {
            inside(key, *node, body);
        }
    }

    template <class Value, class Body>
    void table(std::string_view key, std::optional<Value>& value, Body body) {
        if (const Node* node = take(key)) {
            value.emplace();
            inside(key, *node, [&](Reader& inner) { body(inner, *value); });
        }
    }

    /// A key that is read and written in its own way.
    template <class Read, class Write>
    void other(std::string_view key, Read read, Write) {
        if (const Node* node = take(key)) {
            read(*node);
        }
    }

    /// The value of a key, or null; a key that is requested counts as known, one that must be there and is not is a
    /// problem.
    const Node* take(std::string_view key);

    /// Reports the keys that nobody took. Call it once, last.
    void finish();

    // Values by themselves, for lists and special forms; empty where they are wrong, and then the problem is reported.
    std::optional<double> number(std::string_view key, const Node& node);
    std::optional<double> number(const Key& key, const Node& node);
    std::optional<std::int64_t> whole(std::string_view key, const Node& node);
    std::optional<std::string> text(std::string_view key, const Node& node);
    std::optional<std::size_t> find_word(std::string_view key, const Node& node, const std::vector<std::string>& words);
    const std::vector<Node>* list(std::string_view key, const Node& node);
    std::optional<Vec3> vector(std::string_view key, const Node& node);

    /// "`key` needs WHAT, and VALUE is KIND".
    void wrong_type(std::string_view key, const Node& node, const std::string& needed);

    void
    error(std::string code, const Place& place, std::string message, std::string help = {}, std::string label = {});

    [[nodiscard]] const Key& key_of(std::string_view key) const;

    [[nodiscard]] bool has(std::string_view key) const { return node_.find(key) != nullptr; }

    [[nodiscard]] const Place& place() const { return place_; }

    [[nodiscard]] const std::string& path() const { return path_; }

    /// "[contact]", "stage \"probe\" of [study.erosion]".
    [[nodiscard]] std::string title() const;

    [[nodiscard]] ReadContext& context() { return context_; }

private:
    template <class Body>
    void inside(std::string_view key, const Node& node, Body body) {
        if (!node.is_table()) {
            wrong_type(key, node, "a table, { ... }");
            return;
        }
        Reader inner(context_, node, node.place, inner_patterns(key), join(key));
        body(inner);
        inner.finish();
    }

    [[nodiscard]] std::vector<std::string> inner_patterns(std::string_view key) const;
    [[nodiscard]] std::string join(std::string_view key) const;
    [[nodiscard]] bool in_range(const Key& key, double value, const Node& node);
    void unknown_key(const Node::Entry& entry);
    bool is_retired(const Node::Entry& entry);

    ReadContext& context_;
    const Node& node_;
    Place place_;
    std::vector<std::string> patterns_;
    std::string path_;
    std::vector<std::string> taken_;
};

} // namespace suffuse::casefile
