#pragma once
// Fines of weight that move with the water in true time while the skeleton is held. They collide, slide and roll, sink,
// and are dragged by the water of the pores where they are; the flow is solved anew as they move, among the grains that
// do not go with it. Contacts are softened, forces and time are not (weighed_copy.hpp). Left out are lubrication, added
// mass and the water's turning (docs/theory/migration.md).

#include "suffuse/base/pulse.hpp"
#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/migrate_spec.hpp"
#include "suffuse/erosion/weight.hpp"
#include "suffuse/flow/fluid.hpp"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace suffuse::erosion {

/// A solution of the flow, and what happened until the next one.
struct MigrationRow {
    double time = 0;         ///< at its end, since the first gradient [s]
    double gradient = 0;     ///< [-]
    double permeability = 0; ///< along the flow, among the grains that do not go with it [m2]
    double eroded_mass = 0;  ///< so far [kg]
    double moving_mass = 0;  ///< [kg]
    double lodged_mass = 0;  ///< that left its place and rests in another [kg]
    double energy = 0;       ///< spent by the flow so far, integral of rho g Q i L dt [J]
};

/// What became of a gradient.
struct MigrationHold {
    double gradient = 0; ///< [-]
    double held_for = 0; ///< true time [s]
    bool ended = false;  ///< so few fines moved; else the time or the steps were over
    double eroded_mass_share = 0, moving_mass_share = 0; ///< of the fines' mass, at its end [-]
    double permeability = 0;                             ///< of the last flow in it [m2]
};

/// What has become of a fine grain.
enum class Whereabouts {
    Stayed, ///< within half a diameter of where it rested first
    Lodged, ///< left its place and rests in another
    Moving, ///< when the stage ended
    Eroded, ///< crossed the exit
    Fixed,  ///< carries the skeleton's forces: held
};

/// "stayed", "lodged", "moving", "eroded", "fixed".
constexpr std::string_view name_of(Whereabouts where) {
    switch (where) {
    case Whereabouts::Stayed:
        return "stayed";
    case Whereabouts::Lodged:
        return "lodged";
    case Whereabouts::Moving:
        return "moving";
    case Whereabouts::Eroded:
        return "eroded";
    case Whereabouts::Fixed:
        return "fixed";
    }
    return "";
}

/// All fines of the sample, those that left too. Every column has a row a grain, in the order of the sample's table.
struct MigrationLedger {
    std::vector<std::uint32_t> id;
    std::vector<double> diameter, mass; ///< [m], [kg]
    std::vector<Vec3> start, end;       ///< where it rested before the flow, and where it is, or was last [m]
    std::vector<double> to_exit;        ///< along the flow from its start [m]
    std::vector<double> departed;       ///< time at which it was half a diameter from its start; negative: never [s]
    std::vector<double> departed_at;    ///< the gradient then [-]
    std::vector<double> left;           ///< time at which it crossed the exit; negative: never [s]
    std::vector<Whereabouts> where;
    std::vector<std::uint8_t> goes; ///< 1: with the water, so that it does not resist it
    std::vector<Vec3> before;       ///< where it was when motion was last looked at [m]

    [[nodiscard]] std::size_t size() const { return id.size(); }
};

/// A migration under way: all that it goes on from, to the same bits.
struct Migration {
    dem::World world; ///< what is held carries the skeleton; forces on the others are scaled up, and so are velocities
    WeightScale scale;
    MigrationLedger ledger;
    std::vector<MigrationRow> rows;
    std::vector<MigrationHold> holds; ///< the last one may go on
    double time = 0, energy = 0;      ///< [s], [J]
    double looked = 0;                ///< time at which motion was last looked at [s]
    std::int64_t steps = 0;
    double time_step = 0;       ///< true, of the last burst [s]
    double largest_overlap = 0; ///< over the smaller radius, of a grain that moves, at the ends of rows [-]
    double hindrance = 1;       ///< of the last flow: drag over Stokes' of the median resting fine grain [-]
    double fines_mass = 0;      ///< of the sample [kg]
    double cell_length = 0;     ///< along the flow [m]
    bool rested = false;        ///< before the flow, within the time for it
    bool over = false;          ///< all gradients are done, or a budget is
};

/// Mass that crossed the exit [kg].
double eroded_mass(const MigrationLedger& ledger);

/// Of the mass of all fines, that of those whose whereabouts are these [-].
double mass_share(const MigrationLedger& ledger, Whereabouts where);

/// What a migration needs besides its own settings.
struct MigrationSurroundings {
    flow::Fluid fluid;
    Pulse pulse; ///< may throw Interrupted: the migration is then as it was before the call
};

/// Lets the fines of `sample` come to rest under their weight. @throws CaseError, StateError for a setting or sample
/// that cannot be; and what a flow throws
Migration begin_migration(const dem::World& sample, const MigrateSpec& spec, const MigrationSurroundings& around);

/// Solves the flow, and lets the fines move until it is old, or motion is looked at. @pre it is not over
void migrate_on(Migration& migration, const MigrateSpec& spec, const MigrationSurroundings& around);

/// The sample without the grains that left: nothing moves, and all grains are free again.
dem::World migrated_sample(const Migration& migration);

} // namespace suffuse::erosion
