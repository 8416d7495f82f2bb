#pragma once
// The contact law of the paper: linear normal and shear springs with Coulomb slip, rolling and twisting resistance with
// plastic limits, adhesion that breaks; incremental [reference 1.2 and 1.3; PHYSICS A2]. A pure function of two grains
// and their memory, written over a lane type: `double`, or a pack of doubles whose comparisons make masks for `?:`.

#include "suffuse/grains/material.hpp"

#include <cmath>

namespace suffuse::contact {

/// A vector of lanes.
template <class Real>
struct Triple {
    Real x{}, y{}, z{};
};

template <class Real>
constexpr Triple<Real> operator+(const Triple<Real>& a, const Triple<Real>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class Real>
constexpr Triple<Real> operator-(const Triple<Real>& a, const Triple<Real>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class Real>
constexpr Triple<Real> operator*(const Real& s, const Triple<Real>& a) {
    return {s * a.x, s * a.y, s * a.z};
}

template <class Real>
constexpr Real dot(const Triple<Real>& a, const Triple<Real>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real>
constexpr Triple<Real> cross(const Triple<Real>& a, const Triple<Real>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Constants of the law, resolved from the material before the first step.
struct LawConstants {
    double twice_modulus = 0;      ///< 2 E [Pa]
    double shear_ratio = 0;        ///< [-]
    double tan_friction = 0;       ///< [-]
    double rolling_stiffness = 0;  ///< [-]
    double rolling_limit = 0;      ///< [-]
    double rolling_free = 0;       ///< added to the limit where there is none [N m]
    double twisting_stiffness = 0; ///< [-]
    double twisting_limit = 0;     ///< [-]
    double twisting_free = 0;      ///< [N m]
    double adhesion_normal = 0;    ///< [Pa]
    double adhesion_shear = 0;     ///< [Pa]
};

LawConstants resolve_law(const grains::Material& material);

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

inline double root(double a) {
    return std::sqrt(a);
}

/// Turns a stored force or moment with the contact: with the normal, and about it with the mean spin of the two grains.
template <class Real>
constexpr Triple<Real> turned(const Triple<Real>& stored, const Triple<Real>& swing, const Triple<Real>& twist) {
    const Triple<Real> once = stored - cross(stored, swing);
    return once - cross(once, twist);
}

/// Scales `v` back to the length `limit` where it is longer.
template <class Real>
inline Triple<Real> limited(const Triple<Real>& v, const Real& limit) {
    const Real length2 = dot(v, v);
    const Real scale = length2 > limit * limit ? limit / root(length2) : Real{} + 1.0;
    return scale * v;
}

/// One step of one contact; updates `memory`. `Adhesive` and `Twisting` leave out what no contact of the sample has.
/// @param dt time step [s]
template <bool Adhesive, bool Twisting, class Real>
inline ContactOutcome<Real> linear_rolling(
    const LawConstants& law, const Real& dt, const GrainPair<Real>& pair, ContactMemory<Real>& memory
) noexcept {
    const Real zero{}, one = zero + 1.0;
    const Real r1 = pair.radius_1, r2 = pair.radius_2, reach = r1 + r2;
    const Real smaller = r1 < r2 ? r1 : r2;
    const Real distance2 = dot(pair.branch, pair.branch);
    const Real distance = root(distance2);
    const Real overlap = reach - distance;
    const Real kn = law.twice_modulus * r1 * r2 / reach;
    const Real ks = law.shear_ratio * kn;
    const Real trial_normal = kn * overlap;

    // Does the pair touch? An old contact lives until its pull exceeds the adhesion (nothing, without adhesion).
    const Real was_touching = dot(memory.normal, memory.normal) > zero ? one : zero;
    Real bonded = zero, pull_off = zero, shear_strength = zero;
    if constexpr (Adhesive) {
        const Real bondable = zero + (law.adhesion_normal > 0 || law.adhesion_shear > 0 ? 1.0 : 0.0);
        bonded = was_touching > zero ? memory.bonded : bondable;
        pull_off = bonded * law.adhesion_normal * smaller * smaller;
        shear_strength = bonded * law.adhesion_shear * smaller * smaller;
    }
    const Real lives = zero - trial_normal > pull_off ? zero : one;
    const Real begins = reach * reach - distance2 >= zero ? one : zero;
    const Real touching = was_touching > zero ? lives : begins;

    // A pair that does not touch forgets everything and exerts nothing: exact zeros, so that it may stay in the list.
    const auto kept = [&](const Triple<Real>& v) {
        return Triple<Real>{touching > zero ? v.x : zero, touching > zero ? v.y : zero, touching > zero ? v.z : zero};
    };

    // Relative motion at the contact. The factor on the velocity removes granular ratcheting [reference 1.3, point 2].
    const Triple<Real> n = (one / distance) * pair.branch;
    const Triple<Real> lever = r2 * pair.spin_2 + r1 * pair.spin_1;
    const Triple<Real> slip_velocity = (reach / distance) * pair.velocity - cross(lever, n);
    const Triple<Real> slip = dt * (slip_velocity - dot(n, slip_velocity) * n);
    const Triple<Real> roll = dt * (pair.spin_2 - pair.spin_1);
    const Triple<Real> roll_twist = dot(n, roll) * n;

    const Triple<Real> swing = cross(memory.normal, n);
    const Triple<Real> twist = (0.5 * dt * dot(memory.normal, pair.spin_1 + pair.spin_2)) * memory.normal;

    // Shear force, cut at the Coulomb limit; a bond breaks there first.
    Triple<Real> shear = turned(memory.shear_force, swing, twist) - ks * slip;
    Real normal_force = trial_normal;
    Real slip_limit = shear_strength + trial_normal * law.tan_friction;
    slip_limit = slip_limit > zero ? slip_limit : zero;
    if constexpr (Adhesive) {
        const Real exceeds = dot(shear, shear) > slip_limit * slip_limit ? one : zero;
        Real broken_limit = trial_normal * law.tan_friction;
        broken_limit = broken_limit > zero ? broken_limit : zero;
        slip_limit = exceeds * bonded > zero ? broken_limit : slip_limit;
        normal_force = exceeds > zero ? (trial_normal < zero ? zero : trial_normal) : trial_normal;
        bonded = exceeds > zero ? zero : bonded;
    }
    shear = limited(shear, slip_limit);

    // Rolling and twisting moments, cut at their plastic limits.
    const Real carried = normal_force < zero ? zero - normal_force : normal_force;
    const Real arm_stiffness = ks * r1 * r2;
    Triple<Real> bending =
        turned(memory.bending, swing, twist) - (law.rolling_stiffness * arm_stiffness) * (roll - roll_twist);
    bending = limited(bending, law.rolling_limit * smaller * carried + law.rolling_free * touching);
    Triple<Real> moment = bending;
    if constexpr (Twisting) {
        Triple<Real> twisting =
            turned(memory.twisting, swing, twist) - (law.twisting_stiffness * arm_stiffness) * roll_twist;
        twisting = limited(twisting, law.twisting_limit * smaller * carried + law.twisting_free * touching);
        moment = bending + twisting;
        memory.twisting = kept(twisting);
    }

    memory.shear_force = kept(shear);
    memory.bending = kept(bending);
    memory.normal = kept(n);
    memory.bonded = touching * bonded;
    const Triple<Real> shear_arm = cross(n, shear);
    const Real half = 0.5 * overlap;
    return {
        kept(normal_force * n + shear), kept((half - r1) * shear_arm - moment), kept((half - r2) * shear_arm + moment),
        touching > zero ? overlap : zero};
}

} // namespace suffuse::contact
