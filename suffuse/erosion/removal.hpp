#pragma once
// Fines taken out at once, without water, all of them or those of a class: what the skeleton loses in stress at
// constant volume, how much it strains under the stresses held before, and whether it still carries them. The question
// behind the paper's active fines content [AboulHosn2016].

#include "suffuse/erosion/loop.hpp"

namespace suffuse::erosion {

struct RemovalResult {
    ErosionResult erosion;    ///< one pass, without a probe; its verdict tells of a skeleton that failed
    Vec3 strain;              ///< of the cell's edges, compression positive [-]
    double removed_share = 0; ///< of the mass before [-]
};

/// The grains that the removal takes, with their contacts now.
std::vector<std::uint32_t> fines_to_remove(const dem::World& world, RemovedFines which);

/// Takes the fines out of an equilibrium and finds the next one. @throws StateError where no grain stays; the world is
/// then as before, as it is when the pulse interrupts.
RemovalResult remove_fines(dem::World& world, const RemoveSpec& spec, const Surroundings& around);

} // namespace suffuse::erosion
