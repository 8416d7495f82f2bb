#pragma once
// How a test drives the cell: what each axis does on each path, and what the test then is to come to.

#include "suffuse/triaxial/run_path.hpp"

#include <optional>

namespace suffuse::triaxial {

/// Rate of an axis whose stress is held, or of the volume that follows water, at most, over the axial rate [-].
inline constexpr double fastest_held = 2;

/// Mean of the stresses across the axis, and q: the axial stress less that [Pa].
double lateral_mean(const Mat3& stress, int axis);
double deviator(const Mat3& stress, int axis);

/// Volumetric over axial strain, where the path imposes it.
std::optional<double> imposed_strain_ratio(const TriaxialSpec& spec);

/// Whether the strains of the two lateral axes are alike, and nothing is sheared.
inline bool is_axisymmetric(const TriaxialSpec& spec) {
    return !spec.b && spec.path != Path::PlaneStrain && !shears(spec.path);
}

/// What drives the test, and what is held.
cell::Loading loading_of(const TriaxialSpec& spec, const PathState& state);

/// The stresses to come to rest at: the specified one, and those held during the test.
cell::Loading final_loading(const TriaxialSpec& spec, const PathState& state);

/// Error of the stress that the test holds and that is furthest off, over it [-].
double hold_error(const TriaxialSpec& spec, const PathState& state);

/// What a leg goes to: a stress [Pa], or an axial strain [-].
struct Target {
    bool is_stress = true;
    double missing = 0; ///< in the sense of the leg; below zero beyond it
    double size = 0;    ///< of what is wanted, or of an amplitude
};

/// Nothing where the test goes to its strain.
std::optional<Target>
target_of(const TriaxialSpec& spec, const PathState& state, const Mat3& stress, double axial_strain);

/// Sense of a leg that begins at this stress.
double sense_of_leg(const TriaxialSpec& spec, int leg, const Mat3& stress);

} // namespace suffuse::triaxial
