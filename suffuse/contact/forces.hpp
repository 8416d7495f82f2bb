#pragma once
// The hot loop over contacts, and the sum of their forces on each grain. Contacts are treated in tiles: the two grains
// of each contact are copied side by side, then one loop without branches applies the law to the whole tile, which the
// compiler turns into vector instructions of the processor at hand. Sums are taken in a fixed order.

#include "suffuse/cell/cell.hpp"
#include "suffuse/contact/contacts.hpp"
#include "suffuse/contact/linear_rolling.hpp"
#include "suffuse/grains/grains.hpp"

#include <cstdint>
#include <vector>

namespace suffuse::contact {

/// What one contact does to its two grains in this step: `force` on the second, minus it on the first.
struct ContactForce {
    Vec3 force;    ///< [N]
    Vec3 torque_1; ///< [N m]
    Vec3 torque_2; ///< [N m]
};

/// For each grain the contacts in which it is the first (a run of rows) and the second (listed).
struct Incidence {
    std::vector<std::uint32_t> first_start;    ///< grains + 1
    std::vector<std::uint32_t> second_start;   ///< grains + 1
    std::vector<std::uint32_t> second_contact; ///< contact rows, ascending for each grain
};

void index_contacts(const Contacts& contacts, std::size_t grains, Incidence& incidence);

/// One step of every contact: updates their memory, writes `forces` (a row a contact).
/// @param h cell of this step; @param image_velocity relative velocity of neighboring periods, G times the cell of the
/// step before [m/s, columns as h] (reference 1.1, 1.3)
/// @return sum over contacts of force (x) branch [N m]: minus tension, so compression is positive; divide by the
/// volume.
Mat3 compute_forces(
    const grains::Grains& grains, const Mat3& h, const Mat3& image_velocity, const LawConstants& law, double dt,
    Contacts& contacts, std::vector<ContactForce>& forces
);

} // namespace suffuse::contact
