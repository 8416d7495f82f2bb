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

/// Hash of what steps change and the next one depends on (cell, servo, step, motion, contact memory) and of the
/// grains' ids, sizes and holds, in order of id: the same for any storage order. Material and masses, which stages set,
/// are not in it.
std::uint64_t state_hash(const World& world);

} // namespace suffuse::dem
