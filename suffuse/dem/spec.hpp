#pragma once
// The precision of the step, when a stage counts as settled, and a fixed number of steps.

#include "suffuse/cell/servo.hpp"

#include <cstdint>
#include <limits>

namespace suffuse::dem {

/// In which precision the step works.
enum class Mode {
    Reference, ///< double throughout
    Fast,      ///< contact memory and law in single precision; positions, overlaps, sums and motion in double
};

constexpr const char* name_of(Mode mode) {
    return mode == Mode::Fast ? "fast" : "reference";
}

inline constexpr double usual_damping = 0.2; ///< local, non-viscous, where nothing else is said [-]

inline constexpr std::int64_t most_relax_steps = 400'000; ///< of a relaxation, after which its floor is taken

/// All three must hold for a state to count as settled.
struct BalanceSpec {
    double unbalanced_force = 1e-3; ///< mean resultant over grains with >= 2 contacts / mean contact force [-]
    double stress_error = 5e-3;     ///< largest error of a controlled stress / largest wanted one [-]
    std::int64_t patience = 500;    ///< steps in a row for which both hold
};

/// `do = "advance"`: a fixed number of steps, nothing adaptive.
struct AdvanceSpec {
    std::int64_t steps = 0;
    double time_step = 0; ///< [s]; 0 = computed from the contact network
    cell::Loading loading;
};

/// `do = "settle"`: steps until balanced; under the stresses given, or at constant volume where none is.
struct SettleSpec {
    cell::Loading loading; ///< stress per axis; strain rate 0 = fixed
    double time_step = 0;  ///< [s]; 0 = computed
    std::int64_t max_steps = 2'000'000;
};

} // namespace suffuse::dem
