#pragma once
// One grain's motion over one step, in a cell that deforms: damped acceleration, convection by the cell's mean motion,
// and the change of that mean motion [reference 1.4]. Pure functions; the loop over grains is in dem.

#include "suffuse/base/vec3.hpp"
#include "suffuse/grains/grains.hpp"

namespace suffuse::motion {

/// What is the same for all grains in a step.
struct StepMotion {
    double dt = 0;      ///< [s]
    double damping = 0; ///< local, non-viscous: share of the force taken where it does positive work [-]
    double drag = 0;    ///< viscous: deceleration / velocity relative to the mean motion; relaxation only [1/s]
    Mat3 old_gradient;  ///< velocity gradient of the cell until this step [1/s]
    Mat3 change;        ///< new gradient minus old one [1/s]
    Vec3 spin_change;   ///< spin of `change` [rad/s]
};

inline StepMotion
plan_motion(double dt, double damping, double drag, const Mat3& old_gradient, const Mat3& new_gradient) {
    const Mat3 change = new_gradient - old_gradient;
    // Axial vector of the antisymmetric part.
    const Vec3 spin{
        0.5 * (change(2, 1) - change(1, 2)), 0.5 * (change(0, 2) - change(2, 0)), 0.5 * (change(1, 0) - change(0, 1))};
    return {dt, damping, drag, old_gradient, change, spin};
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

/// Moves a grain under `force` [N] and `torque` [N m]. `free` is 1, or 0 for a held grain, which keeps its own velocity
/// and spin and is carried along by the cell as any other.
[[gnu::always_inline]] inline void move(
    const StepMotion& step, const Vec3& force, const Vec3& torque, double mass, double inertia, double free,
    Vec3& position, Vec3& velocity, Vec3& spin
) {
    const Vec3 fluctuation = velocity - step.old_gradient * position;
    const double drag = free * step.drag;
    Vec3 acceleration = damped((free / mass) * force, fluctuation, step.dt, step.damping) - drag * fluctuation;
    acceleration += step.old_gradient * velocity;
    velocity += step.dt * acceleration;
    const Vec3 spin_up = damped((free / inertia) * torque, spin, step.dt, step.damping) - drag * spin;
    spin += step.dt * spin_up;
    velocity += step.change * position;
    spin += step.spin_change;
    position += step.dt * velocity;
}

} // namespace suffuse::motion
