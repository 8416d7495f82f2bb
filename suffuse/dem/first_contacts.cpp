#include "suffuse/dem/first_contacts.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/contact/stress.hpp"
#include "suffuse/neighbors/pairs.hpp"

#include <algorithm>

namespace suffuse::dem {

bool awaits_first_step(const World& world) {
    const auto all_zero = [](const contact::VectorColumn& column) {
        const auto is_zero = [](double a) { return a == 0; };
        return std::ranges::all_of(column.x, is_zero) && std::ranges::all_of(column.y, is_zero) &&
               std::ranges::all_of(column.z, is_zero);
    };
    const contact::Contacts& contacts = world.contacts;
    return world.clock.step == 0 && contacts.bonded.empty() && all_zero(contacts.shear_force) &&
           all_zero(contacts.bending) && all_zero(contacts.twisting);
}

contact::Contacts find_first_contacts(const World& world) {
    const std::vector<Vec3>& position = world.grains.position;
    const std::vector<double>& radius = world.grains.radius;
    contact::Contacts contacts;
    for (const neighbors::Pair& pair : neighbors::find_pairs(world.cell.h, position, radius, 0)) {
        const Vec3 branch = position[pair.second] + cell::shift(world.cell.h, pair.image) - position[pair.first];
        const double distance = norm(branch);
        contacts.first.push_back(pair.first);
        contacts.second.push_back(pair.second);
        contacts.image.push_back(pair.image);
        contacts.normal.push_back(distance > 0 ? branch / distance : Vec3{1, 0, 0});
        contacts.overlap.push_back(radius[pair.first] + radius[pair.second] - distance);
    }
    contacts.shear_force.resize(contacts.size());
    contacts.bending.resize(contacts.size());
    return contacts;
}

void add_first_contacts(World& world) {
    expects(awaits_first_step(world), "first contacts are those before the first step");
    world.contacts = find_first_contacts(world);
    grains::Grains& grains = world.grains;
    grains.force.assign(grains.size(), {});
    for (std::size_t c = 0; c < world.contacts.size(); ++c) {
        const Vec3 push = contact::normal_force(grains, world.contacts, world.material, c) * world.contacts.normal[c];
        grains.force[world.contacts.first[c]] -= push;
        grains.force[world.contacts.second[c]] += push;
    }
}

} // namespace suffuse::dem
