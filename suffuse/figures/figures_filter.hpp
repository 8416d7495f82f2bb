#pragma once
// Figures of a base and its filter: where the base is, a cut through both, and which of its sizes pass.

#include "suffuse/figures/figures_migration.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::figures {

/// Solid of filter and base over the depth, before and at the end: a panel a stage, of the first stages that are
/// stacks. Nothing without any; likewise the other two.
std::optional<Figure> filter_profile(const std::vector<MigrationCurve>& curves);

/// Grains as circles where a plane along the flow cuts them, before and after: a drawing of at most three stages.
std::optional<Figure> filter_cut(const std::vector<MigrationCurve>& curves);

/// Share of each size of the base that entered the filter, and that left it.
std::optional<Figure> filter_sizes(const std::vector<MigrationCurve>& curves);

} // namespace suffuse::figures
