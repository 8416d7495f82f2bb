#pragma once
// The linear normal spring of the paper, kn = 2 E r1 r2/(r1 + r2) [reference 1.2], and all that a spring must provide.

#include "suffuse/base/constants.hpp"
#include "suffuse/contact/spring.hpp"

#include <cmath>

namespace suffuse::contact {

struct LinearSpring {
    static constexpr grains::ContactLaw law = grains::ContactLaw::LinearRolling;
    static constexpr SpringWords words{
        .name = "linear-rolling",
        .summary = "linear springs, adhesion",
        .modulus = "E of the normal stiffness kn = 2 E r1 r2/(r1 + r2)",
        .shear_key = "shear_ratio",
        .shear = "`shear_ratio` is its shear stiffness / normal stiffness; or take law = \"hertz-mindlin\""};
    static constexpr bool stiffens = false, may_adhere = true;

    static SpringConstants constants(const grains::Material& material) { return {2 * material.modulus}; }

    static double exponent(const grains::Material&) { return 1; }

    static double shear_ratio(const grains::Material& material) { return material.shear_ratio; }

    /// Grains whose centers coincide push with 2 E r2.
    static double most_stress(const grains::Material& material) { return 2 * material.modulus; }

    static double tangent(const grains::Material& material, double r1, double r2, double) {
        return 2 * material.modulus * r1 * r2 / (r1 + r2); // the bits of the reference's
    }

    /// Without overlap the spring pulls, where a bond holds it.
    static double force(const grains::Material& material, double r1, double r2, double overlap) {
        return tangent(material, r1, r2, overlap) * overlap;
    }

    static double energy(const grains::Material& material, double r1, double r2, double overlap) {
        const double push = force(material, r1, r2, overlap);
        return 0.5 * (push * push) / tangent(material, r1, r2, overlap);
    }

    static double overlap_under(const grains::Material& material, double stress) { return stress / material.modulus; }

    static double overlap_of_impact(const grains::Material& material, double speed2) {
        return std::sqrt(material.density * sphere_volume(1) * speed2 / material.modulus);
    }

    static double stiffness_to_pressure(const grains::Material& material, double pressure) {
        return material.modulus / (2 * pressure);
    }

    /// Force over overlap [N/m]. @param per_reach 1/(r1 + r2), which the geometry has at hand [1/m]
    template <class Real>
    [[gnu::always_inline]] static Real
    secant(const SpringConstantsOf<Real>& k, const Real& r1, const Real& r2, const Real& per_reach, const Real&) noexcept {
        return k[0] * r1 * r2 * per_reach;
    }

    /// Stiffness at one overlap over that at another [-].
    template <class Real>
    [[gnu::always_inline]] static Real growth(const SpringConstantsOf<Real>&, const Real&, const Real&) noexcept {
        return Real(1);
    }
};

} // namespace suffuse::contact
