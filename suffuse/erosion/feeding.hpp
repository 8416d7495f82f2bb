#pragma once
// Fines that enter with the water. Each volume of it brings a mass of them to the face where the water enters the cell.
// Their sizes are those of the sample's fines, drawn by number; each begins at rest, just behind the face, at a place
// drawn at random where it touches nothing. Where there is none it waits: the entrance is full.

#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/migrate_spec.hpp"
#include "suffuse/erosion/migration_result.hpp"

#include <cstdint>

namespace suffuse::erosion {

/// What goes on from one feeding to the next.
struct Feeding {
    double waiting = 0;     ///< mass that the water has brought, and that has not entered [kg]
    std::int64_t drawn = 0; ///< grains that have entered
};

/// Lets enter what `water` [m3] brings at `time` [s]: grains that the world and the ledger get at their ends.
/// @return their mass [kg]
double feed_fines(
    dem::World& world, MigrationLedger& ledger, Feeding& feeding, const MigrateSpec& spec, double water, double time
);

} // namespace suffuse::erosion
