#pragma once
// What drives the cell: per axis a wanted stress or a strain rate, turned into the cell's velocity gradient.

#include "suffuse/cell/cell.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace suffuse::cell {

enum class Control {
    StrainRate,
    Stress,
    MeanStress, ///< of all axes: the axes under this control bear alike what the others leave to it
    Share,      ///< stress: `value` and a share of what another axis bears
};

struct AxisControl {
    Control control = Control::StrainRate;
    double value = 0; ///< strain rate [1/s] or stress [Pa], compression positive
    double share = 0; ///< of the stress along axis `of` [-]
    int of = 0;
};

enum class ServoKind {
    Secant,   ///< ours: rate = (stress error / response time - drift of the stress by itself) / modulus; does not ring
    Inertial, ///< the reference's: rate += stress error x dt / mass, with a growth damping [reference 1.5]
};

struct ServoSpec {
    ServoKind kind = ServoKind::Secant;
    double mass = 0;                ///< inertial: [kg/m]
    double damping = 0.25;          ///< inertial: growth damping [-]
    std::optional<double> max_rate; ///< largest strain rate of an axis under stress control [1/s]; else `largest_rate`
    double response = 100;          ///< secant: response time, in steps [-]
};

/// The loading of one stage: three axes, or a full velocity gradient instead.
struct Loading {
    std::array<AxisControl, 3> axis{};
    std::optional<Mat3> velocity_gradient; ///< dv/dx, extension positive [1/s]; replaces `axis` where given
    Mat3 simple_shear{};                   ///< dv/dx off the diagonal, in addition to `axis` [1/s]
    /// Whether the cell shears until there is no shear stress between the axes; else it keeps its angles.
    bool shear_released = false;
    ServoSpec servo;
};

inline bool holds_stress(const Loading& loading) {
    const auto holds = [](const AxisControl& axis) { return axis.control != Control::StrainRate; };
    return !loading.velocity_gradient && std::ranges::any_of(loading.axis, holds);
}

/// Shear stresses are released while there are stresses that are held, by the secant servo.
inline bool releases_shear(const Loading& loading) {
    return loading.shear_released && loading.servo.kind == ServoKind::Secant && holds_stress(loading);
}

/// Of the pairs of axes yz, zx, xy: each is where the axis that it leaves out is.
inline Vec3 shear_stresses(const Mat3& stress) {
    return 0.5 * Vec3{stress(1, 2) + stress(2, 1), stress(2, 0) + stress(0, 2), stress(0, 1) + stress(1, 0)};
}

/// Stress that an axis under stress control should have [Pa]. @param stress of each axis
inline double wanted_stress(const Loading& loading, int a, const Vec3& stress) {
    const AxisControl& axis = loading.axis[static_cast<std::size_t>(a)];
    if (axis.control == Control::Share) {
        return axis.value + axis.share * stress[axis.of];
    }
    if (axis.control != Control::MeanStress) {
        return axis.value;
    }
    double left = 3 * axis.value;
    int shared = 0;
    for (int b = 0; b < 3; ++b) {
        const bool shares = loading.axis[static_cast<std::size_t>(b)].control == Control::MeanStress;
        left -= shares ? 0 : stress[b];
        shared += shares ? 1 : 0;
    }
    return left / shared;
}

/// What the servo remembers between steps.
struct ServoState {
    Vec3 modulus{}; ///< longitudinal modulus of the contact network along each axis, kept up to date by the driver [Pa]
    Vec3 stress{};  ///< of each axis in the last step, compression positive [Pa]
    Vec3 held_stress{}; ///< held along each axis by the last loading stage, compression positive; zero: none [Pa]
    Vec3 mean_stress{}; ///< of each axis over the response time, compression positive; zero: not seen yet [Pa]
    Vec3 mean_rate{};   ///< strain rate of each axis over the response time, compression positive [1/s]
    // Of the pairs of axes yz, zx, xy, while shear stresses are released; zero otherwise:
    Vec3 shear_modulus{}; ///< of the contact network, kept up to date by the driver [Pa]
    Vec3 shear_stress{};  ///< in the last step [Pa]
};

} // namespace suffuse::cell
