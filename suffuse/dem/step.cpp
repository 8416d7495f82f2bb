#include "suffuse/dem/step.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/large_pages.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/resident.hpp"
#include "suffuse/cell/drive.hpp"
#include "suffuse/contact/stress.hpp"
#include "suffuse/dem/bounds.hpp"
#include "suffuse/dem/first_contacts.hpp"
#include "suffuse/dem/inertial_number.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/move_grains.hpp"
#include "suffuse/grains/gradation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

namespace suffuse::dem {
namespace {

constexpr std::int64_t modulus_interval = 100; // steps between two measurements of the moduli that the servo uses

/// Whether the servo needs moduli that were not measured yet.
bool knows_no_moduli(const cell::ServoState& servo, const cell::Loading& loading) {
    return servo.modulus == Vec3{} || (cell::releases_shear(loading) && servo.shear_modulus == Vec3{});
}

/// Whether the servo must look at the contact network's stiffness in this step. What it knew before a time without a
/// stress to hold is of another state: it forgets that, and looks anew when it next has one.
bool needs_moduli(World& world, const cell::Loading& loading) {
    if (!cell::releases_shear(loading)) {
        world.servo.shear_modulus = {};
    }
    if (loading.servo.kind != cell::ServoKind::Secant || !cell::holds_stress(loading)) {
        world.servo.modulus = {};
        return false;
    }
    return knows_no_moduli(world.servo, loading) || world.clock.step % modulus_interval == 0;
}

/// A servo without a largest rate of its own keeps to an inertial number. The grains stay those of the caches.
void look_at_sizes(const World& world, const cell::Loading& loading, StepCaches& caches) {
    if (caches.servo_unit_rate == 0 && cell::holds_stress(loading) && !loading.servo.max_rate) {
        const double median = grains::median_diameter(world.grains);
        caches.servo_unit_rate = rate_of_inertial_number(servo_inertial_number, median, world.material.density, 1.0);
    }
}

/// Where the contacts' memory is in a burst: that of fast steps is in single precision until somebody looks at it.
contact::SingleMemory* single_memory(StepCaches& caches, Mode mode) {
    return mode == Mode::Fast ? &caches.memory : nullptr;
}

void take_memory(World& world, Mode mode, StepCaches& caches) {
    if (mode == Mode::Fast) {
        contact::take_single(world.contacts, caches.memory);
    }
}

void give_back_memory(StepCaches& caches, Mode mode, World& world) {
    if (mode == Mode::Fast) {
        contact::give_back_single(caches.memory, world.contacts);
    }
}

/// Of large samples little is there twice, at the price of making it anew.
bool is_large(const World& world) {
    return world.grains.size() > 65'536;
}

/// Large samples in fast mode have in a burst no second copy of what moves.
bool lends_grains(const World& world, Mode mode) {
    return mode == Mode::Fast && is_large(world);
}

template <class Column>
void free_column(Column& column) {
    column = Column();
}

void make_sums(StepCaches& caches) {
    const std::size_t rows = caches.neighborhood.sum_plan().rows();
    reserve_in_large_pages(caches.sums, rows);
    caches.sums.resize(rows);
}

/// Rows of the grains, and the contacts' memory where it changes its precision: what is freed goes first.
void take(World& world, Mode mode, StepCaches& caches) {
    const bool lends = lends_grains(world, mode);
    take_memory(world, mode, caches);
    if (lends) {
        free_column(world.grains.force);
        free_column(world.grains.torque);
    }
    grains::to_rows(world.grains, caches.rows);
    if (lends) {
        free_column(world.grains.position);
        free_column(world.grains.velocity);
        free_column(world.grains.spin);
    }
    make_sums(caches);
}

/// Grains that slept make up for the steps that they did not make.
void wake(StepCaches& caches) {
    const auto stands = [](const motion::StepMotion& step) {
        return step.old_gradient == Mat3{} && step.change == Mat3{};
    };
    const bool all_stand = caches.neighborhood.leaves_out_held_pairs() && caches.neighborhood.all_sleepers_stand() &&
                           std::ranges::all_of(caches.slept, stands);
    if (all_stand) {
        caches.slept.clear();
    }
    if (!caches.slept.empty()) {
        coast_sleepers(caches.slept, caches.neighborhood.sum_plan(), caches.rows);
        caches.slept.clear();
    }
}

void give_back(StepCaches& caches, Mode mode, World& world) {
    const bool lends = lends_grains(world, mode);
    grains::from_sums(caches.sums, world.grains);
    if (lends) {
        free_column(caches.sums);
    }
    grains::from_rows(caches.rows, world.grains);
    if (lends) {
        free_column(caches.rows);
    }
    give_back_memory(caches, mode, world);
    if (lends) {
        trim_heap();
    }
}

/// Makes sure that no pair outside the contact table can touch in this step.
void pair(World& world, StepCaches& caches, const StepPlan& plan) {
    const bool overslept = caches.sleep && world.clock.time > caches.neighborhood.sleepers_until();
    contact::SingleMemory* const single = single_memory(caches, plan.mode);
    if (caches.neighborhood.holds(world, single, world.cell.h) && !caches.moved_too_far && !overslept) {
        return;
    }
    wake(caches);
    if (is_large(world)) {
        free_column(caches.sums); // a table takes memory until it is made
    }
    caches.neighborhood.update(world, caches.rows, single, plan.dt);
    caches.sums.clear(); // to begin with zeros
    make_sums(caches);
}

contact::AffineModuli affine_moduli(const World& world, StepCaches& caches, Mode mode) {
    const contact::SingleMemory* const single = single_memory(caches, mode);
    return single != nullptr
               ? contact::affine_moduli(world.grains, world.contacts, *single, world.material, world.cell.h)
               : contact::affine_moduli(world.grains, world.contacts, world.material, world.cell.h);
}

contact::Pressed
press(World& world, StepCaches& caches, Mode mode, const contact::LawConstants& law, contact::DomainSequel* sequel) {
    const contact::SumPlan& sums = caches.neighborhood.sum_plan();
    if (mode == Mode::Fast) {
        return contact::compute_forces(
            caches.rows, sums, caches.contact_setting, law, world.contacts, caches.memory, caches.sums, sequel
        );
    }
    return contact::compute_forces(caches.rows, sums, caches.contact_setting, law, world.contacts, caches.sums, sequel);
}

/// Whether domains are to be moved as soon as they can. Several threads wait for each other where they have few domains
/// each: all are then moved together afterwards, to the same bits.
bool moves_early(const contact::SumPlan& plan) {
    constexpr std::size_t many = 32;
    const auto threads = static_cast<std::size_t>(thread_count());
    return threads == 1 || plan.domains() >= many * threads;
}

/// Whether the servo has to see the stress of this very step: the reference's does, and ours as long as it does not
/// know how stiff the sample is. Otherwise it answers to the step before, so that grains need not wait for the stress.
bool answers_at_once(const World& world, const cell::Loading& loading) {
    return cell::holds_stress(loading) &&
           (loading.servo.kind == cell::ServoKind::Inertial || knows_no_moduli(world.servo, loading));
}

void move_one_domain(StepCaches& caches, std::size_t domain) {
    if (move_domain(caches.move, domain)) {
        std::atomic_ref(caches.moved_too_far).store(true, std::memory_order_relaxed);
    }
}

void move_all(StepCaches& caches) {
    parallel_for(caches.neighborhood.sum_plan().domains(), 1, Help::Late, [&](std::size_t begin, std::size_t end) {
        for (std::size_t d = begin; d < end; ++d) {
            move_one_domain(caches, d);
        }
    });
}

/// Share of the load that acts in step `k` of a burst.
double load_share(const StepPlan& plan, std::int64_t k) {
    const std::int64_t step = plan.load_steps + k + 1;
    return step < plan.load_ramp ? static_cast<double>(step) / static_cast<double>(plan.load_ramp) : 1.0;
}

struct Answer {
    Mat3 gradient;             ///< velocity gradient of the cell from this step on [1/s]
    motion::StepMotion motion; ///< of the grains, with it
};

/// The servo's, to the stress of each axis [Pa]; makes the move of this step of it. What moves is looked at in the cell
/// of the next step.
Answer answer_to(const Vec3& stress, World& world, StepCaches& caches, const StepPlan& plan, std::int64_t k) {
    const cell::Cell& cell = world.cell;
    const Neighborhood& neighborhood = caches.neighborhood;
    const Mat3 gradient = cell::drive(cell, plan.loading, stress, plan.dt, caches.servo_unit_rate, world.servo);
    const motion::StepMotion motion =
        motion::plan_motion(plan.dt, plan.damping, plan.drag, cell.velocity_gradient, gradient);
    const Mat3 next_h = cell.h + plan.dt * ((motion.old_gradient + motion.change) * cell.h);
    caches.move = plan_move(
        motion, neighborhood.sum_plan(), plan.load, load_share(plan, k), !caches.contact_setting.normals_only,
        neighborhood.mean_motion(next_h), neighborhood.watch(), caches.sleep, caches.rows, caches.sums
    );
    caches.moved_too_far = false;
    return {gradient, motion};
}

/// @param k number of the step within its burst; @param last nobody looks at the contacts before the last one
Mat3 one_step(
    World& world, StepCaches& caches, const StepPlan& plan, std::int64_t k, bool last, const contact::LawConstants& law
) {
    cell::Cell& cell = world.cell;
    Neighborhood& neighborhood = caches.neighborhood;

    // 1 deform: the mean motion between neighboring periods still belongs to the cell before this step [reference 1.1]
    const Mat3 image_velocity = cell.velocity_gradient * cell.h;
    cell.h += plan.dt * image_velocity;

    // 2 pair
    pair(world, caches, plan);

    // 3 answer, to the stress of the step before
    const bool looks_at_moduli = needs_moduli(world, plan.loading);
    const bool at_once = answers_at_once(world, plan.loading);
    const bool early = !at_once && moves_early(neighborhood.sum_plan());
    Answer answer;
    if (!at_once) {
        answer = answer_to(world.servo.stress, world, caches, plan, k);
    }

    // 4 touch, 5 press, and early 6 gather, 7 move: a domain as soon as its forces are complete
    contact::set_up_step(
        neighborhood.sum_plan(), cell.h, image_velocity, neighborhood.largest_radius(), plan.dt, caches.contact_setting
    );
    caches.contact_setting.looked_at = last || looks_at_moduli;
    const contact::Pressed pressed = press(world, caches, plan.mode, law, early ? &caches.sequel : nullptr);
    if (pressed.wild) {
        throw StateError(fmt::format(
            "at step {} a contact force is not a number or absurdly large: the motion has become unstable; take a "
            "smaller time step than {} s",
            world.clock.step, plan.dt
        ));
    }
    const Mat3 stress = (1 / cell::volume(cell)) * pressed.force_branch;

    // 8 measure
    const bool releases_shear = cell::releases_shear(plan.loading);
    if (looks_at_moduli) {
        const contact::AffineModuli moduli = affine_moduli(world, caches, plan.mode);
        world.servo.modulus = moduli.longitudinal;
        world.servo.shear_modulus = releases_shear ? moduli.shear : Vec3{};
    }
    world.servo.stress = {stress(0, 0), stress(1, 1), stress(2, 2)};
    world.servo.shear_stress = releases_shear ? cell::shear_stresses(stress) : Vec3{};
    if (at_once) {
        answer = answer_to(world.servo.stress, world, caches, plan, k);
    }

    // 6 gather, 7 move
    if (!early) {
        move_all(caches);
    }
    if (caches.sleep) {
        caches.slept.push_back(answer.motion);
        if (caches.slept.size() == most_slept_steps) {
            wake(caches);
        }
    }
    cell.velocity_gradient = answer.gradient; // the cell moves on with it in the next step

    ++world.clock.step;
    world.clock.time += plan.dt;
    return stress;
}

} // namespace

StepReport advance(World& world, StepCaches& caches, const StepPlan& plan, std::int64_t steps) {
    expects(steps > 0, "a burst has no step");
    if (awaits_first_step(world)) {
        world.contacts = {}; // of the geometry, without memory
    }
    contact::LawConstants law = contact::resolve_law(world.material);
    law.turning = plan.turns_to_first_order ? 0 : law.turning;
    const MotionBefore before = look_before(world, caches.neighborhood.searches() == 0);
    take(world, plan.mode, caches);
    look_at_sizes(world, plan.loading, caches);
    // Drag only slows what nothing pushes, and what is held is not pushed.
    caches.sleep = plan.load == nullptr || caches.neighborhood.leaves_out_held_pairs();
    caches.slept.clear();
    caches.slept.reserve(most_slept_steps);
    if (caches.sleep) {
        caches.neighborhood.look_at_sleepers(world, caches.rows);
    }
    const bool may_shear =
        plan.loading.velocity_gradient || cell::releases_shear(plan.loading) || plan.loading.simple_shear != Mat3{};
    caches.contact_setting.normals_only = !may_shear && contacts_only_push(world);
    caches.sequel.run = [&caches](std::size_t domain) { move_one_domain(caches, domain); };
    StepReport report;
    try {
        for (std::int64_t k = 0; k < steps; ++k) {
            report.stress = one_step(world, caches, plan, k, k + 1 == steps, law);
        }
    } catch (...) { // of a step half made
        caches.sums.resize(world.grains.size());
        give_back(caches, plan.mode, world);
        caches = {};
        throw;
    }
    wake(caches);
    give_back(caches, plan.mode, world);
    check_motion(world, plan, steps, report.stress, before);
    return report;
}

} // namespace suffuse::dem
