#include "suffuse/dem/lent_inertia.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::dem {
namespace {

constexpr double rotation_factor = 4; // of grains of the median size and above

/// A grain's own frequency is as 1/r, its inertial number at its own mass as r: with (r_median/r)^2 times its mass it
/// has those of the median grain. The power of two below that.
double mass_factor(double median, double radius) {
    return radius < median ? std::exp2(std::floor(2 * std::log2(median / radius))) : 1;
}

/// With that mass, a grain that rolls on the largest one has a frequency squared as 1/(r (r + r_largest)); with this
/// factor none is quicker than the median grain. The power of two above that.
double turning_factor(double median, double largest, double radius) {
    const double quicker = median * (median + largest) / (radius * (radius + largest));
    return rotation_factor * (quicker > 1 ? std::exp2(std::ceil(std::log2(quicker))) : 1);
}

} // namespace

void lend_inertia(World& world, double median_diameter, const Lent& has, const Lent& wanted) {
    grains::Grains& grains = world.grains;
    if (grains.size() == 0) {
        return;
    }
    const double median = median_diameter / 2, largest = *std::ranges::max_element(grains.radius);
    for (std::size_t g = 0; g < grains.size(); ++g) {
        const double radius = grains.radius[g];
        const double heavier = has.mass == wanted.mass ? 1 : mass_factor(median, radius);
        const double turning = has.rotation == wanted.rotation ? 1 : turning_factor(median, largest, radius);
        const double mass = wanted.mass ? heavier : 1 / heavier;
        grains.mass[g] *= mass;
        grains.inertia[g] *= mass * (wanted.rotation ? turning : 1 / turning);
    }
}

} // namespace suffuse::dem
