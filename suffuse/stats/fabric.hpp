#pragma once
// Directions and sizes of the contact forces: the fabric tensor of the normals [Satake 1978], the anisotropies of
// contacts and of normal and shear forces to second order [Rothenburg & Bathurst 1989; Guo & Zhao 2013], the spread of
// the forces.

#include "suffuse/dem/world.hpp"

#include <optional>

namespace suffuse::stats {

/// Of forces over the directions of contacts.
struct ForceAnisotropy {
    Mat3 normal; ///< a_n: mean normal force along n = f0 (1 + a_n:nn) [-]
    Mat3 shear;  ///< a_t: mean shear force along n = f0 (a_t n - (a_t:nn) n) [-]
};

/// Means over all touching contacts; zeros where there is none.
struct Fabric {
    Mat3 tensor;         ///< mean of n (x) n; its trace is 1 [-]
    double deviator = 0; ///< sqrt(3/2 dev:dev) of the tensor: its axial less its lateral value in triaxial states [-]
    Mat3 contact_anisotropy;                         ///< a_c = 15/2 dev(tensor): E(n) = (1 + a_c:nn)/(4 pi) [-]
    std::optional<ForceAnisotropy> force_anisotropy; ///< nothing where contacts point too little to some side for it
};

Fabric measure_fabric(const dem::World& world);

/// sqrt(3/2 a:a) of a tensor's deviator: the difference of its axial and lateral values where two of them are equal.
double deviator_of(const Mat3& tensor);

/// How the normal forces are spread, and how many contacts slide.
struct ForceDistribution {
    double mean_normal_force = 0;     ///< compression positive [N]
    double mean_force = 0;            ///< normal and shear together [N]
    double variation = 0;             ///< standard deviation of the normal force / its mean [-]
    double median_ratio = 0;          ///< median normal force / mean [-]
    double p90_ratio = 0;             ///< nine tenths of the contacts carry less / mean [-]
    double max_ratio = 0;             ///< largest / mean [-]
    double strong_share = 0;          ///< share of the contacts with more than the mean normal force [-]
    double strong_pressure_share = 0; ///< share of the mean stress that they carry [-]
    double sliding_share = 0;         ///< share of the contacts at the limit of friction, to 1e-3 [-]
};

ForceDistribution measure_forces(const dem::World& world);

} // namespace suffuse::stats
