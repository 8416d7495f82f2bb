#pragma once
// The forces that make the water stand still on held faces while a unit pressure gradient drives it, on one grid:
// conjugate gradients, whose velocities are found in single precision and made good in double precision at the end.

#include "suffuse/base/pulse.hpp"
#include "suffuse/stokes/held_faces.hpp"
#include "suffuse/stokes/response.hpp"

#include <array>
#include <vector>

namespace suffuse::stokes {

/// A number for each held face, by axis.
template <class Real>
using FaceValues = std::array<std::vector<Real>, 3>;

/// The water under a unit driving force per volume along a direction, of unit viscosity.
struct UnitFlow {
    Vec3 velocity;           ///< mean over the whole cell [m2]
    std::vector<Vec3> force; ///< on each grain [m3]; adds up to V direction
    int iterations = 0;
    double residual = 0; ///< power that the errors of the forces take, over that of the forces, as estimated
};

struct SolverLimits {
    double tolerance;
    int iterations;
};

class HeldForces {
public:
    /// @throws GeometryError where grains hold all faces, or none
    HeldForces(const Grid& grid, std::span<const Vec3> position, std::span<const double> radius);

    /// Under unit drives along directions at right angles to each other. The mean velocity along a drive, and those
    /// along two of the directions under each other's drive, which are the same, are found from the power of the
    /// forces: their errors are of the second order in those of the forces.
    /// @throws SolverError where the tolerance is not reached
    std::vector<UnitFlow> solve(std::span<const Vec3> directions, const SolverLimits& limits, const Pulse& pulse);

    [[nodiscard]] const std::array<HeldFaces, 3>& faces() const { return faces_; }

    /// Velocities of held faces under `force`: response of the water, plus what faces next to a surface may move.
    void find_velocities(const FaceValues<double>& force, FaceValues<double>& velocity);

    /// Nearly the inverse of that: minus the Laplacian on held faces, weaker where a face may move.
    void precondition(const FaceValues<double>& residual, FaceValues<float>& result);

private:
    struct Sums {
        Vec3 values; ///< by axis
        double product = 0;
    };

    struct Partial {
        double values = 0, product = 0;
    };
    struct Iterate;

    template <class Act>
    void for_each_plane(const Act& act);
    [[nodiscard]] Sums add_up() const;
    [[nodiscard]] Vec3 mean(const Vec3& sums) const;
    [[nodiscard]] double product(const FaceValues<float>& force, const FaceValues<double>& velocity);
    [[nodiscard]] std::vector<Vec3> grain_forces(const FaceValues<double>& force) const;
    UnitFlow solve_one(Iterate& i, const Vec3& direction, const SolverLimits& limits, const Pulse& pulse);
    void refresh(Iterate& i, const Vec3& direction);
    void find_direction(Iterate& i);
    void follow(Iterate& i);
    void put(std::size_t axis, std::size_t row, const std::vector<double>& residual);
    void precondition_plane(
        std::size_t axis, std::size_t x, const std::vector<double>& residual, std::vector<float>& result
    );

    Grid grid_;
    std::size_t grains_;
    std::array<HeldFaces, 3> faces_;
    FaceValues<float> scale_;                 ///< of the preconditioner
    std::array<std::vector<float>, 3> field_; ///< scaled residual, zero where nothing is held
    std::vector<Partial> partial_;            ///< of planes: sums have the same bits for any number of threads
    Response response_;
};

} // namespace suffuse::stokes
