#pragma once
// Small-strain stiffness: each of six small strains is put on a copy of the state and held until the grains rest; the
// stress that it brings is a column of the elastic tensor. Half of the strain is put on first: in the elastic range
// it brings half of the stress. What a twin without strain bears is taken off. World in, tensor out.

#include "suffuse/base/pulse.hpp"
#include "suffuse/triaxial/elastic_moduli.hpp"
#include "suffuse/triaxial/probed_sample.hpp"
#include "suffuse/triaxial/spec.hpp"

#include <vector>

namespace suffuse::triaxial {

/// Secant moduli of one strain [Pa].
struct StrainProbe {
    Voigt half;  ///< stress by half of the increment, over that strain
    Voigt whole; ///< by all of it
    std::int64_t steps = 0;
};

/// What all probes start from.
struct RestedState {
    dem::World world; ///< at rest at constant volume; grains with lent inertia, of equal quickness
    double time_step = 0;
    std::int64_t steps = 0; ///< until it rested

    LoadedSample twin;             ///< that is not strained: grains may creep on
    std::vector<Mat3> twin_stress; ///< burst for burst, as far as it was needed [Pa]
};

struct Stiffness : ElasticModuli {
    ElasticTensor tensor{};     ///< by all of the increment; symmetric part [Pa]
    double reciprocity = 0;     ///< largest difference of the measured tensor from its transpose / largest entry [-]
    double nonlinearity = 0;    ///< likewise, from the one by half of the increment [-]
    double mean_field_bulk = 0; ///< bounds: moduli of grains that all move with the mean strain [Pa]
    double mean_field_shear = 0;
};

/// What to do where a sample gives no stiffness, by the keys that its user has.
struct ProbeAdvice {
    const char* at_no_rest = "settle it first, or raise unbalanced_force";
    const char* at_yielding = "probe a state further from failure, or raise max_steps";
};

inline constexpr int strain_directions = 6;
inline constexpr double elastic_within = 0.02; ///< nonlinearity, at most, of an increment in the elastic range [-]

/// Brings a copy of the state to rest at constant volume.
/// @throws StateError when it carries no stress, or does not come to rest; Interrupted by `pulse`.
RestedState rest_for_strains(
    const dem::World& world, const StiffnessSpec& spec, double damping, const Pulse& pulse,
    const ProbeAdvice& advice = {}
);

/// Secant moduli of a strain in proportion to `direction`, compression positive, whose size `increment` scales.
/// @throws StateError when the stress does not come to rest.
StrainProbe probe_strain(
    RestedState& state, const StiffnessSpec& spec, const Mat3& direction, double damping, const Pulse& pulse,
    const ProbeAdvice& advice = {}
);

/// Strain xx, yy, zz, yz, zx, xy by number.
Mat3 strain_direction(int number);

/// @param probes of the six strains in their order
Stiffness stiffness_of(const RestedState& state, const std::vector<StrainProbe>& probes);

} // namespace suffuse::triaxial
