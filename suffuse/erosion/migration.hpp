#pragma once
// Fines of weight that move with the water in true time while the skeleton is held; between two gradients it may find a
// new equilibrium. They collide, slide and roll, sink,
// and are dragged by the water of the pores where they are; the flow is solved anew as they move, among the grains that
// do not go with it. Contacts are softened, forces and time are not (weighed_copy.hpp). Left out are lubrication, added
// mass and the water's turning (docs/theory/migration.md).

#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/feeding.hpp"
#include "suffuse/erosion/loop.hpp"
#include "suffuse/erosion/migrate_spec.hpp"
#include "suffuse/erosion/migration_result.hpp"
#include "suffuse/erosion/passed_throats.hpp"
#include "suffuse/erosion/stack.hpp"
#include "suffuse/erosion/weight.hpp"

#include <cstdint>
#include <memory>

namespace suffuse::erosion {

/// A migration under way: all that it goes on from, to the same bits.
struct Migration {
    dem::World world; ///< what is held carries the skeleton; forces on the others are scaled up, and so are velocities
    WeightScale scale;
    MigrationLedger ledger;
    MigrationResult result;      ///< whose last hold may go on
    double time = 0, energy = 0; ///< since the first gradient [s], [J]
    double looked = 0;           ///< time at which motion was last looked at [s]
    std::int64_t steps = 0;
    double time_step = 0;           ///< true, of the last burst [s]
    double largest_overlap = 0;     ///< over the smaller radius, of a grain that moves, at the ends of rows [-]
    double hindrance = 1;           ///< of the last flow: drag over Stokes' of the median fine grain that stands [-]
    double coarse_permeability = 0; ///< of the coarse grains alone, as they are held; 0 where no water passes [m2]
    double solids_mass = 0;         ///< of the sample before [kg]
    double friction = 0;            ///< the same, of its contacts [rad]
    Mat3 stress;                    ///< mean, of the sample before [Pa]
    Stack stack;                    ///< where its layers are; none: one soil
    LayerHeads at_first; ///< of its layers, all grains at rest: the head that gives the base its gradient is kept
    LayerHeads now;      ///< of the last flow
    Feeding feeding;
    std::shared_ptr<const CoarsePores> pores; ///< of the skeleton as it is held; nothing: they are found anew
    double fed_mass = 0;                      ///< that has entered with the water [kg]
    bool rested = true;                       ///< each time before the flow, within the time for it
    bool settles = false;                     ///< next the skeleton finds its new equilibrium
    bool over = false;                        ///< all gradients are done, or a budget is
    HoldEnd cut_by = HoldEnd::None;           ///< the budget that left gradients out
};

/// Lets the fines of `sample` come to rest under their weight. @throws CaseError, StateError for a setting or sample
/// that cannot be; and what a flow throws
Migration begin_migration(const dem::World& sample, const MigrateSpec& spec, const Surroundings& around);

/// Solves the flow, and lets the fines move until it is old, or motion is looked at; or, between two gradients, lets
/// the skeleton move. A pulse that throws leaves the migration as it was before the call. @pre it is not over
void migrate_on(Migration& migration, const MigrateSpec& spec, const Surroundings& around);

/// The sample without the grains that left, as a weightless one. Fines are pushed apart without friction, for that
/// would keep what weight and water pressed together; then nothing moves, and all grains are free again.
dem::World migrated_sample(const Migration& migration, const Pulse& pulse);

} // namespace suffuse::erosion
