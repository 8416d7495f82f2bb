#pragma once
// The gradient of upward seepage at which grains lose their weight: all of them [Terzaghi 1939], or the fines alone,
// which carry only a share of the stress [Skempton and Brogan 1994].

#include "suffuse/stability/criterion.hpp"
#include "suffuse/stability/flow_way.hpp"

#include <optional>

namespace suffuse::stability {

struct Seepage {
    double gradient = 0;                     ///< i of the water [-]
    double porosity = 0.40;                  ///< [-]
    double grain_density = 2650;             ///< [kg/m3]
    std::optional<double> stress_share = {}; ///< alpha: mean effective stress in the fines over that of the soil [-]
    std::optional<FlowWay> flow = {};        ///< not said: judged as upward

    [[nodiscard]] FlowWay way() const { return flow.value_or(upward); }

    /// Only then grains lose their weight.
    [[nodiscard]] bool lifts() const { return way().rise > 0; }
};

/// (Gs - 1)(1 - n): the gradient that carries the whole weight of the soil.
double terzaghi_gradient(double porosity, double grain_density);

/// Stable while i stays below (Gs - 1)(1 - n). The flow lifts; where it is inclined, it is unstable above that limit of
/// vertical flow, and below it the criterion cannot say.
Criterion terzaghi(const Seepage& seepage);

/// The same with alpha (Gs - 1)(1 - n). `by_shape` is what Kenney and Lau 1985 say: where the soil is
/// stable all grains carry, alpha = 1 [Skempton and Brogan 1994, abstract]. That is their stricter limit, H/F >= 1.3:
/// from 1 to 1.3 their two limits disagree, and to take alpha = 1 there would be to the unsafe side. Elsewhere alpha
/// must be known; without it the criterion cannot say, and gives the alpha that the fines would need.
Criterion skempton_brogan(const Seepage& seepage, Verdict by_shape);

} // namespace suffuse::stability
