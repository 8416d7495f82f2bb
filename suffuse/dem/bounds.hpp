#pragma once
// What no soil does, refused before it eats the machine's memory or time, or passes for a result: a cell strained by
// too much in a step, grains squeezed into each other or lost in an endless cell, motion and stress that no loading
// gives.

#include "suffuse/cell/servo.hpp"
#include "suffuse/dem/step.hpp"

#include <optional>

namespace suffuse::dem {

inline constexpr double most_strain_of_step = 0.01; ///< of an axis, prescribed [-]
inline constexpr double least_room = 0.5;           ///< volume of the cell over that of its grains [-]
inline constexpr double most_room = 1e6;            ///< likewise

/// @throws StateError where a prescribed rate strains the cell by more than `most_strain_of_step` in a step of dt [s]
void check_strain_of_step(const cell::Loading& loading, double dt);

/// @throws StateError where the cell is smaller or larger than its grains allow
void check_room(const World& world);

inline constexpr double most_speed = 100;  ///< over what grains, springs and loading can give
inline constexpr double most_stress = 100; ///< over the largest that is held

/// Before a burst of steps.
struct MotionBefore {
    double speed = 0; ///< fastest grain, or what the most loaded contact could give the lighter of its two [m/s]
    std::optional<Vec3> stress; ///< of each axis; nothing where grains were put where they are [Pa]
};

/// @param is_new no burst was made before from this state as it is: contacts are those of the geometry
MotionBefore look_before(const World& world, bool is_new);

/// @param stress at the end of a burst of `steps` [Pa]
/// @throws StateError where a grain is faster, or turns faster, than `most_speed` times what was there before and what
/// the loading added since; or where a held stress is beyond `most_stress` times what is to be held, and rises. With
/// the grain, the step and what to do.
void check_motion(
    const World& world, const StepPlan& plan, std::int64_t steps, const Mat3& stress, const MotionBefore& before
);

} // namespace suffuse::dem
