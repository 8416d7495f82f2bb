#pragma once
// What a loading that ends leaves a sample under: the stresses that later stages hold.

#include "suffuse/cell/servo.hpp"

namespace suffuse::cell {

/// From now on each axis holds the stress that `loading` gave it, else the one that the loading has led to.
inline void hold_stress(const Loading& loading, ServoState& servo) {
    for (int a = 0; a < 3; ++a) {
        const AxisControl& axis = loading.axis[static_cast<std::size_t>(a)];
        const bool is_given = !loading.velocity_gradient && axis.control == Control::Stress;
        servo.held_stress[a] = is_given ? axis.value : servo.stress[a];
    }
}

} // namespace suffuse::cell
