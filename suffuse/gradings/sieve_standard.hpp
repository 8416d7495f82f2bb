#pragma once
// Whose numbers sieves have: No. 8 is 2.36 mm by ASTM E11 and another opening by BS 410 or Tyler. Only those of ASTM
// are known here.

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/gradings/sheet_tables.hpp"

#include <vector>

namespace suffuse::gradings {

/// Refuses numbers of sieves where a heading, title or comment names another standard, and remarks on mesh numbers of
/// which nothing says that they are ASTM's.
/// @param tables of the sheet, with their columns
void check_sieve_standard(const Sheet& sheet, const std::vector<SheetTable>& tables, Problems& problems);

} // namespace suffuse::gradings
