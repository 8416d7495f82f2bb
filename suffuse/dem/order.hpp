#pragma once
// The storage order of the grains, taking grains out, and putting them elsewhere.

#include "suffuse/dem/world.hpp"

#include <span>

namespace suffuse::dem {

/// Stores the grains along a space-filling curve, so that neighbors in space are neighbors in memory. Nothing else
/// changes: ids, state and hash stay. Caches of the step have to be made again.
void sort_along_curve(World& world);

/// Stores the grains in order of their ids.
void sort_by_id(World& world);

/// Takes out the grains of rows `rows`, with their contacts.
void remove_grains(World& world, std::span<const std::uint32_t> rows);

/// Puts the grains of rows `rows` elsewhere, at rest and without their contacts.
void relocate_grains(World& world, std::span<const std::uint32_t> rows, std::span<const Vec3> position);

} // namespace suffuse::dem
