#pragma once
// Worlds for the tests, each in one line: hand-made contacts, pairs, lattices, the reference's packings.

#include "suffuse/dem/step.hpp"
#include "suffuse/dem/world.hpp"

#include <cmath>
#include <string>

namespace suffuse::test {

/// A world without grains in a cubic cell of edge `edge` [m].
inline dem::World empty_world(double edge, const grains::Material& material = {}) {
    dem::World world;
    world.material = material;
    world.cell.h = world.reference_h = diagonal({edge, edge, edge});
    return world;
}

inline std::uint32_t add(dem::World& world, const Vec3& position, double radius, bool fine = false) {
    const std::uint32_t g = add_grain(world.grains, position, radius, world.material.density);
    world.grains.fine[g] = fine ? 1 : 0;
    return g;
}

/// Adds a touching contact as a step would have left it: overlap and normal follow from the positions, the shear force
/// on `j` is given [N]. Contacts have to be added in the order of the table: by i, then j, then image.
inline void add_contact(
    dem::World& world, std::uint32_t i, std::uint32_t j, const Vec3& shear_force = {}, const cell::Image& image = {}
) {
    const Vec3 branch = world.grains.position[j] + cell::shift(world.cell.h, image) - world.grains.position[i];
    contact::Contacts& contacts = world.contacts;
    contacts.first.push_back(i);
    contacts.second.push_back(j);
    contacts.image.push_back(image);
    contacts.shear_force.push_back(shear_force);
    contacts.bending.push_back({});
    contacts.normal.push_back(branch / norm(branch));
    contacts.overlap.push_back(world.grains.radius[i] + world.grains.radius[j] - norm(branch));
}

/// Two grains at rest along `direction` (a unit vector), overlapping by `overlap` [m], in a cell that no image crosses.
inline dem::World two_grains(
    double radius_1, double radius_2, double overlap, const grains::Material& material,
    const Vec3& direction = {1, 0, 0}
) {
    const double size = radius_1 + radius_2;
    dem::World world = empty_world(20 * size, material);
    const Vec3 middle{10 * size, 10 * size, 10 * size};
    add(world, middle, radius_1);
    add(world, middle + (size - overlap) * direction, radius_2);
    return world;
}

/// What every test of free motion starts from: nothing damps, the cell stands still.
inline dem::StepPlan plan_of(double dt, double damping = 0) {
    dem::StepPlan plan;
    plan.dt = dt;
    plan.damping = damping;
    plan.loading.velocity_gradient = Mat3{};
    return plan;
}

inline void advance(dem::World& world, dem::StepCaches& caches, const dem::StepPlan& plan, std::int64_t steps) {
    for (std::int64_t k = 0; k < steps; ++k) {
        dem::step(world, caches, plan);
    }
}

/// One of the reference's settled packings, `packing500` say, with its cell and its law. Contacts carry no memory yet.
dem::World reference_packing(const std::string& name);

/// Marks the grains smaller than `diameter` [m] as fine.
inline void split_at(dem::World& world, double diameter) {
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        world.grains.fine[g] = 2 * world.grains.radius[g] < diameter ? 1 : 0;
    }
}

} // namespace suffuse::test
