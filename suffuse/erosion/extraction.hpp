#pragma once
// Step 5 of the procedure: the grains that leave, and the ledger that accounts for every one of them.

#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/result.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::erosion {

/// Takes grains out of the world by their rows; `pass` learns how many they are, of which mass and with how many
/// contacts. @param contacts of all grains, when it was decided who leaves
/// @return the ledger so far and these grains. Throws Bug where it does not add up.
std::vector<LedgerRow> extract(
    dem::World& world, std::span<const std::uint32_t> leaving, std::span<const int> contacts, Reason reason,
    const ErosionResult& so_far, PassResult& pass
);

/// Throws Bug unless skeleton and ledger together are the initial mass, and no grain is in both.
void check_ledger(const dem::World& world, const std::vector<LedgerRow>& ledger, double initial_mass);

/// Mass of all grains [kg].
double total_mass(const grains::Grains& grains);

/// Mass of the fines over the mass of all grains [-].
double fines_content(const grains::Grains& grains);

} // namespace suffuse::erosion
