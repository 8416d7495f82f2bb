#pragma once
// The servo: from the stress of this step and the specified loading to the velocity gradient of the next.

#include "suffuse/cell/servo.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::cell {

/// Strain rate of an axis under the secant servo [1/s], compression positive. The error alone would leave a lag as
/// large as what the stress changes by in a response time: the lateral stress of a sample that dilates in compression,
/// say. So the change over that time which the strain rate does not explain is taken off; and what the wanted stress
/// itself changed by is added, where it follows that of another axis.
inline double
secant_rate(const Loading& loading, const ServoState& servo, int a, double wanted, double stress, double dt) {
    const double response = loading.servo.response * dt;
    const double drift = (stress - servo.mean_stress[a]) / response - servo.modulus[a] * servo.mean_rate[a];
    const double lead = (wanted - wanted_stress(loading, a, servo.mean_stress)) / response;
    // A sample without contacts has no stiffness: any missing stress then requires the largest rate.
    return ((wanted - stress) / response - drift + lead) / std::max(servo.modulus[a], 1e-300);
}

/// Takes this step into the servo's means.
inline void observe(const Vec3& stress, const Mat3& gradient, double response, ServoState& servo) {
    for (int a = 0; a < 3; ++a) {
        servo.mean_stress[a] += (stress[a] - servo.mean_stress[a]) / response;
        servo.mean_rate[a] += (-gradient(a, a) - servo.mean_rate[a]) / response;
    }
}

/// Largest stress that the axes under stress control are to bear, or bore of late [Pa].
inline double stress_to_bear(const Loading& loading, const ServoState& servo) {
    double stress = 0;
    for (int a = 0; a < 3; ++a) {
        const AxisControl& axis = loading.axis[static_cast<std::size_t>(a)];
        if (axis.control != Control::StrainRate) {
            stress = std::max({stress, std::abs(axis.value), std::abs(servo.mean_stress[a])});
        }
    }
    return stress;
}

/// Largest strain rate of an axis whose stress is held [1/s]. Unless it is given: one that is quasi-static under what
/// those axes are to bear or bore of late, whichever is more, and that can follow the axes that are strained.
/// @param unit_rate strain rate that is quasi-static under a stress of 1 Pa [1/s]; grows as the root of the stress
inline double largest_rate(const Loading& loading, const ServoState& servo, double unit_rate) {
    if (loading.servo.max_rate) {
        return *loading.servo.max_rate;
    }
    constexpr double follows = 2; // a sample widens at half of its axial rate and its dilatancy together
    double strained = 0;
    for (const AxisControl& axis : loading.axis) {
        if (axis.control == Control::StrainRate) {
            strained = std::max(strained, std::abs(axis.value));
        }
    }
    return std::max(unit_rate * std::sqrt(stress_to_bear(loading, servo)), follows * strained);
}

/// Shears the cell, without turning it, so that each shear stress falls by its share of the response time. No drift is
/// taken off: with none wanted, nothing is to be followed. A sample softer than what it is to bear is no solid: the
/// shear stresses of a cloud are noise, and shear it by no more than their share of that.
/// @param most largest shear strain rate [1/s]
inline void release_shear(const Loading& loading, const ServoState& servo, double dt, double most, Mat3& gradient) {
    const double softest = std::max(stress_to_bear(loading, servo), 1e-300);
    for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        const double stiffness = std::max(servo.shear_modulus[a], softest);
        const double rate = servo.shear_stress[a] / (stiffness * loading.servo.response * dt);
        gradient(b, c) = gradient(c, b) = 0.5 * std::clamp(rate, -most, most);
    }
}

/// New velocity gradient of the cell [1/s], extension positive; updates the means of `servo`. Shear stresses are those
/// that `servo` remembers. @param stress of each axis in this step or the one before, compression positive [Pa]; @param
/// dt [s]; @param unit_rate as for `largest_rate` [1/s]
inline Mat3
drive(const Cell& cell, const Loading& loading, const Vec3& stress, double dt, double unit_rate, ServoState& servo) {
    if (servo.mean_stress == Vec3{}) { // the first load: no drift
        servo.mean_stress = stress;
    }
    if (loading.velocity_gradient) {
        observe(stress, *loading.velocity_gradient, loading.servo.response, servo);
        return *loading.velocity_gradient;
    }
    const double most = largest_rate(loading, servo, unit_rate);
    Mat3 gradient = loading.simple_shear;
    for (int a = 0; a < 3; ++a) {
        const AxisControl& axis = loading.axis[static_cast<std::size_t>(a)];
        if (axis.control == Control::StrainRate) {
            gradient(a, a) = -axis.value;
            continue;
        }
        const ServoSpec& spec = loading.servo;
        const double wanted = wanted_stress(loading, a, stress);
        const double missing = wanted - stress[a]; // compression positive
        double rate = 0;                           // compression positive
        if (spec.kind == ServoKind::Inertial) {
            rate = -cell.velocity_gradient(a, a);
            const double sense = rate * missing > 0 ? -1.0 : rate * missing < 0 ? 1.0 : 0.0;
            rate += (1 + sense * spec.damping) * dt * missing / spec.mass;
        } else {
            rate = secant_rate(loading, servo, a, wanted, stress[a], dt);
        }
        gradient(a, a) = -std::clamp(rate, -most, most);
    }
    if (releases_shear(loading)) {
        release_shear(loading, servo, dt, most, gradient);
    }
    observe(stress, gradient, loading.servo.response, servo);
    return gradient;
}

} // namespace suffuse::cell
