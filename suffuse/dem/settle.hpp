#pragma once
// Steps until a state is balanced. A burst at a time, so that a stage can record, save and stop between two.

#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/spec.hpp"
#include "suffuse/dem/step.hpp"

#include <string_view>

namespace suffuse::dem {

inline constexpr std::int64_t burst_steps = 50; ///< steps between two looks at the balance
inline constexpr double lost_stress = 1e-6;     ///< share of the stress before: a skeleton carries nothing any more

/// How long the state has been balanced; part of what a checkpoint saves.
struct BalanceState {
    std::int64_t steps = 0;          ///< done in all
    std::int64_t balanced_steps = 0; ///< in a row
    Equilibrium equilibrium;         ///< at the last look
    Mat3 stress{};                   ///< at the last look [Pa]
};

/// One burst. @return whether the state has been balanced for the specified patience: stress errors of all
/// stress-controlled axes and unbalanced force below the limits of `spec`. Where they are to bear nothing, they bear
/// less than 1e-8 of the modulus.
bool settle_burst(World& world, StepCaches& caches, const StepPlan& plan, const BalanceSpec& spec, BalanceState& state);

/// Whether a sample whose volume is held carries nothing any more: a millionth of the mean stress of before [Pa], or,
/// where that was none, nothing at all for the specified patience. It rests then, and no balance of forces shows
/// it.
bool carries_nothing(
    const cell::Loading& loading, const BalanceSpec& spec, const BalanceState& state, double stress_before
);

/// Bursts until balanced.
/// @throws StateError when that takes more than `max_steps`, with what is still missing.
BalanceState
settle(World& world, StepCaches& caches, const StepPlan& plan, const BalanceSpec& spec, std::int64_t max_steps);

/// Where a settling has had its time: what is still missing. @param limit name of the number of steps that the user may
/// raise, empty: none. @throws StateError always.
[[noreturn]] void report_not_balanced(
    const cell::Loading& loading, const BalanceSpec& spec, const BalanceState& state,
    std::string_view limit = "max_steps"
);

/// Largest error of a controlled stress, released shear stresses among them, over the largest wanted one; 0 where all
/// wanted are zero [-].
double stress_error(const cell::Loading& loading, const Mat3& stress);

/// Holds every axis at the given stress, compression positive [Pa], or fixed where not given.
cell::Loading isotropic_stress(double pressure);

/// Keeps the cell as it is.
cell::Loading constant_volume();

} // namespace suffuse::dem
