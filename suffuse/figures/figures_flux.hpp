#pragma once
// How the water spreads over the throats, in each state of a run: flux against constriction size, and which share of
// the throats carries which share of the flow. Empty where no state has a flow.

#include "suffuse/figures/figure.hpp"
#include "suffuse/flow/throat_flux.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::figures {

struct FluxState {
    std::string name; ///< "before erosion", "after pass 2", a stage
    flow::ThroatFlux flux;
};

/// Ours: median and middle 80 % of the flux of throats of one size.
std::optional<Figure> flux_by_size(const std::vector<FluxState>& states);

/// Ours: distribution of the fluxes, and the share of the flow through the throats with most of it.
std::optional<Figure> flux_shares(const std::vector<FluxState>& states);

} // namespace suffuse::figures
