#pragma once
// How a flow spreads over the throats of its network: the distribution of their fluxes, what the largest carry, and
// flux against constriction size. Ratios to the mean flux, which do not depend on the gradient: the flow is linear in
// it.

#include "suffuse/pores/network.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::flow {

/// Without a flow all is zero or empty.
struct ThroatFlux {
    std::int64_t throats = 0;     ///< open ones; cuts through one body of water are none
    double mean = 0;              ///< of the fluxes' sizes, at a hydraulic gradient of 1 [m3/s]
    double half_carried_by = 0;   ///< the smallest share of the throats through which half of the flow goes [-]
    std::vector<double> quantile; ///< flux/mean at shares 0, 1/100, ... 1 of the throats, smallest first [-]
    std::vector<double> carried;  ///< share of the flow through those shares of the throats, largest first [-]
    std::vector<double> diameter; ///< of the inscribed circle: median of each class of equally many throats [m]
    std::vector<double> flux_10, flux_50, flux_90; ///< flux/mean of each class: quantiles [-]
};

/// `flux`: per throat under the hydraulic gradient `gradient` [m3/s]. A flux of 0 everywhere gives no shares.
ThroatFlux describe_fluxes(const pores::PoreNetwork& network, std::span<const double> flux, double gradient);

} // namespace suffuse::flow
