#pragma once
// How the paper's findings on erosion fare by each reading of what the paper leaves open.

#include "suffuse/figures/page_table.hpp"
#include "suffuse/study/findings_by_seed.hpp"

#include <optional>
#include <vector>

namespace suffuse::answer {

/// A row a reading, a column a finding; nothing for fewer than two readings.
std::optional<figures::PageTable> tabulate_readings(const std::vector<study::Reading>& readings);

} // namespace suffuse::answer
