#pragma once
// The forces that make the water stand still on held faces while a unit pressure gradient drives it, on one grid.

#include "suffuse/base/pulse.hpp"
#include "suffuse/stokes/held_faces.hpp"
#include "suffuse/stokes/response.hpp"

#include <array>
#include <vector>

namespace suffuse::stokes {

/// A number for each held face, by axis.
using FaceValues = std::array<std::vector<double>, 3>;

/// The water under a unit driving force per volume along a direction, of unit viscosity.
struct UnitFlow {
    Vec3 velocity;           ///< mean over the whole cell [m2]
    std::vector<Vec3> force; ///< on each grain [m3]; adds up to V direction
    int iterations = 0;
    double residual = 0;
};

struct SolverLimits {
    double tolerance;
    int iterations;
};

class HeldForces {
public:
    /// @throws GeometryError where grains hold all faces, or none
    HeldForces(const Grid& grid, std::span<const Vec3> position, std::span<const double> radius);

    /// @throws SolverError where the tolerance is not reached
    UnitFlow solve(const Vec3& direction, const SolverLimits& limits, const Pulse& pulse);

private:
    void velocities(const FaceValues& force, FaceValues& velocity);
    void precondition(const FaceValues& residual, FaceValues& result);
    void scatter(const FaceValues& values, bool scaled);

    Grid grid_;
    std::size_t grains_;
    std::array<HeldFaces, 3> faces_;
    Response response_;
};

} // namespace suffuse::stokes
