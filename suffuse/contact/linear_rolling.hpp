#pragma once
// The contact law of the paper: normal and shear springs with Coulomb slip, rolling and twisting resistance with
// plastic limits, adhesion that breaks; incremental [reference 1.2 and 1.3; PHYSICS A2]. A pure function of two grains
// and their memory, a template over the precision. How stiff the normal spring is comes from a spring of springs.hpp.

#include "suffuse/contact/lanes.hpp"
#include "suffuse/contact/law_constants.hpp"

#include <limits>

namespace suffuse::contact {

/// Two grains as the law sees them: `second` at the image that touches.
template <class Real>
struct GrainPair {
    Triple<Real> branch;         ///< x2 + h image - x1 [m]
    Triple<Real> velocity;       ///< v2 - v1, with the mean motion between periods [m/s]
    Triple<Real> spin_1, spin_2; ///< [rad/s]
    Real radius_1, radius_2;     ///< [m]
};

template <class Real>
struct ContactMemory {
    Triple<Real> shear_force; ///< acting on the second grain's side, see Contacts [N]
    Triple<Real> bending;     ///< [N m]
    Triple<Real> twisting;    ///< [N m]
    Triple<Real> normal;      ///< zero: the pair did not touch
    Real bonded;              ///< 1: adhesion not yet broken, 0: none
};

template <class Real>
struct ContactOutcome {
    Triple<Real> force;    ///< acting on the second grain; minus it acts on the first [N]
    Triple<Real> torque_1; ///< on the first grain [N m]
    Triple<Real> torque_2; ///< on the second grain [N m]
    Real overlap;          ///< [m]; zero where the pair does not touch
};

/// Sum of the components' magnitudes.
template <class Real>
[[gnu::always_inline]] inline Real size_1(const Triple<Real>& a) {
    return magnitude(a.x) + magnitude(a.y) + magnitude(a.z);
}

/// Turns a stored force or moment with the contact. `turn` is the sum of the swing of the normal and the twist about
/// it. The reference turns by one after the other; the difference is their product along the stored vector's component
/// on the normal, which is of second order itself: less than 1e-15 of the vector in a step.
/// @param kept 1 - turn^2/2: keeps the length to the fourth order of the angle, so that grains that spin fast gain no
/// energy; 1, to first order, as the reference
template <class Real>
[[gnu::always_inline]] inline Triple<Real>
turned(const Triple<Real>& stored, const Triple<Real>& turn, const Real& kept) {
    return kept * stored - cross(stored, turn);
}

/// Scales `v` back to the length `limit` where it is longer.
template <class Real>
[[gnu::always_inline]] inline Triple<Real> limited(const Triple<Real>& v, const Real& limit) {
    const Real length2 = dot(v, v);
    const Real scale = length2 > limit * limit ? limit / root(length2) : Real(1);
    return scale * v;
}

// The law has four parts. Each is short enough for a processor to have several contacts under way at once; a loop over
// many contacts runs the parts one after the other over a tile, `act_between` over one contact.

/// First part: where the grains are against each other.
template <class Real>
struct Placement {
    Triple<Real> normal;
    Real overlap;             ///< negative: a gap [m]
    Real reach_over_distance; ///< (r1 + r2) / distance [-]
    Real per_reach;           ///< 1/(r1 + r2), for the spring [1/m]
};

template <class Real>
[[gnu::always_inline]] inline Placement<Real>
find_placement(const Triple<Real>& branch, const Real& r1, const Real& r2) noexcept {
    const Real one(1), reach = r1 + r2;
    const Real distance = root(dot(branch, branch));
    const Real inverse = one / (reach * distance); // one division for both
    const Real inverse_distance = inverse * reach;
    return {inverse_distance * branch, reach - distance, reach * inverse_distance, inverse * distance};
}

/// The same with the stiffness of the spring.
template <class Real>
struct ContactGeometry {
    Triple<Real> normal;
    Real overlap;             ///< negative: a gap [m]
    Real reach_over_distance; ///< (r1 + r2) / distance [-]
    Real normal_stiffness;    ///< normal force over overlap [N/m]
};

/// What the second part leaves to the next ones: how far force and moments may go.
template <class Real>
struct Limits {
    Real normal_force;  ///< [N]
    Real slip, bending; ///< [N], [N m]
    Real twisting;      ///< [N m]
    Real touching;      ///< 1: force and memory, 0: none
};

/// What holds two grains together besides their springs.
template <class Real>
struct Bond {
    Real bonded{};         ///< 1: not broken, 0: none
    Real pull_off{};       ///< [N]
    Real shear_strength{}; ///< [N]
};

template <class Real>
[[gnu::always_inline]] inline Bond<Real> bond_between(
    const LawConstantsOf<Real>& law, const Real& was_touching, const Real& was_bonded, const Real& smaller
) noexcept {
    const Real zero{}, one(1);
    const Real bondable = law.adhesion_normal > 0 || law.adhesion_shear > 0 ? one : zero;
    const Real bonded = was_touching > zero ? was_bonded : bondable;
    return {bonded, bonded * law.adhesion_normal * smaller * smaller, bonded * law.adhesion_shear * smaller * smaller};
}

/// A bond breaks where the Coulomb limit is exceeded.
template <class Real>
[[gnu::always_inline]] inline void break_where_exceeded(
    const Triple<Real>& shear_force, const Real& friction, Bond<Real>& bond, Limits<Real>& limits
) noexcept {
    const Real zero{}, one(1), trial_normal = limits.normal_force;
    const Real exceeds = dot(shear_force, shear_force) > limits.slip * limits.slip ? one : zero;
    const Real broken_limit = friction > zero ? friction : zero;
    limits.slip = exceeds * bond.bonded > zero ? broken_limit : limits.slip;
    limits.normal_force = exceeds > zero ? (trial_normal < zero ? zero : trial_normal) : trial_normal;
    bond.bonded = exceeds > zero ? zero : bond.bonded;
}

/// Second part, the trial: turns the memory with the contact, and stretches its springs as if they had no limits.
/// @param dt time step [s]
template <bool Adhesive, bool Twisting, class Real>
[[gnu::always_inline]] inline Limits<Real> predict_forces(
    const LawConstantsOf<Real>& law, const Real& dt, const GrainPair<Real>& pair, const ContactGeometry<Real>& geometry,
    ContactMemory<Real>& memory
) noexcept {
    const Real zero{}, one(1);
    const Real r1 = pair.radius_1, r2 = pair.radius_2, smaller = r1 < r2 ? r1 : r2;
    const Real ks = law.shear_ratio * geometry.normal_stiffness;
    const Real trial_normal = geometry.normal_stiffness * geometry.overlap;
    const Triple<Real>& n = geometry.normal;
    Limits<Real> limits{};

    // Does the pair touch? It begins to where it overlaps, and an old contact lives until its pull exceeds the
    // adhesion.
    Bond<Real> bond;
    limits.touching = geometry.overlap >= zero ? one : zero;
    if constexpr (Adhesive) {
        const Real was_touching = size_1(memory.normal) > zero ? one : zero;
        bond = bond_between(law, was_touching, memory.bonded, smaller);
        const Real lives = zero - trial_normal > bond.pull_off ? zero : one;
        limits.touching = was_touching > zero ? lives : limits.touching;
    }

    // Relative motion at the contact. The factor on the velocity removes granular ratcheting [reference 1.3, point 2].
    const Triple<Real> lever = r2 * pair.spin_2 + r1 * pair.spin_1;
    const Triple<Real> slip_velocity = geometry.reach_over_distance * pair.velocity - cross(lever, n);
    const Triple<Real> slip = slip_velocity - dot(n, slip_velocity) * n;
    const Triple<Real> roll = pair.spin_2 - pair.spin_1;
    const Triple<Real> roll_twist = dot(n, roll) * n;

    const Real twist = Real(0.5) * dt * dot(memory.normal, pair.spin_1 + pair.spin_2);
    const Triple<Real> turn = cross(memory.normal, n) + twist * memory.normal;
    const Real kept = one - law.turning * dot(turn, turn);

    memory.shear_force = turned(memory.shear_force, turn, kept) - (dt * ks) * slip;
    limits.normal_force = trial_normal;
    const Real friction = trial_normal * law.tan_friction;
    limits.slip = bond.shear_strength + friction;
    limits.slip = limits.slip > zero ? limits.slip : zero;
    if constexpr (Adhesive) {
        break_where_exceeded(memory.shear_force, friction, bond, limits);
    }
    memory.bonded = limits.touching * bond.bonded;

    const Real carried = limits.normal_force < zero ? zero - limits.normal_force : limits.normal_force;
    const Real arm_stiffness = dt * ks * r1 * r2;
    memory.bending = turned(memory.bending, turn, kept) - (law.rolling_stiffness * arm_stiffness) * (roll - roll_twist);
    limits.bending = law.rolling_limit * smaller * carried + law.rolling_free * limits.touching;
    if constexpr (Twisting) {
        memory.twisting = turned(memory.twisting, turn, kept) - (law.twisting_stiffness * arm_stiffness) * roll_twist;
        limits.twisting = law.twisting_limit * smaller * carried + law.twisting_free * limits.touching;
    }
    return limits;
}

/// What brings shear force and bending moment back to their limits where they exceed them [-].
template <class Real>
struct Scales {
    Real shear_force, bending;
};

/// Third part: two roots and one division, which take long and keep little else busy.
template <class Real>
[[gnu::always_inline]] inline Scales<Real>
find_scales(const Limits<Real>& limits, const Triple<Real>& shear_force, const Triple<Real>& bending) noexcept {
    const Real one(1), tiny = std::numeric_limits<Real>::min(); // keeps a zero from dividing
    const Real force2 = dot(shear_force, shear_force), moment2 = dot(bending, bending);
    const Real force = root(force2 > tiny ? force2 : tiny), moment = root(moment2 > tiny ? moment2 : tiny);
    const Real inverse = one / (force * moment);
    return {
        force2 > limits.slip * limits.slip ? limits.slip * (moment * inverse) : one,
        moment2 > limits.bending * limits.bending ? limits.bending * (force * inverse) : one};
}

/// Fourth part: force and moments at their limits, and what the contact exerts. A pair that does not touch forgets
/// everything and exerts nothing: exact zeros, so that it may stay in the list.
template <bool Twisting, class Real>
[[gnu::always_inline]] inline ContactOutcome<Real> limit_forces(
    const ContactGeometry<Real>& geometry, const Limits<Real>& limits, const Scales<Real>& scales, const Real& r1,
    const Real& r2, ContactMemory<Real>& memory
) noexcept {
    const Real zero{}, touching = limits.touching;
    const auto kept = [&](const Triple<Real>& v) {
        return Triple<Real>{touching > zero ? v.x : zero, touching > zero ? v.y : zero, touching > zero ? v.z : zero};
    };
    const Triple<Real>& n = geometry.normal;
    memory.shear_force = scales.shear_force * memory.shear_force;
    memory.bending = scales.bending * memory.bending;
    Triple<Real> moment = memory.bending;
    if constexpr (Twisting) {
        memory.twisting = limited(memory.twisting, limits.twisting);
        moment = moment + memory.twisting;
        memory.twisting = kept(memory.twisting);
    }
    const Triple<Real> shear_arm = cross(n, memory.shear_force);
    const Real half = Real(0.5) * geometry.overlap;
    const ContactOutcome<Real> outcome{
        kept(limits.normal_force * n + memory.shear_force), kept((half - r1) * shear_arm - moment),
        kept((half - r2) * shear_arm + moment), touching > zero ? geometry.overlap : zero};
    memory.shear_force = kept(memory.shear_force);
    memory.bending = kept(memory.bending);
    memory.normal = kept(n);
    return outcome;
}

template <class Real>
struct Push {
    Triple<Real> force; ///< acting on the second grain [N]
    Real touching;      ///< 1: force and memory, 0: none
};

/// What is left of the law where contacts only push: nothing adheres, no friction, no memory of shear or turning, no
/// spin. The same bits as the whole law.
template <class Real>
[[gnu::always_inline]] inline Push<Real> push(const ContactGeometry<Real>& geometry) noexcept {
    const Real zero{}, one(1), touching = geometry.overlap >= zero ? one : zero;
    const Real trial = geometry.normal_stiffness * geometry.overlap;
    return {(touching > zero ? trial : zero) * geometry.normal, touching};
}

} // namespace suffuse::contact
