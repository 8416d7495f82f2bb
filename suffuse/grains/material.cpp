#include "suffuse/grains/material.hpp"

#include <cmath>

namespace suffuse::grains {
namespace {

constexpr double contacts_per_grain = 4; // of the grains that carry load
constexpr double usual_porosity = 0.4;

} // namespace

double shear_ratio(const Material& material) {
    return material.law == ContactLaw::HertzMindlin ? 2 * (1 - material.poisson) / (2 - material.poisson)
                                                    : material.shear_ratio;
}

double hertz_modulus(const Material& material) {
    return 2.0 / 3.0 * material.modulus / (1 - material.poisson * material.poisson);
}

double overlap_under(const Material& material, double stress) {
    if (material.law == ContactLaw::LinearRolling) {
        return stress / material.modulus;
    }
    const double root = std::cbrt(std::numbers::sqrt2 * stress / hertz_modulus(material)); // R = r/2
    return root * root;
}

double mean_overlap_at(const Material& material, double pressure) {
    // Mean force of equal spheres: p pi d^2/(Z (1 - n)).
    return overlap_under(material, 4 * pi / (contacts_per_grain * (1 - usual_porosity)) * pressure);
}

Material linearized(const Material& material, double relative_overlap) {
    Material linear = material;
    if (material.law == ContactLaw::HertzMindlin) {
        linear.law = ContactLaw::LinearRolling;
        linear.modulus = 0.75 * hertz_modulus(material) * std::sqrt(2 * relative_overlap); // of equal grains
        linear.shear_ratio = shear_ratio(material);
    }
    return linear;
}

} // namespace suffuse::grains
