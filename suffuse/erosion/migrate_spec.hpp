#pragma once
// Settings of `do = "migrate"`: fines that travel, arch, clog and leave in true time (docs/theory/migration.md).

#include "suffuse/base/vec3.hpp"
#include "suffuse/erosion/spec.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace suffuse::erosion {

/// What the skeleton does between two gradients.
enum class Skeleton {
    Held,  ///< nothing
    Moves, ///< finds a new equilibrium without the grains that left
};

struct MigrateSpec {
    std::vector<double> gradients; ///< one after the other, each held until so few fines move
    Vec3 direction = {0, 0, 1};    ///< of the flow
    std::optional<double> exit;    ///< plane across the flow, from where it enters the cell, or the base [m]; nothing:
                                ///< a grain that has traveled one cell length along the flow has left, in a stack one
                                ///< that comes within the largest filter grain of the end
    Skeleton skeleton = Skeleton::Held;
    double hold_at_most = 2;        ///< true time of a gradient [s]
    double still = 0.005;           ///< share of the fines' mass that may move when a hold ends [-]
    double still_for = 0.05;        ///< true time over which motion is looked at [s]
    double softness = 1e-3;         ///< overlap over radius of two equal fines under the 95 % load [-]
    std::optional<double> friction; ///< of contacts while fines travel [rad]; nothing: that of the sample
    double with_water =
        0.8; ///< velocity relative to the water over the water's, below which a grain does not resist [-]
    double solve_after = 0.2;           ///< the flow, when fines have moved so far [diameters]
    std::optional<double> feed;         ///< mass of fines that enter with each volume of water; nothing: none [kg/m3]
    std::optional<double> time_at_most; ///< true time of all holds [s]
    std::optional<std::int64_t> steps_at_most; ///< of all holds
    std::optional<Gravity> gravity;            ///< of the case
    bool stack = false; ///< fines are a base, coarse grains its filter (stack.hpp): no base grain carries the skeleton,
                        ///< and gradients are of the base
    std::optional<double> base_gap; ///< fine end of the gap in the grading of that base [m]; nothing: it has none
};

} // namespace suffuse::erosion
