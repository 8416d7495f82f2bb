#pragma once
// What the removal of all fines cost each mixture, as a table: what finding M9 is judged from.

#include "suffuse/figures/page_table.hpp"
#include "suffuse/study/findings_fines.hpp"

#include <optional>

namespace suffuse::answer {

/// A row for each fines content at the isotropic state, then under a deviator; means over the seeds. Nothing without
/// removals.
std::optional<figures::PageTable> removal_table(const std::vector<study::Removal>& removals);

} // namespace suffuse::answer
