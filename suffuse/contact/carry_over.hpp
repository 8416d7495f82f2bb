#pragma once
// Contact memory carried from one table to the next, by merging and parting sorted lists, or by
// renumbering grains.

#include "suffuse/contact/contacts.hpp"
#include "suffuse/neighbors/pair_list.hpp"

#include <span>

namespace suffuse::contact {

/// Which memory the contacts of a sample need besides the force, the bending moment and the normal.
struct OptionalMemory {
    bool twisting = false;
    bool bonds = false;

    bool operator==(const OptionalMemory&) const = default;
};

template <class Real>
OptionalMemory optional_memory(const MemoryOf<Real>& memory) {
    return {memory.twisting.size() > 0, !memory.bonded.empty()};
}

/// Makes `table` (sorted) the table of the `pairs`, with the memory that it has of them. Pairs that touch stay
/// in it whether or not they are among `pairs`. Column after column is replaced, so that no second table is needed.
/// @param wanted for each pair 1, or 0 to leave it out; empty: all
void carry_over(
    Contacts& table, const neighbors::PairList& pairs, std::span<const std::uint8_t> wanted,
    const OptionalMemory& optional
);

/// The same where the memory of the table's rows is elsewhere.
template <class Real>
void carry_over(
    ContactPairs& table, MemoryOf<Real>& memory, const neighbors::PairList& pairs, std::span<const std::uint8_t> wanted,
    const OptionalMemory& optional
);

/// Only the pairs that touch: all that a saved state needs.
Contacts touching_rows(const Contacts& contacts);

/// The rows with a 1 in `chosen`, in their order.
Contacts chosen_rows(const Contacts& contacts, std::span<const std::uint8_t> chosen);

/// The rows of two tables that have no pair in common, sorted.
Contacts joined(const Contacts& some, const Contacts& others);

inline constexpr std::uint32_t removed_row = 0xffffffffU;

/// Grain rows renumbered: old row g becomes `new_row[g]`, or is gone with its contacts (`removed_row`). The result is
/// sorted again; where the order of two grains turns around, forces, moments and normal change sign.
Contacts renumbered(const Contacts& contacts, std::span<const std::uint32_t> new_row);

} // namespace suffuse::contact
