#pragma once
// Relaxation of an equilibrium far below what a loading stage requires, at constant volume. A viscous drag against the
// mean motion, chosen from the stiffest mode and the size of the sample, kills the slow modes that local damping leaves
// ringing; where it does not get on, it lets the grains go for a while.

#include "suffuse/base/pulse.hpp"
#include "suffuse/dem/step.hpp"

#include <cstdint>

namespace suffuse::dem {

/// Viscous drag near the critical one of the slowest mode of the sample: under it a state finds its equilibrium without
/// the inertia that knocks weak contacts open [1/s]. @param dt time step [s]
double slowest_mode_drag(std::size_t grains, double dt);

/// How far a relaxation has come; with the world all that it needs to go on after a stop.
struct Relaxation {
    double unbalanced_force = 0; ///< reached [-]
    std::int64_t steps = 0;
    bool reached_floor = false; ///< it stopped falling before the wanted value: double precision, or grains that creep

    double best = 0;             ///< unbalanced force from which halvings count [-]
    std::int64_t since_best = 0; ///< bursts
};

/// Steps at constant volume until the unbalanced force is below `wanted`, or stops falling. Afterwards the grains are
/// at rest but for what the unbalance moves.
/// @param dt [s]; @param damping local [-]; @param so_far goes on after a stop, and is true at each beat
/// @throws StateError where nothing holds any grain, as in a cloud
void relax(
    World& world, StepCaches& caches, double dt, double damping, double wanted, std::int64_t most_steps,
    Relaxation& so_far, const Pulse& pulse = {}
);

} // namespace suffuse::dem
