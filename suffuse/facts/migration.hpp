#pragma once
// What becomes of fines that migrate with the water.

#include "suffuse/erosion/migration_result.hpp"
#include "suffuse/facts/fact.hpp"

#include <tuple>

namespace suffuse::facts {

/// A gradient: an object of `holds`.
inline constexpr std::tuple migration_hold{
    row<&erosion::MigrationHold::gradient>("gradient", "-", "hydraulic gradient"),
    row<&erosion::MigrationHold::sample_gradient>(
        "sample_gradient", "-",
        "of the whole sample; in layers that which gives the base `gradient` while nothing has moved"
    ),
    row<&erosion::MigrationHold::held_for>("held_seconds", "s", "how long it was held, in the soil's own time"),
    row<&erosion::MigrationHold::ended>(
        "ended", "",
        "whether motion ended, by `still`, or all had left that could move; never while the water brings fines"
    ),
    row<&erosion::MigrationHold::ended_by>(
        "ended_by", "",
        "`rest`: by `still`; `all-left`; or the limit that cut the hold: `hold_at_most`, `time_at_most`, "
        "`steps_at_most`"
    ),
    row<&erosion::MigrationHold::eroded_mass_share>(
        "eroded_mass_share", "-",
        "of the fines' mass before the stage, in layers without the screen: has crossed the exit by the end of the "
        "hold, with what the water had brought"
    ),
    row<&erosion::MigrationHold::moving_mass_share>(
        "moving_mass_share", "-", "of that mass: moved in the last `still_for` of the hold"
    ),
    row<&erosion::MigrationHold::permeability>(
        "permeability", "m2", "along the flow, of the last solution in the hold"
    ),
    row<&erosion::MigrationHold::porosity>(
        "porosity", "-", "at the end of the hold; after the skeleton has moved, where it may"
    ),
    row<&erosion::MigrationHold::volumetric_strain>(
        "volumetric_strain", "-", "of the skeleton as it moves after the hold, compression positive; 0 where it is held"
    ),
    row<&erosion::MigrationHold::stress_kept>(
        "stress_kept", "-",
        "of the mean stress, by the skeleton at constant volume without the grains that left; 1 where it is held"
    ),
    row<&erosion::MigrationHold::failed>(
        "failed", "", "whether the skeleton does not carry its stresses any more after the hold"
    ),
    row<&erosion::MigrationHold::entered_mass_share>(
        "entered_mass_share", "-",
        "in layers: of the base's mass without the screen, beyond the plane where the filter begins, whether it has "
        "left or not"
    ),
    row<&erosion::MigrationHold::depth>(
        "depth", "m", "in layers: beyond that plane, what 95 % of the mass of the base that is in the filter has come"
    ),
};

} // namespace suffuse::facts
