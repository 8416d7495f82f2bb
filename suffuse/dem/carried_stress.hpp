#pragma once
// What tests, probes and erosions start from: a skeleton that carries a stress.

#include "suffuse/base/vec3.hpp"

#include <string_view>

namespace suffuse::dem {

/// The mean stress [Pa]. @param who_needs_it "a triaxial test needs a sample". @throws StateError where it is none.
double require_pressure(const Mat3& stress, std::string_view who_needs_it);

} // namespace suffuse::dem
