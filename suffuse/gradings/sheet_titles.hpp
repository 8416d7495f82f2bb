#pragma once
// What titles around a table say: of which sample it is, the dry mass of that, and whether a hydrometer measured it.

#include "suffuse/gradings/grading_columns.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::gradings {

/// "Sample: TP1 0.5 m", "Borehole,BH3": the name; empty where the row gives none.
std::string sample_named_in(const SheetRow& row);

/// "Dry mass of specimen (g): 500", "Masse s\u00e8che totale;1600 g" [kg].
std::optional<double> dry_mass_in(const Sheet& sheet, const SheetRow& row);

/// The dry mass that the rows agree on; empty where they state none, or several.
std::optional<double> find_dry_mass(const Sheet& sheet, const std::vector<const SheetRow*>& rows);

/// "Sizes in um", "Grain size: mm": the last one that the rows from `begin` to before `end` give, else the one before.
StatedUnit find_size_unit(const Sheet& sheet, std::size_t begin, std::size_t end, const StatedUnit& before = {});

/// "Sedimentation", "HYDROMETER (mm)".
bool names_hydrometer(const SheetRow& row);

} // namespace suffuse::gradings
