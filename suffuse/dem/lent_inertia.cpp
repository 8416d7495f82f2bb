#include "suffuse/dem/lent_inertia.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::dem {
namespace {

/// A grain's own frequency is as 1/r, its inertial number at its own mass as r: with (r_median/r)^2 times its mass it
/// has those of the median grain. The power of two below that.
double mass_factor(double median, double radius) {
    return radius < median ? std::exp2(std::floor(2 * std::log2(median / radius))) : 1;
}

/// Between that and its own: (r_median/r). The nearest power of two.
double gentle_mass_factor(double median, double radius) {
    return radius < median ? std::exp2(std::round(std::log2(median / radius))) : 1;
}

/// With that mass, a grain that rolls on the largest one has a frequency squared as 1/(r (r + r_largest)); with this
/// factor none is quicker than the median grain. The power of two above that.
double turning_factor(double median, double largest, double radius) {
    const double quicker = median * (median + largest) / (radius * (radius + largest));
    return slower_turning * slower_turning * (quicker > 1 ? std::exp2(std::ceil(std::log2(quicker))) : 1);
}

/// Whatever its mass m, a grain that rolls on the largest one, which stands, has a frequency squared as
/// r_largest^2/((r + r_largest) m), on its like as r/m. With this factor it rolls no quicker between two of the first,
/// where such grains are caught. The power of two above that.
double fines_turning_factor(double median, double largest, double radius) {
    const double quicker = 2 * largest * largest / (radius * (radius + largest));
    return radius < median ? std::exp2(std::ceil(std::log2(quicker))) : 1;
}

} // namespace

InertiaFactors lent_factors(const Lent& lent, double radius, double median, double largest) {
    const double mass = !lent.mass ? 1 : lent.gently ? gentle_mass_factor(median, radius) : mass_factor(median, radius);
    const double turning = lent.rotation         ? turning_factor(median, largest, radius)
                           : lent.fines_rotation ? fines_turning_factor(median, largest, radius)
                                                 : 1;
    return {mass, turning};
}

void lend_inertia(World& world, double median_diameter, const Lent& has, const Lent& wanted) {
    grains::Grains& grains = world.grains;
    if (has == wanted || grains.size() == 0) {
        return;
    }
    const double largest = *std::ranges::max_element(grains.radius);
    for (std::size_t g = 0; g < grains.size(); ++g) {
        const auto factors = [&](const Lent& lent) {
            return lent_factors(lent, grains.radius[g], median_diameter / 2, largest);
        };
        const InertiaFactors before = factors(has), after = factors(wanted);
        const double heavier = after.mass / before.mass; // powers of two: exact
        grains.mass[g] *= heavier;
        grains.inertia[g] *= heavier * (after.turning / before.turning);
    }
}

} // namespace suffuse::dem
