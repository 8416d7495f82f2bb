#pragma once
// The normal spring of elastic spheres [Hertz 1882], with the shear stiffness of Mindlin 1949 without slip, and all
// that a spring must provide: force H sqrt(R overlap) overlap, R = r1 r2/(r1 + r2).

#include "suffuse/base/constants.hpp"
#include "suffuse/contact/lanes.hpp"
#include "suffuse/contact/spring.hpp"

#include <cmath>
#include <numbers>

namespace suffuse::contact {

/// H of the normal force: (2/3) E/(1 - nu^2) [Pa]
inline double hertz_modulus(const grains::Material& material) {
    return 2.0 / 3.0 * material.modulus / (1 - material.poisson * material.poisson);
}

struct HertzSpring {
    static constexpr grains::ContactLaw law = grains::ContactLaw::HertzMindlin;
    static constexpr NeededKey modulus_of_grains[] = {
        {"modulus", "the `modulus` of the grains", "Young's modulus, as in modulus = \"70 GPa\" of quartz or glass"}};
    static constexpr SpringWords words{
        .name = "hertz-mindlin",
        .summary = "elastic spheres",
        .modulus = "Young's modulus of the grains, as \"70 GPa\" of quartz or glass, which must be given",
        .shear_key = "poisson",
        .shear = "its shear stiffness follows from `poisson`, Poisson's ratio of the grains",
        .needs = modulus_of_grains};
    static constexpr bool stiffens = true, may_adhere = false;

    static SpringConstants constants(const grains::Material& material) { return {hertz_modulus(material)}; }

    static double exponent(const grains::Material&) { return 1.5; }

    static double shear_ratio(const grains::Material& material) {
        return 2 * (1 - material.poisson) / (2 - material.poisson);
    }

    /// Grains whose centers coincide push with 2 H r2.
    static double most_stress(const grains::Material& material) { return 2 * hertz_modulus(material); }

    static double tangent(const grains::Material& material, double r1, double r2, double overlap) {
        const double equivalent = r1 * r2 / (r1 + r2);
        return overlap > 0 ? 1.5 * hertz_modulus(material) * std::sqrt(equivalent * overlap) : 0;
    }

    static double force(const grains::Material& material, double r1, double r2, double overlap) {
        return tangent(material, r1, r2, overlap) * overlap / 1.5;
    }

    static double energy(const grains::Material& material, double r1, double r2, double overlap) {
        return 0.4 * force(material, r1, r2, overlap) * overlap;
    }

    static double overlap_under(const grains::Material& material, double stress) {
        const double root = std::cbrt(std::numbers::sqrt2 * stress / hertz_modulus(material)); // R = r/2
        return root * root;
    }

    /// m v^2/2 = (2/5) H sqrt(r/2) overlap^(5/2).
    static double overlap_of_impact(const grains::Material& material, double speed2) {
        const double mass_r3 = material.density * sphere_volume(1);
        return std::pow(1.25 * std::numbers::sqrt2 * mass_r3 * speed2 / hertz_modulus(material), 0.4);
    }

    /// [Agnolin and Roux 2007]: (E/((1 - nu^2) p))^(2/3), where E/(1 - nu^2) = 1.5 H.
    static double stiffness_to_pressure(const grains::Material& material, double pressure) {
        return std::cbrt(std::pow(1.5 * hertz_modulus(material) / pressure, 2));
    }

    /// Force over overlap [N/m]; zero where the pair does not touch.
    template <class Real>
    [[gnu::always_inline]] static Real secant(
        const SpringConstantsOf<Real>& k, const Real& r1, const Real& r2, const Real&, const Real& overlap
    ) noexcept {
        return k[0] * root(r1 * r2 / (r1 + r2) * (overlap > Real{} ? overlap : Real{}));
    }

    /// Stiffness at one overlap over that at another [-].
    template <class Real>
    [[gnu::always_inline]] static Real
    growth(const SpringConstantsOf<Real>&, const Real& overlap, const Real& other) noexcept {
        return root(overlap / other);
    }
};

} // namespace suffuse::contact
