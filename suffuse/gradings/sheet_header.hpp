#pragma once
// The rows above the values of a table: titles, which say of which sample it is, its dry mass, the unit of sizes and
// whether a hydrometer measured it; the row that names its columns; and a row of units below that.

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/gradings/grading_columns.hpp"
#include "suffuse/gradings/heading.hpp"
#include "suffuse/gradings/sheet.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace suffuse::gradings {

struct SheetHeader {
    std::size_t row = 0;
    std::size_t lines = 1; ///< headings may go on in the next row: "Sieve" above "(mm)"
    std::vector<Heading> headings;
    bool is_complete = false; ///< a size and a share
};

/// The first complete row of headings, else the first with a size; a comment counts where no other line does.
std::optional<SheetHeader> find_sheet_header(const Sheet& sheet);

/// "# 4,60", which split_sheet() takes for a comment, is a sieve under a heading of sieves without a unit.
void take_numbered_sieves(Sheet& sheet);

/// The columns of a kind, rising.
std::vector<std::size_t> columns_of_kind(const std::vector<Heading>& headings, ColumnKind kind);

/// Whether a row names a size and a share.
bool is_complete_header(const SheetRow& row);

/// "mm,%": a row without a number, in which every cell is a unit. @return whether it is one, and was taken
bool take_unit_row(const SheetRow& row, std::vector<Heading>& headings);

/// More columns than a table of gradings has, which is reported.
bool is_too_wide(const Sheet& sheet, Problems& problems);

/// Rows that are looked through for headings.
constexpr std::size_t most_titles = 60;

/// "Sample: TP1 0.5 m", "Borehole,BH3": the name; empty where the row gives none.
std::string sample_named_in(const SheetRow& row);

/// "Dry mass of specimen (g): 500", "Masse s\u00e8che totale;1600 g" [kg].
std::optional<double> dry_mass_in(const Sheet& sheet, const SheetRow& row);

/// The dry mass that the rows agree on; empty where they state none, or several.
std::optional<double> find_dry_mass(const Sheet& sheet, const std::vector<const SheetRow*>& rows);

/// Where a mass is stated that is not known to be that of the whole sample, as "Weight (g),500", or one of several.
std::optional<Place> find_unused_mass(const Sheet& sheet, const std::vector<const SheetRow*>& rows);

/// "Sizes in um", "Grain size: mm": the last one that the rows from `begin` to before `end` give, else the one before.
StatedUnit find_size_unit(const Sheet& sheet, std::size_t begin, std::size_t end, const StatedUnit& before = {});

/// "Particle radius (um)", "ln d".
bool names_no_diameter(const Heading& heading, std::string_view text);

void complain_about_diameters(const Place& place, std::string_view heading, Problems& problems);

/// "Sedimentation", "HYDROMETER (mm)".
bool names_hydrometer(const SheetRow& row);

} // namespace suffuse::gradings
