#pragma once
// The contacts of a world that has made no step, as its geometry has them: for measures, before the first step makes
// its own. They carry no memory.

#include "suffuse/dem/world.hpp"

namespace suffuse::dem {

/// Whether no step has made the contacts of this world: it counts none, and no contact remembers anything.
bool awaits_first_step(const World& world);

/// The pairs that overlap, with normal and overlap; shear forces and moments are zero.
contact::Contacts find_first_contacts(const World& world);

/// Gives a world that awaits its first step its contacts, and each grain the sum of their normal forces. The first step
/// forgets them: what follows is the same to the bit.
void add_first_contacts(World& world);

} // namespace suffuse::dem
