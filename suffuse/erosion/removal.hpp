#pragma once
// Fines taken out without water, all of them, those of a class, or a share of these, at once or in passes: what the
// skeleton loses in stress at constant volume, how much it strains under the stresses held before, and whether it still
// carries them. The question behind the paper's active fines content [AboulHosn2016], and the way in which most studies
// model what suffusion does to a soil [MuirWood2010; Scholtes2010; He2025].

#include "suffuse/erosion/loop.hpp"

namespace suffuse::erosion {

struct RemovalResult {
    ErosionResult erosion;     ///< passes without a probe; the last one's verdict states why it is the last
    Mat3 start_h;              ///< the cell when the removal began [m]
    double requested_mass = 0; ///< what all passes are to take [kg]
};

/// The grains of the class now, by their rows.
std::vector<std::uint32_t> fines_to_remove(const dem::World& world, RemovedFines which);

/// Begins a removal at the equilibrium `world`.
RemovalResult begin_removal(const dem::World& world, const RemoveSpec& spec);

/// One pass from an equilibrium to the next: takes what is still to go by its end, from the grains that are of the
/// class then. Appends to `result` and returns whether there is another pass.
/// @param now true at each beat; a pass that was stopped goes on from it, and when it is over it is that of the next
/// @throws NoSkeleton where no grain stays; the world is then as before, as it is when the pulse interrupts.
bool remove_once(
    dem::World& world, const RemoveSpec& spec, const Surroundings& around, RemovalResult& result, PassUnderWay& now
);

/// Mass removed so far over the mass at the beginning [-].
double removed_share(const dem::World& world, const RemovalResult& result);

/// Strain of the cell's edges since the beginning, compression positive [-].
Vec3 removal_strain(const dem::World& world, const RemovalResult& result);

} // namespace suffuse::erosion
