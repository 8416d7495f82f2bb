#pragma once
// The first line of a sieve analysis: which column holds the sizes and which the shares, what the shares are, and in
// which unit.

#include "suffuse/base/units.hpp"
#include "suffuse/io/csv_table.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace suffuse::io {

/// `Retained` does not say whether on the sieve alone or on it and all coarser ones.
enum class Meaning { Other, Size, Passing, CumulativeRetained, RetainedOnSieve, Retained };

struct Column {
    std::size_t index = 0;
    std::string name; ///< as written
    std::string unit;
    bool names_unit = false;   ///< false: the usual one
    bool each_has_own = false; ///< a unit stands at every number
    Dimension dimension = {};  ///< of its numbers: what sieves retain may be a mass
};

struct Columns {
    Column size, share;
    Meaning meaning = Meaning::Passing; ///< of the share
};

constexpr std::string_view expected_header = "the first line names the columns: `d [mm],passing [%]`; also size, sieve "
                                             "or diameter, and finer, cumulative retained or retained on sieve; titles "
                                             "above it begin with #";

/// Empty where the header does not say both, which is reported.
std::optional<Columns> read_grading_header(const CsvRow& header, Problems& problems);

} // namespace suffuse::io
