#pragma once
// The inertial number I = rate d sqrt(density/p) of a deforming packing: small where inertia plays no part.

#include <cmath>

namespace suffuse::dem {

/// Of the last part of the reference's compaction, under the whole load: 20 1/s for its 0.21 mm at 100 kPa.
inline constexpr double loaded_inertial_number = 6.773e-4;

/// Of a servo on its way to a stress, at most: 50 1/s for the reference's 0.21 mm at 100 kPa.
inline constexpr double servo_inertial_number = 1.7e-3;

/// 0 where nothing is carried: without contacts there is no quasi-static motion to compare with.
/// @param rate of strain [1/s]; @param diameter [m]; @param density of the grains [kg/m3]; @param pressure [Pa]
inline double inertial_number(double rate, double diameter, double density, double pressure) {
    return pressure > 0 ? rate * diameter * std::sqrt(density / pressure) : 0;
}

/// The strain rate that has this inertial number under a pressure above zero [1/s].
inline double rate_of_inertial_number(double number, double diameter, double density, double pressure) {
    return number * std::sqrt(pressure / density) / diameter;
}

} // namespace suffuse::dem
