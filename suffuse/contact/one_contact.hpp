#pragma once
// One contact under whichever law its constants name: what the hot loop does to a tile, part after part. For what looks
// at single contacts, and as the slow way that the loop is tested against.

#include "suffuse/contact/linear_rolling.hpp"
#include "suffuse/contact/opening.hpp"
#include "suffuse/contact/springs.hpp"

namespace suffuse::contact {

/// First part: where the grains are against each other, with the normal force over the overlap as stiffness.
template <class Real>
ContactGeometry<Real>
find_geometry(const LawConstantsOf<Real>& law, const Triple<Real>& branch, const Real& r1, const Real& r2) noexcept {
    const Placement<Real> at = find_placement(branch, r1, r2);
    const Real stiffness = visit_spring(law.spring, [&](auto spring) {
        return spring.secant(law.spring_constants, r1, r2, at.per_reach, at.overlap);
    });
    return {at.normal, at.overlap, at.reach_over_distance, stiffness};
}

/// Stiffness at one overlap over that at another [-].
template <class Real>
Real stiffness_growth(const LawConstantsOf<Real>& law, const Real& overlap, const Real& other) noexcept {
    return visit_spring(law.spring, [&](auto spring) { return spring.growth(law.spring_constants, overlap, other); });
}

/// Takes from the memory what parting takes before a step. @param opening speed of parting [m/s]
template <class Real>
void let_go(
    const LawConstantsOf<Real>& law, const ContactGeometry<Real>& geometry, const Real& opening, const Real& dt,
    ContactMemory<Real>& memory
) noexcept {
    visit_spring(law.spring, [&]<class Spring>(Spring) {
        if constexpr (Spring::stiffens) {
            const Real left = left_by_parting<Spring>(law.spring_constants, geometry.overlap, opening, dt);
            memory.shear_force = left * memory.shear_force;
            memory.bending = left * memory.bending;
            memory.twisting = left * memory.twisting;
        }
    });
}

/// One step; updates `memory`. `Adhesive` and `Twisting` leave out what no contact of the sample has.
/// @param dt time step [s]
template <bool Adhesive, bool Twisting, class Real>
ContactOutcome<Real> act_between(
    const LawConstantsOf<Real>& law, const Real& dt, const GrainPair<Real>& pair, ContactMemory<Real>& memory
) noexcept {
    const ContactGeometry<Real> geometry = find_geometry(law, pair.branch, pair.radius_1, pair.radius_2);
    const Real opening = dot(geometry.normal, pair.velocity);
    let_go(law, geometry, opening, dt, memory);
    Limits<Real> limits = predict_forces<Adhesive, Twisting>(law, dt, pair, geometry, memory);
    if (law.viscosity > 0) {
        limits.normal_force += viscous_force(law, pair.radius_1, pair.radius_2, geometry.normal_stiffness, opening);
    }
    const Scales<Real> scales = find_scales(limits, memory.shear_force, memory.bending);
    return limit_forces<Twisting>(geometry, limits, scales, pair.radius_1, pair.radius_2, memory);
}

} // namespace suffuse::contact
