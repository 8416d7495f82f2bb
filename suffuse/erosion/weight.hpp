#pragma once
// The weight of grains under water, and how much heavier grains may be made. Contacts
// are stiff and weights small: grains fall into place in time only where all forces are scaled up alike. Where they
// rest does not change with it as long as overlaps stay small (docs/theory/weight.md).

#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/heave.hpp"
#include "suffuse/erosion/spec.hpp"
#include "suffuse/flow/fluid.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::erosion {

/// Weight less buoyancy of each grain [N]. @throws CaseError where grains would not sink.
std::vector<Vec3> buoyant_weights(const dem::World& world, const Gravity& gravity, const flow::Fluid& fluid);

/// How weights and seepage forces are scaled, and the clock of the motion under them.
struct WeightScale {
    double factor = 1;       ///< of all forces from outside the skeleton: K [-]
    double acceleration = 0; ///< of a grain that falls freely, with it [m/s2]
    double time = 0;         ///< in which the median fine grain falls half its diameter: T [s]
    double drag = 0;         ///< viscous; falling grains get as fast as they are after a quarter of that diameter [1/s]
};

/// @param weight of each grain [N]; @param fines rows of the grain table, at least one
/// @param load_over_weight of the forces that are to press fines no further together than `softness` says
WeightScale scale_weight(
    const dem::World& world, std::span<const Vec3> weight, std::span<const std::uint32_t> fines,
    const WeighedMotion& motion = {}, double load_over_weight = 1
);

} // namespace suffuse::erosion
