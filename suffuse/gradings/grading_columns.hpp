#pragma once
// Which column of a sheet holds the sizes and which the shares of each soil: by the headings, by a row of units below
// them, and where these do not say by numbers that can mean one thing only.

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/gradings/heading.hpp"
#include "suffuse/gradings/sheet.hpp"
#include "suffuse/gradings/sheet_values.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace suffuse::gradings {

struct SizeColumn {
    std::size_t index = 0;
    SizeScale scale = SizeScale::Unknown;
};

/// A unit of sizes that stands in a title, a comment or a heading above.
struct StatedUnit {
    SizeScale scale = SizeScale::Unknown;
    Place place;
};

struct ShareColumn {
    std::size_t index = 0;
    std::optional<std::size_t> tare = {}; ///< the column of masses to be taken off
    std::string name;                     ///< of its soil; empty where there is one alone
    ShareMeaning meaning = ShareMeaning::Passing;
    ShareUnit unit = ShareUnit::Unknown;
    bool is_named = true; ///< false: what it means was found in its numbers
    const char* mass_unit = "g";
    bool counts_grains = false; ///< shares of their number, not of their mass
    bool is_of_largest =
        false; ///< cumulative masses without a pan or total are shares of the largest: the user says so
};

struct GradingColumns {
    std::size_t first_row = 0; ///< of the values
    SizeColumn size;
    std::optional<std::size_t> upper = {}; ///< column of the coarser bounds, where the sizes are those of classes
    std::vector<ShareColumn> shares;       ///< one a soil, or one for all
    std::vector<std::size_t> sample_key;   ///< columns that say which soil a row belongs to
    StatedUnit stated_unit = {};           ///< of sizes whose heading gives none
    bool is_by_number = false;             ///< shares of the number of grains, not of their mass
    bool is_headed = true;                 ///< false: a remark already says that sizes are read in mm
};

constexpr const char* expected_header =
    "the first line names the columns: `d [mm],passing [%]`; also sieve, size or diameter, and finer, cumulative "
    "retained or retained on sieve; docs/gradings.md has an example of each kind";

/// Empty where a column is missing or two mean the same, which is reported.
std::optional<GradingColumns> find_grading_columns(const Sheet& sheet, Problems& problems);

/// Code of the remarks on how a sheet was read.
constexpr const char* sheet_remark = "W508";

} // namespace suffuse::gradings
