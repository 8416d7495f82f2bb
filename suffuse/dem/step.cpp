#include "suffuse/dem/step.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/cell/drive.hpp"
#include "suffuse/contact/stress.hpp"
#include "suffuse/dem/move_grains.hpp"

#include <fmt/format.h>

#include <cmath>

namespace suffuse::dem {
namespace {

constexpr std::int64_t modulus_interval = 100; // steps between two looks at the stiffness that the servo reckons with

bool has_secant_servo(const cell::Loading& loading) {
    if (loading.velocity_gradient || loading.servo.kind != cell::ServoKind::Secant) {
        return false;
    }
    for (const cell::AxisControl& axis : loading.axis) {
        if (axis.control == cell::Control::Stress) {
            return true;
        }
    }
    return false;
}

} // namespace

StepReport step(World& world, StepCaches& caches, const StepPlan& plan) {
    cell::Cell& cell = world.cell;
    const contact::LawConstants law = contact::resolve_law(world.material);

    // 1 deform: the mean motion between neighboring periods still belongs to the cell before this step [reference 1.1]
    const Mat3 image_velocity = cell.velocity_gradient * cell.h;
    cell.h += plan.dt * image_velocity;

    // 2 pair
    caches.neighborhood.update(world, caches.moved);

    // 3 touch, 4 press
    const Mat3 force_branch =
        contact::compute_forces(world.grains, cell.h, image_velocity, law, plan.dt, world.contacts, caches.forces);
    const Mat3 stress = (1 / cell::volume(cell)) * force_branch;
    if (!std::isfinite(trace(stress))) {
        throw StateError(fmt::format(
            "the stress is not a number at step {}: the motion has blown up; take a smaller time step than {} s",
            world.clock.step, plan.dt
        ));
    }

    // 7 measure: the servo answers to this step's stress and drives this step's motion
    if (has_secant_servo(plan.loading) && world.clock.step % modulus_interval == 0) {
        world.servo.modulus = contact::affine_moduli(world.grains, world.contacts, world.material, cell.h);
    }
    const Mat3 gradient = cell::drive(cell, plan.loading, stress, plan.dt, world.servo);

    // 5 gather, 6 move
    const motion::StepMotion motion =
        motion::plan_motion(plan.dt, plan.damping, plan.drag, cell.velocity_gradient, gradient);
    caches.moved = move_grains(motion, caches, plan.load, plan.load_share, cell.h, world.grains);
    cell.velocity_gradient = gradient;

    ++world.clock.step;
    world.clock.time += plan.dt;
    return {stress, caches.moved};
}

} // namespace suffuse::dem
