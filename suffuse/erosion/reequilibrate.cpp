#include "suffuse/erosion/reequilibrate.hpp"

#include "suffuse/base/stopwatch.hpp"
#include "suffuse/cell/strain.hpp"
#include "suffuse/dem/inertial_number.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/settle.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/erosion/extraction.hpp"
#include "suffuse/grains/gradation.hpp"

#include <cmath>

namespace suffuse::erosion {
namespace {

constexpr std::int64_t most_steps_at_constant_volume = 200'000;
constexpr std::int64_t most_steps_under_stress = 3'000'000;
constexpr std::int64_t most_steps_adrift = 400'000; // without a tenth of its stress: twice what 20 % takes at 100 kPa
constexpr double adrift_below = 0.1;                // of the stress held
constexpr std::int64_t bursts_a_row = 4;            // of the recorded path, beyond its dense beginning
constexpr std::int64_t dense_bursts = 20;

cell::Loading held_loading(const dem::World& world, const Mat3& stress_before) {
    cell::Loading loading;
    for (int a = 0; a < 3; ++a) {
        const double held = world.servo.held_stress[a];
        loading.axis[static_cast<std::size_t>(a)] = {cell::Control::Stress, held > 0 ? held : stress_before(a, a)};
    }
    return loading;
}

bool rests(const dem::BalanceState& state, const dem::BalanceSpec& balance, double stress_before) {
    return state.balanced_steps >= balance.patience ||
           std::abs(dem::mean_stress(state.stress)) <= dem::lost_stress * stress_before;
}

/// A skeleton on its way to a new equilibrium.
struct Resettling {
    dem::World& world;
    const ErosionResult& before;
    const Surroundings& around;
    PassResult& pass;
    Resettlement& so_far;
    dem::StepPlan plan;
    dem::StepCaches caches;

    void take_step();

    template <class IsOver>
    void run_phase(std::int64_t most_steps, const IsOver& is_over);

    void add_row(const Mat3& stress, double unbalanced_force);
};

/// Appends the state to the path.
void Resettling::add_row(const Mat3& stress, double unbalanced_force) {
    const PathRow start = before.path.empty() ? PathRow{} : before.path.back();
    const double strain = cell::volumetric_strain(so_far.start_h, world.cell.h);
    const double eroded = 1 - total_mass(world.grains) / before.initial_mass;
    so_far.rows.push_back(
        {pass.pass, so_far.phase, start.step + so_far.steps, stress, start.volumetric_strain + strain,
         dem::porosity(world), unbalanced_force, eroded}
    );
}

/// The first step without the grains that left: what the rest carries where it is.
void Resettling::take_step() {
    so_far.start_h = world.cell.h;
    plan.dt = dem::stable_time_step(world, {plan.damping});
    pass.porosity_after_removal = dem::porosity(world);
    pass.stress_after_removal = dem::step(world, caches, plan).stress;
    so_far.steps = 1;
    add_row(pass.stress_after_removal, dem::measure_equilibrium(world).unbalanced_force);
}

/// Goes on with the phase until it is over or has had its steps.
template <class IsOver>
void Resettling::run_phase(std::int64_t most_steps, const IsOver& is_over) {
    dem::BalanceState& state = so_far.balance;
    for (;;) {
        // a collapse makes contacts that the time step must know
        dem::renew_time_step(so_far.computed, state.steps, state.equilibrium.contacts, [&] {
            return dem::stable_time_step(world, {plan.damping});
        });
        plan.dt = so_far.computed.time_step;
        dem::settle_burst(world, caches, plan, around.balance, state);
        so_far.steps += dem::burst_steps;
        const bool over = is_over();
        const std::int64_t burst = state.steps / dem::burst_steps;
        if (over || burst <= dense_bursts || burst % bursts_a_row == 0) {
            add_row(state.stress, state.equilibrium.unbalanced_force);
        }
        if (over || state.steps >= most_steps) {
            return;
        }
        beat(around.pulse, name_of(so_far.phase), state.steps);
    }
}

void begin(Phase phase, Resettlement& so_far) {
    so_far.phase = phase;
    so_far.balance = {};
    so_far.computed = {};
}

/// Whether the skeleton came to rest, or failed.
void judge(
    const dem::BalanceState& settled, const dem::BalanceSpec& balance, double held, double most_strain, PassResult& pass
) {
    const bool rests_now = settled.balanced_steps >= balance.patience;
    if (pass.failed) {
        pass.verdict = {SkeletonFailed{most_strain}};
    } else if (!rests_now) {
        pass.failed = true;
        pass.verdict = {SkeletonRestless{settled.steps, held > 0 ? dem::mean_stress(settled.stress) / held : 0}};
    }
}

} // namespace

bool is_adrift(double held, Resettlement& so_far) {
    if (dem::mean_stress(so_far.balance.stress) >= adrift_below * held) {
        so_far.last_carrying = so_far.balance.steps;
    }
    return so_far.balance.steps - so_far.last_carrying >= most_steps_adrift;
}

void describe_before(const dem::World& world, PassResult& pass) {
    pass.stress_before = dem::mean_stress_tensor(world);
    pass.porosity_before = dem::porosity(world);
}

void reequilibrate(
    dem::World& world, const ResettleSpec& spec, const ErosionResult& before, const Surroundings& around,
    PassResult& pass, Resettlement& so_far
) {
    const double stress_before = dem::mean_stress(pass.stress_before);
    const dem::BalanceState& state = so_far.balance;
    Resettling resettling{world, before, around, pass, so_far, {}, {}};
    dem::StepPlan& plan = resettling.plan;
    plan.damping = around.damping;
    plan.mode = around.mode;
    plan.loading = dem::constant_volume();
    if (so_far.phase == Phase::Removal) {
        resettling.take_step();
        begin(Phase::ConstantVolume, so_far);
    }
    Stopwatch watch;
    if (so_far.phase == Phase::ConstantVolume) {
        resettling.run_phase(most_steps_at_constant_volume, [&] {
            return rests(state, around.balance, stress_before);
        });
        pass.stress_constant_volume = state.stress;
        pass.wall_seconds[std::string(name_of(so_far.phase))] = watch.lap();
        begin(Phase::Servo, so_far);
    }
    plan.loading = held_loading(world, pass.stress_before);
    plan.loading.servo.max_rate = dem::rate_of_inertial_number(
        spec.inertial_number, grains::median_diameter(world.grains), world.material.density, stress_before
    );
    resettling.run_phase(most_steps_under_stress, [&] {
        pass.failed = cell::largest_strain(cell::axial_strains(so_far.start_h, world.cell.h)) > spec.max_strain;
        return pass.failed || state.balanced_steps >= around.balance.patience || is_adrift(stress_before, so_far);
    });
    judge(state, around.balance, stress_before, spec.max_strain, pass);
    pass.stress_after = state.stress;
    pass.wall_seconds[std::string(name_of(Phase::Servo))] = watch.lap();

    pass.steps = so_far.steps;
    pass.time_step = plan.dt;
    pass.porosity_after = dem::porosity(world);
    pass.void_ratio_after = dem::void_ratio(world);
    pass.fines_content_after = fines_content(world.grains);
    pass.volumetric_strain =
        so_far.rows.back().volumetric_strain - (before.path.empty() ? 0 : before.path.back().volumetric_strain);
}

} // namespace suffuse::erosion
