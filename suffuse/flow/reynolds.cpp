#include "suffuse/flow/reynolds.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <cmath>

namespace suffuse::flow {

double sauter_diameter(std::span<const double> radius) {
    double cubes = 0, squares = 0;
    for (const double r : radius) {
        cubes += r * r * r;
        squares += r * r;
    }
    return squares > 0 ? 2 * cubes / squares : 0;
}

double conductivity(double permeability, const Fluid& fluid) {
    return permeability * fluid.density * gravity / fluid.viscosity;
}

double reynolds_number(double permeability, double gradient, double diameter, const Fluid& fluid) {
    return fluid.density * conductivity(permeability, fluid) * std::abs(gradient) * diameter / fluid.viscosity;
}

double share_left_by_inertia(double reynolds, double porosity) {
    const double inertial_over_viscous = 1.75 * reynolds / (150 * (1 - porosity)); // both of the slow flow's flux
    return 2 / (1 + std::sqrt(1 + 4 * inertial_over_viscous));
}

std::string words_of_inertia(const std::string& where, double gradient, double reynolds, double porosity) {
    constexpr double slow_enough = 0.9;
    const double left = share_left_by_inertia(reynolds, porosity);
    if (!(left < slow_enough)) {
        return {};
    }
    return fmt::format(
        "at i = {:.3g} the water {} has a Reynolds number of {}: its inertia, which slow flow neglects, would reduce "
        "the flux to about {:.0f} % (Ergun); the reported permeability is that of slow flow; the fluid forces still "
        "balance the gradient",
        gradient, where, short_number(reynolds, 2), 100 * left
    );
}

} // namespace suffuse::flow
