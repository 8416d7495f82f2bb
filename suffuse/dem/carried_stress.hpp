#pragma once
// What tests, probes and erosions start from: a skeleton that carries a stress, of grains that a contact law describes.

#include "suffuse/dem/world.hpp"

#include <string_view>

namespace suffuse::dem {

/// The mean stress [Pa]. @param who_needs_it "a triaxial test needs a sample". @throws StateError where it is none, or
/// where grains are far within one another.
double require_pressure(const World& world, const Mat3& stress, std::string_view who_needs_it);

} // namespace suffuse::dem
