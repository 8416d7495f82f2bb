#include "suffuse/erosion/weight.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/quantile.hpp"
#include "suffuse/contact/springs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::erosion {

std::vector<Vec3> buoyant_weights(const dem::World& world, const Gravity& gravity, const flow::Fluid& fluid) {
    const double excess = world.material.density - fluid.density;
    if (!(excess > 0)) {
        throw CaseError(fmt::format(
            "grain.density: found {:.6g} kg/m3 in a fluid of {:.6g} kg/m3, expected more than that: grains that do not "
            "sink have no submerged weight; change the densities, or leave [gravity] out",
            world.material.density, fluid.density
        ));
    }
    std::vector<Vec3> weight;
    weight.reserve(world.grains.size());
    for (const double r : world.grains.radius) {
        weight.push_back((excess * gravity.acceleration * sphere_volume(r)) * gravity.down);
    }
    return weight;
}

WeightScale scale_weight(
    const dem::World& world, std::span<const Vec3> weight, std::span<const std::uint32_t> fines,
    const WeighedMotion& motion, double load_over_weight
) {
    const grains::Grains& grains = world.grains;
    const contact::Spring& spring = contact::spring_of(world.material);
    WeightScale scale;
    scale.factor = std::numeric_limits<double>::infinity();
    std::vector<double> diameter;
    for (const std::uint32_t g : fines) {
        const double r = grains.radius[g];
        scale.factor =
            std::min(scale.factor, spring.force(world.material, r, r, motion.softness * r) / norm(weight[g]));
        diameter.push_back(2 * r);
    }
    scale.factor /= load_over_weight;
    const double median = upper_quantile(std::move(diameter), 0.5);
    scale.acceleration = scale.factor * norm(weight[fines.front()]) / grains.mass[fines.front()]; // the same for all
    scale.time = std::sqrt(median / scale.acceleration);
    scale.drag = motion.fluid_drag * std::sqrt(scale.acceleration / (0.5 * median));
    return scale;
}

} // namespace suffuse::erosion
