#pragma once
// What the removal of all fines cost each mixture, as a table: what finding M9 is judged from.

#include "suffuse/report/findings_fines.hpp"
#include "suffuse/report/page_table.hpp"

#include <optional>

namespace suffuse::report {

/// A row for each fines content at the isotropic state, then under a deviator; means over the seeds. Nothing without
/// removals.
std::optional<PageTable> removal_table(const std::vector<Removal>& removals);

} // namespace suffuse::report
