#pragma once
// The servo: from the stress of this step and the loading asked for to the velocity gradient of the next.

#include "suffuse/cell/servo.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::cell {

/// New velocity gradient of the cell [1/s], extension positive.
/// @param stress of this step, compression positive [Pa]; @param dt [s]
inline Mat3 drive(const Cell& cell, const Loading& loading, const ServoState& servo, const Mat3& stress, double dt) {
    if (loading.velocity_gradient) {
        return *loading.velocity_gradient;
    }
    Mat3 gradient{};
    for (int a = 0; a < 3; ++a) {
        const AxisControl& axis = loading.axis[static_cast<std::size_t>(a)];
        if (axis.control == Control::StrainRate) {
            gradient(a, a) = -axis.value;
            continue;
        }
        const ServoSpec& spec = loading.servo;
        const double missing = axis.value - stress(a, a); // compression positive
        double rate = 0;                                  // compression positive
        if (spec.kind == ServoKind::Inertial) {
            rate = -cell.velocity_gradient(a, a);
            const double sense = rate * missing > 0 ? -1.0 : rate * missing < 0 ? 1.0 : 0.0;
            rate += (1 + sense * spec.damping) * dt * missing / spec.mass;
        } else if (missing != 0) {
            // A sample without contacts has no stiffness: any missing stress then asks for the largest rate.
            rate = missing / (std::max(servo.modulus[a], 1e-300) * spec.response * dt);
        }
        gradient(a, a) = -std::clamp(rate, -spec.max_rate, spec.max_rate);
    }
    return gradient;
}

} // namespace suffuse::cell
