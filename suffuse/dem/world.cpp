#include "suffuse/dem/world.hpp"

#include "suffuse/base/state_hash.hpp"
#include "suffuse/contact/carry_over.hpp"
#include "suffuse/dem/first_contacts.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

namespace suffuse::dem {

namespace {

/// What is zero where shear stresses are kept is left out there: such states hash as before they could be released.
void add_servo(const cell::ServoState& servo, StateHash& hash) {
    const auto& [modulus, stress, held_stress, mean_stress, mean_rate, shear_modulus, shear_stress] = servo;
    for (const Vec3& column : {modulus, stress, held_stress, mean_stress, mean_rate}) {
        hash.add(column);
    }
    for (const Vec3& column : {shear_modulus, shear_stress}) {
        if (column != Vec3{}) {
            hash.add(column);
        }
    }
}

} // namespace

std::uint64_t state_hash(const World& world) {
    const grains::Grains& grains = world.grains;
    std::vector<std::uint32_t> order(grains.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return grains.id[a] < grains.id[b]; });

    StateHash hash;
    hash.add(world.cell.h);
    hash.add(world.cell.velocity_gradient);
    add_servo(world.servo, hash);
    hash.add(world.clock.step);
    for (const std::uint32_t g : order) {
        hash.add(grains.id[g]);
        hash.add(grains.position[g]);
        hash.add(grains.velocity[g]);
        hash.add(grains.spin[g]);
        hash.add(grains.radius[g]);
        hash.add(grains.motion[g]);
    }
    // Contacts as pairs of ids, whatever rows their grains are stored in. The first step forgets those before it.
    std::vector<std::uint32_t> rank(grains.size());
    for (std::uint32_t k = 0; k < order.size(); ++k) {
        rank[order[k]] = k;
    }
    const contact::Contacts contacts = awaits_first_step(world)
                                           ? contact::Contacts{}
                                           : contact::renumbered(contact::touching_rows(world.contacts), rank);
    hash.add(std::span<const std::uint32_t>(contacts.first));
    hash.add(std::span<const std::uint32_t>(contacts.second));
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        const cell::Image& image = contacts.image[c];
        hash.add(std::array<std::int32_t, 3>{image.a, image.b, image.c});
        hash.add(contacts.shear_force[c]);
        hash.add(contacts.bending[c]);
        hash.add(contacts.normal[c]);
        hash.add(contacts.twisting.size() > 0 ? contacts.twisting[c] : Vec3{});
        hash.add(contacts.bonded.empty() ? std::uint8_t{0} : contacts.bonded[c]);
    }
    return hash.value();
}

} // namespace suffuse::dem
