#pragma once
// Figures of fines that migrate: how much leaves, and how permeable the soil is, against the gradient and over time.
// Tables and axes are in %.

#include "suffuse/erosion/migration_result.hpp"
#include "suffuse/figures/figure.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::figures {

/// What a stage found, under its name.
struct MigrationCurve {
    std::string name;
    erosion::MigrationResult result;
};

/// At the end of each gradient; nothing where no stage has two.
std::optional<Figure> migration_by_gradient(const std::vector<MigrationCurve>& curves);

/// In the soil's own time.
std::optional<Figure> migration_in_time(const std::vector<MigrationCurve>& curves);

} // namespace suffuse::figures
