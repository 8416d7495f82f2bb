#pragma once
// What the contacts of a packing from another program remember: shear forces and moments, which geometry does not tell.

#include "suffuse/dem/world.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace suffuse::dem {

struct GivenContact {
    std::uint32_t first = 0, second = 0; ///< rows of the grain table
    Vec3 shear_force;                    ///< on the first grain [N]
    Vec3 moment;                         ///< bending and twisting, on the first grain [N m]
    int line = 0;                        ///< of the file that gives it
};

struct TakenContacts {
    std::size_t remembered = 0; ///< contacts of the world that were given
    std::size_t unknown = 0;    ///< contacts of the world that were not: they remember nothing
    std::size_t apart = 0;      ///< pairs given that do not touch
    std::size_t beyond = 0;     ///< contacts given a shear force that friction does not bear: the first step cuts it
    double borne = 0, cut = 0;  ///< sums of what friction bears of the forces given, and of what the step cuts [N]
    GivenContact worst;         ///< whose shear force is cut the most
    double worst_cut = 0, worst_limit = 0; ///< of it: that, and what friction bears [N]
};

/// Gives a world that awaits its first step its contacts, as `add_first_contacts` does, with the memory of those that
/// are given. Of a shear force the part along the normal is left out, and twisting where the material has none of it.
/// @throws CaseError where a pair is given twice, or touches twice across the faces of its cell
TakenContacts add_given_contacts(World& world, std::span<const GivenContact> given);

/// What to say of shear forces that friction does not bear; nothing where that is rounding, or half a step.
std::optional<std::string> words_on_cut(const TakenContacts& taken, const std::string& file);

} // namespace suffuse::dem
