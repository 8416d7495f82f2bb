#pragma once
// What the speed at which two grains part does to their contact, besides its springs: a spring that stiffens with the
// overlap lets go of shear [Mindlin 1949; as simplified by Agnolin and Roux 2007, appendix A], and dashpots damp.

#include "suffuse/contact/lanes.hpp"
#include "suffuse/contact/law_constants.hpp"

namespace suffuse::contact {

/// What is left of the shear force and the moments of the step before [-]: as two grains part, their contact area
/// shrinks, and takes with it the share of the springs that it held. Where they approach, the new area is free of
/// shear. So no path closed in overlap and slip gains energy. @param opening speed of parting [m/s]; @param dt time
/// step [s]
template <class Spring, class Real>
[[gnu::always_inline]] inline Real left_by_parting(
    const SpringConstantsOf<Real>& constants, const Real& overlap, const Real& opening, const Real& dt
) noexcept {
    const Real zero{}, one(1), before = overlap + dt * opening;
    return opening > zero && overlap > zero ? Spring::growth(constants, overlap, before) : one;
}

/// Normal force by which two grains resist their approach [N]: the given share of the critical damping, 2 sqrt(m k), of
/// the pair at the stiffness that it has now. It pulls as they part. Masses are those of whole spheres.
template <class Real>
[[gnu::always_inline]] inline Real viscous_force(
    const LawConstantsOf<Real>& law, const Real& r1, const Real& r2, const Real& normal_stiffness, const Real& opening
) noexcept {
    const Real ratio = r1 / r2, reduced = r1 * r1 * r1 / (Real(1) + ratio * ratio * ratio); // of r1^3 and r2^3
    return Real{} - law.viscosity * root(reduced * normal_stiffness) * opening;
}

} // namespace suffuse::contact
