#pragma once
// Every key that a case may have, once: the reader's checks, `explain`, and the reference page come from this table.
// Defaults are those of the Specs themselves.

#include "suffuse/base/units.hpp"

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::casefile {

enum class ValueKind {
    Text,
    Choice,    ///< one of a list of words
    Count,     ///< a whole number
    Ratio,     ///< a bare number, or one with %
    Quantity,  ///< a text with a unit
    Flag,      ///< true or false
    Direction, ///< "x", "-z", or three numbers
    Table,
    Other, ///< `form` says how it is written
};

struct Range {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool without_least = false, without_most = false; ///< the bound itself is not allowed

    [[nodiscard]] bool contains(double value) const {
        return (without_least ? value > least : value >= least) && (without_most ? value < most : value <= most);
    }
};

struct Key {
    std::string table; ///< "" = top of the file, "contact", "soil.*", "stage", "stage.compact", "stage.erode.detached"
    std::string name;
    ValueKind kind = ValueKind::Text;
    bool is_list = false; ///< a list of such values
    Dimension dimension;
    Range range;
    std::vector<std::string> choices;
    bool is_required = false;
    std::string form;         ///< how it is written, where `kind` does not say
    std::string text;         ///< one sentence
    std::string default_text; ///< as it would be written; empty where there is none
};

/// The table, in the order of the reference page.
const std::vector<Key>& schema();

/// The key of one table pattern, or null.
const Key* find_key(std::string_view table, std::string_view name);

/// "stage.compact" -> "a stage that does \"compact\""; "soil.*" -> "a soil".
std::string table_title(std::string_view table);

/// "[soil.NAME] fines_content": where a key stands in a file.
std::string key_place(const Key& key);

/// "a pressure, above 0 kPa", "one of mean, median": what may be written.
std::string value_text(const Key& key);

/// "above 0 kPa", "from 0 to 1"; empty where everything goes.
std::string range_text(const Key& key);

/// The reference page of the case file, in Markdown.
std::string schema_markdown();

namespace detail {
/// The rows without their defaults, by part of the file.
std::vector<Key> general_rows();
std::vector<Key> soil_and_study_rows();
std::vector<Key> preparation_rows();
std::vector<Key> test_rows();
std::vector<Key> erosion_rows();
std::vector<Key> output_rows();
std::vector<Key> calibrate_rows();
} // namespace detail

} // namespace suffuse::casefile
