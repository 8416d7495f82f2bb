#pragma once
// Step 5 of the procedure: the grains that leave, and the ledger that accounts for every one of them.

#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/result.hpp"

#include <span>
#include <string>

namespace suffuse::erosion {

/// A grain that is to leave.
struct Leaver {
    std::uint32_t row = 0; ///< of the grain table
    int coordination = 0;  ///< contacts when it leaves
};

/// Takes the leavers out of the world and writes them into the ledger.
void extract(
    dem::World& world, std::span<const Leaver> leavers, int pass, const std::string& reason,
    std::vector<LedgerRow>& ledger
);

/// Throws Bug unless skeleton and ledger together are the initial mass, and no grain is in both.
void check_ledger(const dem::World& world, const std::vector<LedgerRow>& ledger, double initial_mass);

/// Mass of all grains [kg].
double total_mass(const grains::Grains& grains);

/// Mass of the fines over the mass of all grains [-].
double fines_content(const grains::Grains& grains);

} // namespace suffuse::erosion
