#pragma once
// Sizes of the constrictions of a soil from its grading alone, without a packing [Silveira 1965, 1975]: the densest
// soil is made of triples of touching grains, the loosest of quadruples that leave as much room as they can; grains
// meet in proportion to their surface area [Humes 1996]; relative density interpolates [Locke et al. 2001] [Indraratna
// 2007].

#include "suffuse/grains/soil.hpp"
#include "suffuse/stability/criterion.hpp"
#include "suffuse/stability/fine_fraction.hpp"

#include <optional>
#include <vector>

namespace suffuse::stability {

/// Diameter of the circle between three touching grains [m] [Descartes' circle theorem].
double dense_constriction(double d1, double d2, double d3);

/// Diameter of the circle of the same area as the largest void that four grains can leave, each touching the next in
/// this order [m]. Four equal grains: they form a square, sqrt(4/pi - 1) of their diameter.
double loose_constriction(double d1, double d2, double d3, double d4);

/// A distribution of sizes by number, as values at equal steps of the share.
class SizeDistribution {
public:
    /// `sizes` [m] with their shares, in any order.
    explicit SizeDistribution(std::vector<std::pair<double, double>> sizes_and_shares);

    /// The size [m] below which `share` of the constrictions lie; linear between the middles of the steps.
    [[nodiscard]] double at(double share) const;

private:
    std::vector<double> size_, share_; // share_: up to the middle of the step
};

struct ConstrictionSizes {
    SizeDistribution densest, loosest;

    /// At a relative density from 0 to 1: D = D_densest + p (1 - I_D)(D_loosest - D_densest) with p the share [m].
    [[nodiscard]] double at(double share, double relative_density) const;
};

/// Constrictions among the grains of a grading.
ConstrictionSizes model_constrictions(const grains::Grading& grading);

/// What the model says of a soil split into fines and skeleton.
struct FinesAgainstConstrictions {
    double split = 0;                              ///< [m]
    double densest_d35 = 0, loosest_d35 = 0;       ///< controlling constriction of the coarse part [m]
    double fines_d85 = 0;                          ///< d85 of the fine part by surface area [m]
    double densest_passes = 0, loosest_passes = 0; ///< share of the fines' mass smaller than it [-]
};

/// Split at the fine fraction's limit, or at `otherwise` [m], where H/F is least.
FinesAgainstConstrictions
compare_with_constrictions(const grains::Grading& grading, const std::optional<FineFraction>& fines, double otherwise);

/// Stable where Dc35/d85f <= 1: the size that 35 % of the constrictions of the coarse part undercut, and d85 of the
/// fine part by surface area [Indraratna et al. 2011]. Without a relative density it says stable or unstable only where
/// that holds from the loosest to the densest state; its number is then that of the loosest.
Criterion indraratna(const FinesAgainstConstrictions& sizes, std::optional<double> relative_density);

} // namespace suffuse::stability
