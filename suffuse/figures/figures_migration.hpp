#pragma once
// Figures of fines that migrate: how much leaves, and how permeable the soil is, against the gradient, the power of the
// flow, over time and along the flow. Tables and axes are in %.

#include "suffuse/erosion/migration_result.hpp"
#include "suffuse/figures/figure.hpp"
#include "suffuse/figures/line_fit.hpp"

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

/// What each gradient that was held spent and took.
struct RatesByPower {
    std::vector<double> gradient;    ///< [-]
    std::vector<double> power, rate; ///< means over the hold: of the flow [W], and of the mass that left [kg/s]
};

RatesByPower rates_by_power(const erosion::MigrationResult& result);

/// A point a gradient, and a line where the points of a stage carry one; nothing where nothing left.
std::optional<Figure> migration_by_power(const std::vector<MigrationCurve>& curves);

/// Porosity, fines and permeability over the way of the water, before and at the ends of gradients, of the first stage
/// that has them.
std::optional<Figure> migration_profiles(const std::vector<MigrationCurve>& curves);

} // namespace suffuse::figures
