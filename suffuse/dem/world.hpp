#pragma once
// The world: a plain value that can be copied, hashed and saved. Pair lists and sorted copies are caches outside it.

#include "suffuse/cell/cell.hpp"
#include "suffuse/cell/servo.hpp"
#include "suffuse/contact/contacts.hpp"
#include "suffuse/grains/grains.hpp"
#include "suffuse/grains/material.hpp"

#include <cstdint>

namespace suffuse::dem {

struct Clock {
    std::int64_t step = 0;
    double time = 0; ///< [s]
};

struct World {
    cell::Cell cell;
    Mat3 reference_h = identity(); ///< cell at which the strain counts as zero [m]
    grains::Grains grains;
    grains::Material material;
    contact::Contacts contacts;
    cell::ServoState servo;
    Clock clock;
    std::uint64_t seed = 0;
};

/// Hash of everything that the next step depends on, in order of grain id: the same for any storage order.
std::uint64_t state_hash(const World& world);

} // namespace suffuse::dem
