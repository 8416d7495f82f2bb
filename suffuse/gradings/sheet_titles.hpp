#pragma once
// What titles around a table say: of which sample it is, the dry mass of that, and whether a hydrometer measured it.

#include "suffuse/gradings/sheet.hpp"

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

/// "Sedimentation", "HYDROMETER (mm)".
bool names_hydrometer(const SheetRow& row);

} // namespace suffuse::gradings
