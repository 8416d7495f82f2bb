#pragma once
// What no soil does, refused before it eats the machine's memory or time: a cell strained by too much in a step, grains
// squeezed into each other, or lost in an endless cell.

#include "suffuse/cell/servo.hpp"
#include "suffuse/dem/world.hpp"

namespace suffuse::dem {

inline constexpr double most_strain_of_step = 0.01; ///< of an axis, prescribed [-]
inline constexpr double least_room = 0.5;           ///< volume of the cell over that of its grains [-]
inline constexpr double most_room = 1e6;            ///< likewise

/// @throws StateError where a prescribed rate strains the cell by more than `most_strain_of_step` in a step of dt [s]
void check_strain_of_step(const cell::Loading& loading, double dt);

/// @throws StateError where the cell is smaller or larger than its grains allow
void check_room(const World& world);

} // namespace suffuse::dem
