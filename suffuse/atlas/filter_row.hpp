#pragma once
// The atlas of filters: which share of a base passes its filter. A row is one sample at one gradient, made by
// validation/filter_atlas.py: a uniform base of 1.3 D15 thickness on four layers of a uniform filter, water going down.
// The rows lie in filters.csv and are built into the program.

#include <cstdint>
#include <string_view>
#include <vector>

namespace suffuse::atlas {

struct FilterRow {
    double ratio = 0; ///< D15 of the filter over d85 of the base [-]
    double width = 0; ///< d85/d15 of the base [-]
    int seed = 0;
    double gradient = 0; ///< of the base, which bore the lower ones before [-]
    std::int64_t grains = 0;
    double thickness = 0;    ///< of the base over D15 [-]
    double constriction = 0; ///< controlling one of the filter over D15 [-]
    double passed = 0;       ///< shares of the base's mass: through the filter, [-]
    double moving = 0;       ///< at the end of the hold, [-]
    double entered = 0;      ///< beyond the interface [-]
    bool ended = false;      ///< motion ended; otherwise what passed is a lower bound
    double overlap = 0;      ///< largest of the run, over a radius [-]
};

/// @throws CaseError with the line where a cell is missing or is no number.
std::vector<FilterRow> parse_filter_rows(std::string_view csv);

/// The rows that are built in, and the text that they were read from.
const std::vector<FilterRow>& shipped_filter_rows();
std::string_view shipped_filter_table();

} // namespace suffuse::atlas
