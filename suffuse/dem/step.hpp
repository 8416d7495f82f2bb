#pragma once
// The time step: data goes one way, from the cell to the contacts to the grains.

#include "suffuse/cell/servo.hpp"
#include "suffuse/contact/forces.hpp"
#include "suffuse/dem/neighborhood.hpp"
#include "suffuse/dem/spec.hpp"
#include "suffuse/dem/world.hpp"
#include "suffuse/grains/load.hpp"

#include <vector>

namespace suffuse::dem {

/// What was decided before the step; constant during it.
struct StepPlan {
    Mode mode = Mode::Reference;
    double dt = 0;                  ///< [s]
    double damping = usual_damping; ///< local, non-viscous [-]
    double drag = 0;                ///< viscous, for relaxation only [1/s]
    cell::Loading loading;
    const grains::GrainLoad* load = nullptr; ///< force on each grain from outside the skeleton
    std::int64_t load_ramp = 0;              ///< steps over which `load` grows from nothing; 0: acts at once
    std::int64_t load_steps = 0;             ///< of the ramp that were done before
    bool turns_to_first_order = false;       ///< contact memory, as the reference's: for its trajectories only
};

struct StepReport {
    Mat3 stress; ///< of this step's contact forces and branches, compression positive [Pa]
};

/// Caches of the step; made from the world, never saved.
struct StepCaches {
    Neighborhood neighborhood;
    bool moved_too_far = false; ///< a grain has, for the contact table
    std::vector<grains::MovingRow> rows;
    std::vector<grains::GrainSum> sums;
    bool sleep = false;                    ///< grains in no row of the contact table do, in this burst
    std::vector<motion::StepMotion> slept; ///< steps that they have not made yet
    contact::StepSetting contact_setting;
    GrainMove move{};             ///< of this step
    contact::DomainSequel sequel; ///< which makes it
    contact::SingleMemory memory; ///< of the contacts, in fast mode
    double servo_unit_rate = 0;   ///< largest rate of the servo under a stress of 1 Pa, see cell/drive.hpp [1/s]
};

/// Advances the world by `steps` steps. @return of the last one
/// @throws StateError when a force is not finite any more, or beyond what grains of this modulus exert, with the step
/// and what to do. The world is then of no use: that step is half made.
StepReport advance(World& world, StepCaches& caches, const StepPlan& plan, std::int64_t steps);

/// Advances the world by one step.
inline StepReport step(World& world, StepCaches& caches, const StepPlan& plan) {
    return advance(world, caches, plan, 1);
}

} // namespace suffuse::dem
