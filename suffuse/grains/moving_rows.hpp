#pragma once
// What a burst of steps reads and writes of a grain, in rows: the grains of a contact are then two short runs of
// memory. Made from the grain table when a burst begins, given back to it when it ends.

#include "suffuse/base/double4.hpp"
#include "suffuse/grains/grains.hpp"

#include <vector>

namespace suffuse::grains {

struct alignas(double4_alignment) MovingRow {
    Double4 position; ///< [m]; last lane: 1/mass, zero for a held grain [1/kg]
    Double4 velocity; ///< [m/s]; last lane: 1/inertia, zero for a held grain [1/(kg m2)]
    Double4 spin;     ///< [rad/s]; last lane: radius [m]
};

/// Contact force [N] and torque [N m] on a grain, or a part of them.
struct alignas(64) GrainSum {
    Double4 force{}, torque{};
};

void to_rows(const Grains& grains, std::vector<MovingRow>& rows);

/// Gives positions, velocities and spins back, and makes the columns where they are gone.
void from_rows(const std::vector<MovingRow>& rows, Grains& grains);

/// Gives forces and torques back in the same way, of the first rows of `sums`.
void from_sums(const std::vector<GrainSum>& sums, Grains& grains);

} // namespace suffuse::grains
