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

/// Appends rows to the path of one pass.
class PathRecorder {
public:
    PathRecorder(const dem::World& start, const ErosionResult& so_far, const PassResult& pass)
        : pass_(pass.pass), initial_mass_(so_far.initial_mass), start_h_(start.cell.h) {
        if (!so_far.path.empty()) {
            first_step_ = so_far.path.back().step;
            first_strain_ = so_far.path.back().volumetric_strain;
        }
    }

    void add(Phase phase, const dem::World& world, const Mat3& stress, double unbalanced_force, std::int64_t steps) {
        const double strain = cell::volumetric_strain(start_h_, world.cell.h);
        const double eroded = 1 - total_mass(world.grains) / initial_mass_;
        rows_.push_back(
            {pass_, phase, first_step_ + steps, stress, first_strain_ + strain, dem::porosity(world), unbalanced_force,
             eroded}
        );
    }

    std::vector<PathRow> take() { return std::move(rows_); }

private:
    int pass_;
    double initial_mass_;
    Mat3 start_h_;
    std::int64_t first_step_ = 0;
    double first_strain_ = 0;
    std::vector<PathRow> rows_;
};

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
    const Surroundings& around;
    PathRecorder recorder;
    dem::StepPlan plan;
    dem::StepCaches caches;
    std::int64_t steps = 0;

    void take_step(PassResult& pass);

    template <class IsOver>
    dem::BalanceState run_phase(Phase phase, std::int64_t most_steps, const IsOver& is_over);
};

/// The first step without the grains that left: what the rest carries where it is.
void Resettling::take_step(PassResult& pass) {
    plan.dt = dem::stable_time_step(world);
    pass.porosity_after_removal = dem::porosity(world);
    pass.stress_after_removal = dem::step(world, caches, plan).stress;
    steps = 1;
    recorder.add(
        Phase::Removal, world, pass.stress_after_removal, dem::measure_equilibrium(world).unbalanced_force, steps
    );
}

template <class IsOver>
dem::BalanceState Resettling::run_phase(Phase phase, std::int64_t most_steps, const IsOver& is_over) {
    dem::BalanceState state;
    dem::ComputedStep step; // a collapse makes contacts that it must know
    for (std::int64_t burst = 1;; ++burst) {
        dem::renew_time_step(step, state.steps, state.equilibrium.contacts, [&] {
            return dem::stable_time_step(world);
        });
        plan.dt = step.time_step;
        dem::settle_burst(world, caches, plan, around.balance, state);
        steps += dem::burst_steps;
        const bool over = is_over(state);
        if (over || burst <= dense_bursts || burst % bursts_a_row == 0) {
            recorder.add(phase, world, state.stress, state.equilibrium.unbalanced_force, steps);
        }
        if (over || state.steps >= most_steps) {
            return state;
        }
        beat(around.pulse, name_of(phase), state.steps);
    }
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

/// How long a skeleton has carried next to nothing under the stresses that it should carry.
class Drift {
public:
    explicit Drift(double held) : held_(held) {}

    bool lasts_too_long(const dem::BalanceState& state) {
        if (dem::mean_stress(state.stress) >= adrift_below * held_) {
            last_carrying_ = state.steps;
        }
        return state.steps - last_carrying_ >= most_steps_adrift;
    }

private:
    double held_;
    std::int64_t last_carrying_ = 0;
};

} // namespace

void describe_before(const dem::World& world, PassResult& pass) {
    pass.stress_before = dem::mean_stress_tensor(world);
    pass.porosity_before = dem::porosity(world);
}

std::vector<PathRow> reequilibrate(
    dem::World& world, const ResettleSpec& spec, const ErosionResult& so_far, const Surroundings& around,
    PassResult& pass
) {
    const Mat3 start_h = world.cell.h;
    const double before = dem::mean_stress(pass.stress_before);
    Resettling resettling{world, around, PathRecorder(world, so_far, pass), {}, {}};
    dem::StepPlan& plan = resettling.plan;
    plan.damping = around.damping;
    plan.mode = around.mode;
    plan.loading = dem::constant_volume();
    resettling.take_step(pass);

    Stopwatch watch;
    const dem::BalanceState still =
        resettling.run_phase(Phase::ConstantVolume, most_steps_at_constant_volume, [&](const auto& state) {
            return rests(state, around.balance, before);
        });
    pass.stress_constant_volume = still.stress;
    pass.wall_seconds[std::string(name_of(Phase::ConstantVolume))] = watch.lap();

    plan.loading = held_loading(world, pass.stress_before);
    plan.loading.servo.max_rate = dem::rate_of_inertial_number(
        spec.inertial_number, grains::median_diameter(world.grains), world.material.density, before
    );
    Drift drift(before);
    const dem::BalanceState settled =
        resettling.run_phase(Phase::Servo, most_steps_under_stress, [&](const auto& state) {
            pass.failed = cell::largest_strain(cell::axial_strains(start_h, world.cell.h)) > spec.max_strain;
            return pass.failed || state.balanced_steps >= around.balance.patience || drift.lasts_too_long(state);
        });
    judge(settled, around.balance, before, spec.max_strain, pass);
    pass.stress_after = settled.stress;
    pass.wall_seconds[std::string(name_of(Phase::Servo))] = watch.lap();

    pass.steps = resettling.steps;
    pass.time_step = plan.dt;
    pass.porosity_after = dem::porosity(world);
    pass.void_ratio_after = dem::void_ratio(world);
    pass.fines_content_after = fines_content(world.grains);
    std::vector<PathRow> path = resettling.recorder.take();
    pass.volumetric_strain =
        path.back().volumetric_strain - (so_far.path.empty() ? 0 : so_far.path.back().volumetric_strain);
    return path;
}

} // namespace suffuse::erosion
