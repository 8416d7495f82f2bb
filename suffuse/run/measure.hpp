#pragma once
// The numbers of a state that every stage reports. Their names are a promise to users' scripts.

#include "suffuse/dem/world.hpp"

#include <nlohmann/json.hpp>

namespace suffuse::run {

/// Grains, contacts, cell, stress, density, coordination, balance, hash; with fines in the sample also what they do.
nlohmann::json measure_state(const dem::World& world);

} // namespace suffuse::run
