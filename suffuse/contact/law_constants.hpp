#pragma once
// What a contact law takes from the material. Apart from the laws, so that what steps a world need not be compiled anew
// with each change of one.

#include "suffuse/contact/spring.hpp"

#include <algorithm>

namespace suffuse::contact {

/// Constants of the law, resolved from the material before the first step.
template <class Real>
struct LawConstantsOf {
    grains::ContactLaw spring{}; ///< which one of springs.hpp
    SpringConstantsOf<Real> spring_constants{};
    Real most_stress{};  ///< no mean stress of grains reaches it, nor their force over the square of the radius [Pa]
    Real shear_ratio{};  ///< shear stiffness over normal force/overlap [-]
    Real viscosity{};    ///< of `viscous_force` [(kg/m3)^1/2]
    Real tan_friction{}; ///< [-]
    Real rolling_stiffness{};  ///< [-]
    Real rolling_limit{};      ///< [-]
    Real rolling_free{};       ///< added to the limit where there is none [N m]
    Real twisting_stiffness{}; ///< [-]
    Real twisting_limit{};     ///< [-]
    Real twisting_free{};      ///< [N m]
    Real adhesion_normal{};    ///< [Pa]
    Real adhesion_shear{};     ///< [Pa]
    Real turning{0.5};         ///< of memory: 0.5 keeps its length to second order; 0, to first, as the reference's

    template <class Other>
    [[nodiscard]] LawConstantsOf<Other> as() const {
        // A limit beyond any moment is one in every precision, and zero times it is zero.
        const auto other = [](Real a) { return static_cast<Other>(a < Real(1e30) ? a : Real(1e30)); };
        SpringConstantsOf<Other> constants{};
        std::ranges::transform(spring_constants, constants.begin(), other);
        return {
            spring,
            constants,
            other(most_stress),
            other(shear_ratio),
            other(viscosity),
            other(tan_friction),
            other(rolling_stiffness),
            other(rolling_limit),
            other(rolling_free),
            other(twisting_stiffness),
            other(twisting_limit),
            other(twisting_free),
            other(adhesion_normal),
            other(adhesion_shear),
            other(turning)};
    }
};

using LawConstants = LawConstantsOf<double>;

/// @throws CaseError where grains are to adhere under a law whose springs only push
LawConstants resolve_law(const grains::Material& material);

} // namespace suffuse::contact
