#include "suffuse/dem/lent_inertia.hpp"

#include <cmath>

namespace suffuse::dem {
namespace {

constexpr double rotation_factor = 4;

/// A grain's own frequency is as 1/r, its inertial number at its own mass as r: with (r_median/r)^2 times its mass it
/// has those of the median grain. The power of two below that.
double mass_factor(double median, double radius) {
    return radius < median ? std::exp2(std::floor(2 * std::log2(median / radius))) : 1;
}

} // namespace

void lend_inertia(World& world, double median_diameter, const Lent& has, const Lent& wanted) {
    grains::Grains& grains = world.grains;
    const double turn = (wanted.rotation ? rotation_factor : 1) / (has.rotation ? rotation_factor : 1);
    for (std::size_t g = 0; g < grains.size(); ++g) {
        const double heavier = has.mass == wanted.mass ? 1 : mass_factor(median_diameter / 2, grains.radius[g]);
        const double factor = wanted.mass ? heavier : 1 / heavier;
        grains.mass[g] *= factor;
        grains.inertia[g] *= factor * turn;
    }
}

} // namespace suffuse::dem
