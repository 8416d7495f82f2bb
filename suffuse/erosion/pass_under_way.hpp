#pragma once
// A pass that is not over: what its relaxation or its new equilibrium needs to go on after a stop, to the same bits.

#include "suffuse/dem/relax.hpp"
#include "suffuse/dem/settle.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/result.hpp"

#include <cstdint>
#include <vector>

namespace suffuse::erosion {

/// How far the skeleton has come on its way to a new equilibrium.
struct Resettlement {
    Phase phase = Phase::Removal;   ///< that is going on; before the first step: removal
    std::int64_t steps = 0;         ///< of all phases
    dem::BalanceState balance;      ///< of this phase
    dem::ComputedStep computed;     ///< of this phase
    std::int64_t last_carrying = 0; ///< step of this phase at which the sample last bore a share of its stress
    Mat3 start_h{};                 ///< the cell before
    std::vector<PathRow> rows;      ///< of the path so far
};

struct PassUnderWay {
    /// What comes next. Between `Probe` and `Settle` nothing can be stopped.
    enum class At { Start, Relax, Probe, Settle, Percolate };

    At at = At::Start;
    dem::World world; ///< of the pass: that before it changes only when the pass is complete
    PassResult pass;  ///< as far as it is known
    dem::Relaxation relaxation;
    double relaxation_step = 0;    ///< its time step [s]
    std::vector<LedgerRow> ledger; ///< of all passes; from `Settle` on
    Resettlement resettlement;
};

} // namespace suffuse::erosion
