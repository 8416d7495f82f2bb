#pragma once
// Stiffness and normal force of contacts, and the stiffness of their network, seen as a continuum.

#include "suffuse/cell/cell.hpp"
#include "suffuse/contact/contacts.hpp"
#include "suffuse/grains/grains.hpp"
#include "suffuse/grains/material.hpp"

namespace suffuse::contact {

/// Of a network whose grains move with the mean strain: upper bounds of the true moduli.
struct AffineModuli {
    /// Along each axis: the sum over contacts of |branch|^2 (kn n_a^4 + ks n_a^2 (1 - n_a^2)) / V [Pa].
    Vec3 longitudinal{};
    /// Of the pairs of axes yz, zx, xy: of |branch|^2 (kn n_a^2 n_b^2 + ks ((n_a^2 + n_b^2)/4 - n_a^2 n_b^2)) / V [Pa].
    Vec3 shear{};
};

inline AffineModuli operator+(const AffineModuli& a, const AffineModuli& b) {
    return {a.longitudinal + b.longitudinal, a.shear + b.shear};
}

AffineModuli
affine_moduli(const grains::Grains& grains, const Contacts& contacts, const grains::Material& material, const Mat3& h);

/// The same where the memory of the contacts is elsewhere.
template <class Real>
AffineModuli affine_moduli(
    const grains::Grains& grains, const ContactPairs& contacts, const MemoryOf<Real>& memory,
    const grains::Material& material, const Mat3& h
);

/// Normal stiffness of a pair of radii, d(force)/d(overlap) [N/m]: that of the linear law, 2 E r1 r2/(r1 + r2), is the
/// same at any overlap (reference 1.2).
double normal_stiffness(const grains::Material& material, double r1, double r2, double overlap);

/// Elastic normal force of row `c` in the last step, without what damps it, compression positive [N]. A bond that broke
/// under tension carries no pull any more, though the contact lives until the next step.
double
normal_force(const grains::Grains& grains, const Contacts& contacts, const grains::Material& material, std::size_t c);

} // namespace suffuse::contact
