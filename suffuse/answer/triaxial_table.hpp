#pragma once
// The table of all triaxial tests: a row for each at one set of sweep values, over its replicates.

#include "suffuse/figures/page_table.hpp"
#include "suffuse/study/run_results.hpp"

#include <optional>
#include <vector>

namespace suffuse::answer {

/// Strength, deformation, and failure under loads that stay. A cell is empty where the test does not show the number:
/// strength where it stops at a stress, dilatancy at constant volume and below 2 % of strain, instability where water
/// drains: single rows of a loose sample that gives way in bursts are none. Columns that would be empty
/// are left out; nothing without a test.
std::optional<figures::PageTable> tabulate_tests(const study::RunResults& results);

} // namespace suffuse::answer
