#include "suffuse/triaxial/stiffness.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/contact/springs.hpp"
#include "suffuse/contact/stress.hpp"
#include "suffuse/dem/carried_stress.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/lent_inertia.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/grains/gradation.hpp"
#include "suffuse/triaxial/probed_sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::triaxial {
namespace {

constexpr double at_rest = 2e-4; // of the stress that a strain brings: what a burst changes of it, at most [-]
constexpr int quiet_bursts = 2;  // one after the other
constexpr std::array<std::array<int, 2>, 6> axes_of{{{0, 0}, {1, 1}, {2, 2}, {1, 2}, {2, 0}, {0, 1}}};

Voigt in_voigt(const Mat3& stress) {
    Voigt six{};
    for (std::size_t k = 0; k < six.size(); ++k) {
        const auto [a, b] = axes_of[k];
        six[k] = 0.5 * (stress(a, b) + stress(b, a));
    }
    return six;
}

double norm_of(const Mat3& m) {
    double sum = 0;
    for (int a = 0; a < 3; ++a) {
        sum += norm2(m.row(a));
    }
    return std::sqrt(sum);
}

dem::BalanceSpec goal_of(const StiffnessSpec& spec) {
    dem::BalanceSpec goal;
    goal.unbalanced_force = spec.unbalanced_force;
    goal.patience = dem::burst_steps;
    return goal;
}

/// What the twin that is not strained bears after so many bursts.
const Mat3& stress_of_twin(RestedState& state, std::size_t bursts, const StiffnessSpec& spec, double damping) {
    while (state.twin_stress.size() <= bursts) {
        burst(state.twin, dem::constant_volume(), state.time_step, damping, goal_of(spec));
        state.twin_stress.push_back(state.twin.balance.stress);
    }
    return state.twin_stress[bursts];
}

/// Strains the sample by this much within a burst, and holds the strain until its stress stays. @return the stress
/// beyond that of the twin: grains that still creep do so in both
Mat3 strain_by(
    LoadedSample& sample, RestedState& state, const StiffnessSpec& spec, const Mat3& strain, double damping,
    StrainProbe& probe, const Pulse& pulse, const ProbeAdvice& advice
) {
    cell::Loading loading;
    loading.velocity_gradient = (-1 / (dem::burst_steps * state.time_step)) * strain;
    const std::int64_t begun = probe.steps;
    Mat3 stress;
    for (int quiet = 0; quiet < quiet_bursts;) {
        const bool strains = probe.steps == begun;
        burst(sample, strains ? loading : dem::constant_volume(), state.time_step, damping, goal_of(spec));
        probe.steps += dem::burst_steps;
        const auto bursts = static_cast<std::size_t>(probe.steps / dem::burst_steps);
        const Mat3 before = stress;
        stress = sample.balance.stress - stress_of_twin(state, bursts, spec, damping);
        quiet = !strains && norm_of(stress - before) <= at_rest * norm_of(stress) ? quiet + 1 : 0;
        if (probe.steps - begun > spec.max_steps) {
            throw StateError(fmt::format(
                "a strain of {:.1e} brings no stress that stays: after {} steps the sample still yields; {}",
                norm_of(strain), spec.max_steps, advice.at_yielding
            ));
        }
        beat(pulse, "strain", probe.steps);
    }
    return stress;
}

double largest_of(const ElasticTensor& tensor) {
    double largest = 0;
    for (const Voigt& row : tensor) {
        for (const double entry : row) {
            largest = std::max(largest, std::abs(entry));
        }
    }
    return largest;
}

double largest_difference(const ElasticTensor& a, const ElasticTensor& b) {
    ElasticTensor difference;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < a.size(); ++j) {
            difference[i][j] = a[i][j] - b[i][j];
        }
    }
    return largest_of(difference);
}

/// Voigt's averages of a network whose grains move with the mean strain, by sums over its contacts of normal and
/// shear stiffness times the square of the branch: N and T, over the volume [Walton1987].
void add_mean_field(const dem::World& world, Stiffness& stiffness) {
    const contact::AffineModuli affine =
        contact::affine_moduli(world.grains, world.contacts, world.material, world.cell.h);
    const double ratio = contact::spring_of(world.material).shear_ratio(world.material);
    const Vec3 both = affine.longitudinal + 2 * affine.shear;
    const double normal = (both.x + both.y + both.z) / (1 + ratio); // over all axes both sums make N + T
    stiffness.mean_field_bulk = normal / 9;
    stiffness.mean_field_shear = normal * (2 + 3 * ratio) / 30;
}

} // namespace

RestedState rest_for_strains(
    const dem::World& world, const StiffnessSpec& spec, double damping, const Pulse& pulse, const ProbeAdvice& advice
) {
    dem::require_pressure(world, dem::mean_stress_tensor(world), "stiffness needs a sample");
    const dem::BalanceSpec goal = goal_of(spec);
    LoadedSample sample{world, {}, {}, false};
    dem::lend_inertia(sample.world, grains::median_diameter(world.grains), {}, {true, true});
    RestedState state;
    state.time_step = spec.time_step > 0 ? spec.time_step : dem::stable_time_step(sample.world, {damping});
    while (!sample.rests) {
        burst(sample, dem::constant_volume(), state.time_step, damping, goal);
        state.steps += dem::burst_steps;
        if (!sample.rests && state.steps >= spec.max_steps) {
            throw StateError(fmt::format(
                "the sample is not at rest: after {} steps its unbalanced force is {:.1e} (required {:.1e}); {}",
                state.steps, sample.balance.equilibrium.unbalanced_force, spec.unbalanced_force, advice.at_no_rest
            ));
        }
        beat(pulse, "rest", state.steps);
    }
    state.world = sample.world;
    state.twin_stress = {sample.balance.stress};
    state.twin = std::move(sample);
    return state;
}

StrainProbe probe_strain(
    RestedState& state, const StiffnessSpec& spec, const Mat3& direction, double damping, const Pulse& pulse,
    const ProbeAdvice& advice
) {
    LoadedSample sample{state.world, {}, {}, false};
    StrainProbe probe;
    const auto secant = [&](double strain) {
        const Mat3 half = (0.5 * spec.increment) * direction;
        return in_voigt((1 / strain) * strain_by(sample, state, spec, half, damping, probe, pulse, advice));
    };
    probe.half = secant(0.5 * spec.increment);
    probe.whole = secant(spec.increment);
    return probe;
}

Mat3 strain_direction(int number) {
    const auto [a, b] = axes_of[static_cast<std::size_t>(number)];
    Mat3 strain;
    strain(a, b) = strain(b, a) = a == b ? 1 : 0.5;
    return strain;
}

Stiffness stiffness_of(const RestedState& state, const std::vector<StrainProbe>& probes) {
    ElasticTensor half, whole;
    for (std::size_t row = 0; row < half.size(); ++row) {
        for (std::size_t column = 0; column < half.size(); ++column) {
            half[row][column] = probes[column].half[row];
            whole[row][column] = probes[column].whole[row];
        }
    }
    Stiffness stiffness{moduli_of(symmetric_part(whole))};
    stiffness.tensor = symmetric_part(whole);
    stiffness.reciprocity = 2 * largest_difference(whole, stiffness.tensor) / largest_of(whole);
    stiffness.nonlinearity = largest_difference(half, whole) / largest_of(whole);
    add_mean_field(state.world, stiffness);
    return stiffness;
}

} // namespace suffuse::triaxial
