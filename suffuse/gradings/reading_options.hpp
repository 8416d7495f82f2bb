#pragma once
// What a user says of a file whose headings and numbers leave its reading open: which columns hold the sizes and the
// shares, in which units, and which lines are the table.

#include "suffuse/gradings/heading.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace suffuse::gradings {

/// As typed. A column is COLUMN[:UNIT]: its heading or its number from 1; `all` for every column of shares, `across`
/// for sizes that are in the columns of a line.
struct ReadingOptions {
    std::string size, passing, retained, share, mass;
    std::string by;                    ///< mass, or number: shares of the number of grains
    std::optional<std::int64_t> sheet; ///< the table of the file, from 1
    std::string rows;                  ///< A-B: lines of the file

    [[nodiscard]] bool is_empty() const;
    [[nodiscard]] bool name_columns() const;
};

/// As flags of a command: "--size 1:mm --share 2".
std::string command_words(const ReadingOptions& options);

/// COLUMN[:UNIT]. What follows a colon and is no unit belongs to the name.
struct NamedColumn {
    std::string name, unit;
};

NamedColumn split_column(const std::string& text);

/// The lines A-B; empty where the text says none.
std::optional<std::pair<int, int>> split_lines(const std::string& text);

} // namespace suffuse::gradings
