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

/// Which columns a curve came from, and as what they were read.
struct SheetReading {
    std::string size, size_unit; ///< heading as written, and "mm", "um", "phi"
    std::string share;           ///< heading as written
    std::string kind;            ///< "percent passing", "retained on each sieve alone"
    std::string share_unit;      ///< "%", "mass", "number"
    std::string flag;            ///< that asks for this kind: "passing", "retained", "share", "mass"
};

/// "sizes: Sieve (mm), in mm; shares: Weight (%), read as retained on each sieve alone, in %".
std::string words_of(const SheetReading& reading);

} // namespace suffuse::gradings
