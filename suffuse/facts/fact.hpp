#pragma once
// What is known of a result besides its value: its key in files, its unit and its words. A result has one row, in one
// list of this room. What writes, reads, names and documents results goes through these lists.

#include <functional>
#include <string_view>
#include <tuple>

namespace suffuse::facts {

/// How tables, axes and cards give a number.
struct Shown {
    std::string_view name;   ///< "mean stress"; empty: they give it no name of its own
    std::string_view symbol; ///< "p"; empty where there is none
    std::string_view unit;   ///< "kPa" of what is in Pa, "%" of a share
    int digits = 4;          ///< significant
};

/// What it means that two runs differ in a number.
enum class Kind {
    Result,
    Computation, ///< how a result was reached: runs whose results agree may differ in it
    Origin,      ///< when, where and from what: not compared
};

struct Fact {
    std::string_view key;   ///< in stage.json; "fabric.deviator" is `deviator` in the object `fabric`
    std::string_view unit;  ///< SI, "-" for shares, ratios and counts, "" for what is no number
    std::string_view words; ///< for docs/results.md
    std::string_view saved; ///< in results.cbor; empty: not there
    Kind kind = Kind::Result;
    Shown shown = {};
};

/// A fact whose value a structure holds, or a function of it gives.
template <auto Value>
struct Row : Fact {
    static constexpr bool is_member = std::is_member_object_pointer_v<decltype(Value)>;

    [[nodiscard]] consteval Row as(Shown how) const {
        Row row = *this;
        row.shown = how;
        return row;
    }

    [[nodiscard]] consteval Row as(Kind what) const {
        Row row = *this;
        row.kind = what;
        return row;
    }

    template <class Of>
    static decltype(auto) of(Of&& structure) {
        return std::invoke(Value, std::forward<Of>(structure));
    }
};

/// A number that stage.json has under `key` and results.cbor, where it is a member, under the same name.
template <auto Value>
consteval Row<Value> row(std::string_view key, std::string_view unit, std::string_view words) {
    return {{key, unit, words, Row<Value>::is_member ? key : ""}};
}

/// The same, with another name in results.cbor.
template <auto Value>
consteval Row<Value> row(std::string_view key, std::string_view unit, std::string_view words, std::string_view saved) {
    return {{key, unit, words, saved}};
}

/// A member that results.cbor alone has.
template <auto Value>
consteval Row<Value> saved_alone(std::string_view name) {
    return {{"", "", "", name}};
}

/// Calls `see` with each row of a list.
template <class Rows, class See>
constexpr void for_each_row(const Rows& rows, See&& see) {
    std::apply([&](const auto&... row) { (see(row), ...); }, rows);
}

} // namespace suffuse::facts
