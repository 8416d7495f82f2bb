#pragma once
// One grain's motion over one step (leapfrog), in a cell that deforms: damped acceleration, convection by the cell's
// mean motion, and the change of that mean motion [reference 1.4]. Pure functions; the loop over grains is in dem.

#include "suffuse/base/double4.hpp"
#include "suffuse/base/vec3.hpp"

namespace suffuse::motion {

/// What is the same for all grains in a step, over the vector type of the loop that moves them.
template <class Vec, class Matrix>
struct alignas(double4_alignment) MotionOf {
    double dt = 0;       ///< [s]
    double damping = 0;  ///< local, non-viscous: share of the force taken where it does positive work [-]
    double drag = 0;     ///< viscous: deceleration / velocity relative to the mean motion; relaxation only [1/s]
    Matrix old_gradient; ///< velocity gradient of the cell until this step [1/s]
    Matrix change;       ///< new gradient minus old one [1/s]
    Vec spin_change;     ///< spin of `change` [rad/s]
};

using StepMotion = MotionOf<Vec3, Mat3>;

// A grain's three components at once, with the same bits; in a cell whose edges keep their directions, matrices are
// diagonal.
using LaneMotion = MotionOf<Double4, Double4x3>;
using DiagonalMotion = MotionOf<Double4, Double4>;

inline StepMotion
plan_motion(double dt, double damping, double drag, const Mat3& old_gradient, const Mat3& new_gradient) {
    const Mat3 change = new_gradient - old_gradient;
    // Axial vector of the antisymmetric part.
    const Vec3 spin{
        0.5 * (change(2, 1) - change(1, 2)), 0.5 * (change(0, 2) - change(2, 0)), 0.5 * (change(1, 0) - change(0, 1))};
    return {dt, damping, drag, old_gradient, change, spin};
}

inline LaneMotion in_lanes(const StepMotion& m) {
    return {m.dt, m.damping, m.drag, double4x3(m.old_gradient), double4x3(m.change), double4(m.spin_change, 0)};
}

inline DiagonalMotion in_diagonals(const StepMotion& m) {
    return {m.dt,
            m.damping,
            m.drag,
            double4_diagonal(m.old_gradient),
            double4_diagonal(m.change),
            double4(m.spin_change, 0)};
}

/// Local damping [Cundall & Strack 1979]: the acceleration grows where it brakes and shrinks where it drives. The
/// mid-step velocity decides, per component.
[[gnu::always_inline]] inline double damped(double acceleration, double velocity, double dt, double damping) {
    const double power = acceleration * (velocity + 0.5 * dt * acceleration);
    const double sense =
        static_cast<double>(power > 0) - static_cast<double>(power < 0); // no branch: it goes either way
    return acceleration * (1 - damping * sense);
}

[[gnu::always_inline]] inline Vec3 damped(const Vec3& a, const Vec3& v, double dt, double damping) {
    return {damped(a.x, v.x, dt, damping), damped(a.y, v.y, dt, damping), damped(a.z, v.z, dt, damping)};
}

[[gnu::always_inline]] inline Double4 damped(const Double4& a, const Double4& v, double dt, double damping) {
    const Double4 zero{}, one = zero + 1.0;
    const Double4 power = a * (v + 0.5 * dt * a);
    const Double4 driven = one - damping,
                  braked = one + damping; // chosen, not computed from the sense: the same bits sooner
    return a * (power > zero ? driven : (power < zero ? braked : one));
}

/// Moves a grain that contacts and loads alone would accelerate by `push` [m/s2]. `free` is 1, or 0 for a held grain
/// (whose `push` and `turn` are zero), which keeps its own velocity and spin and is carried along by the cell as any
/// other.
template <class Vec, class Matrix, class Scalar>
[[gnu::always_inline]] inline void
shift(const MotionOf<Vec, Matrix>& step, const Vec& push, const Scalar& free, Vec& position, Vec& velocity) {
    const Vec fluctuation = velocity - step.old_gradient * position;
    Vec acceleration = damped(push, fluctuation, step.dt, step.damping);
    if (step.drag > 0) {
        acceleration -= free * step.drag * fluctuation;
    }
    acceleration += step.old_gradient * velocity;
    velocity += step.dt * acceleration;
    velocity += step.change * position;
    position += step.dt * velocity;
}

/// The same for its spin; contacts and loads alone would change that by `turn` [rad/s2].
template <class Vec, class Matrix, class Scalar>
[[gnu::always_inline]] inline void
spin_on(const MotionOf<Vec, Matrix>& step, const Vec& turn, const Scalar& free, Vec& spin) {
    Vec spin_up = damped(turn, spin, step.dt, step.damping);
    if (step.drag > 0) {
        spin_up -= free * step.drag * spin;
    }
    spin += step.dt * spin_up;
    spin += step.spin_change;
}

/// What these do, to the bit, to a grain that nothing pushes or turns.
template <class Vec, class Matrix, class Scalar>
[[gnu::always_inline]] inline void
coast(const MotionOf<Vec, Matrix>& step, const Scalar& free, Vec& position, Vec& velocity, Vec& spin) {
    Vec acceleration{}, spin_up{}; // zeros are added as they do, for the sign of zeros
    if (step.drag > 0) {
        acceleration -= free * step.drag * (velocity - step.old_gradient * position);
        spin_up -= free * step.drag * spin;
    }
    acceleration += step.old_gradient * velocity;
    velocity += step.dt * acceleration;
    spin += step.dt * spin_up;
    velocity += step.change * position;
    spin += step.spin_change;
    position += step.dt * velocity;
}

} // namespace suffuse::motion
