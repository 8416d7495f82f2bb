#pragma once
// Short words in which the rows of the schema are written, for the schema's own files.

#include "suffuse/base/constants.hpp"
#include "suffuse/casefile/schema.hpp"

#include <iterator>
#include <utility>

namespace suffuse::casefile::detail {

inline constexpr Range any{};
inline constexpr Range above_zero{0, std::numeric_limits<double>::infinity(), true, false};
inline constexpr Range from_zero{0, std::numeric_limits<double>::infinity(), false, false};
inline constexpr Range share{0, 1, false, false};
inline constexpr Range open_share{0, 1, true, true};
inline constexpr Range friction_angle{0, pi / 2, false, true};
inline constexpr Range from_one{1, 1e15, false, false}; ///< counts: well inside what a double holds exactly
inline constexpr Range count_from_zero{0, 1e15, false, false};

inline void append(std::vector<Key>& rows, std::vector<Key> more) {
    rows.insert(rows.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

inline Key row(std::string_view table, std::string_view name, ValueKind kind, std::string_view text) {
    Key key;
    key.table = table;
    key.name = name;
    key.kind = kind;
    key.text = text;
    return key;
}

inline Key ranged(Key key, Range range) {
    key.range = range;
    return key;
}

inline Key text(std::string_view table, std::string_view name, std::string_view doc) {
    return row(table, name, ValueKind::Text, doc);
}

inline Key flag(std::string_view table, std::string_view name, std::string_view doc) {
    return row(table, name, ValueKind::Flag, doc);
}

inline Key direction(std::string_view table, std::string_view doc) {
    return row(table, "direction", ValueKind::Direction, doc);
}

inline Key table(std::string_view parent, std::string_view name, std::string_view doc) {
    return row(parent, name, ValueKind::Table, doc);
}

inline Key ratio(std::string_view table, std::string_view name, Range range, std::string_view doc) {
    return ranged(row(table, name, ValueKind::Ratio, doc), range);
}

inline Key count(std::string_view table, std::string_view name, Range range, std::string_view doc) {
    return ranged(row(table, name, ValueKind::Count, doc), range);
}

inline Key
quantity(std::string_view table, std::string_view name, Dimension dimension, Range range, std::string_view doc) {
    Key key = ranged(row(table, name, ValueKind::Quantity, doc), range);
    key.dimension = dimension;
    return key;
}

inline Key choice(std::string_view table, std::string_view name, std::vector<std::string> words, std::string_view doc) {
    Key key = row(table, name, ValueKind::Choice, doc);
    key.choices = std::move(words);
    return key;
}

inline Key other(std::string_view table, std::string_view name, std::string_view form, std::string_view doc) {
    Key key = row(table, name, ValueKind::Other, doc);
    key.form = form;
    return key;
}

inline Key list_of(Key key) {
    key.is_list = true;
    return key;
}

inline Key required(Key key) {
    key.is_required = true;
    return key;
}

/// A time step: a time, or "computed".
inline Key time_step(std::string_view table) {
    Key key = quantity(
        table, "time_step", dimension::time, above_zero, "Time step; \"computed\" takes it from the contact network."
    );
    key.form = "a time above 0 s, or \"computed\"";
    return key;
}

} // namespace suffuse::casefile::detail
