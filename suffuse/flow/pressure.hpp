#pragma once
// Steady flow of an incompressible fluid through a pore network under a mean pressure gradient: at every body of water
// the fluxes balance. Conjugate gradients, preconditioned by an aggregation multigrid that is kept for further
// gradients: conductances span eleven decades, which an incomplete factor does not stand.

#include "suffuse/base/vec3.hpp"
#include "suffuse/flow/graph_multigrid.hpp"
#include "suffuse/pores/network.hpp"

#include <span>
#include <vector>

namespace suffuse::flow {

struct FlowField {
    std::vector<double> pressure; ///< per pore, in its own place; its image is shift(h, image) . gradient higher [Pa]
    std::vector<double> flux;     ///< per throat, from side 0 to side 1 [m3/s]
    double residual = 0;    ///< imbalance of the fluxes / that of all of them one way, each body in its own measure [-]
    double net_outflow = 0; ///< largest imbalance of one body of water [m3/s]
    int iterations = 0;
};

struct SolverSpec {
    double tolerance = 1e-12; ///< on FlowField::residual [-]
    int iteration_limit = 500;
};

/// Sets up the network's equations once and solves them for any number of pressure gradients.
class PressureSolver {
public:
    /// `conductance`: per throat [m3/(Pa s)]. Both must outlive the solver.
    PressureSolver(const pores::PoreNetwork& network, std::span<const double> conductance, const SolverSpec& spec = {});

    /// The field under the mean pressure gradient `gradient` [Pa/m]. Pressures have the mean of gradient . center over
    /// the pores. @throws SolverError where the tolerance is not reached.
    [[nodiscard]] FlowField solve(const Vec3& gradient) const;

private:
    /// Fluxes while pressures follow the mean gradient, over `unit_` [Pa].
    struct Source {
        std::vector<double> net; ///< into each body
        double whole = 0;        ///< size of the fluxes of all bodies, without regard to direction
    };

    [[nodiscard]] Source source(const Vec3& gradient) const;
    void set_pressures(std::span<const double> deviation, const Vec3& gradient, FlowField& field) const;
    void set_fluxes(std::span<const double> deviation, const Vec3& gradient, FlowField& field) const;

    const pores::PoreNetwork& network_;
    std::span<const double> conductance_;
    SolverSpec spec_;
    double unit_ = 1; ///< mean conductance: the equations are in ratios to it [m3/(Pa s)]
    GraphMultigrid multigrid_;
};

/// One gradient, one network.
FlowField solve_pressure(
    const pores::PoreNetwork& network, std::span<const double> conductance, const Vec3& gradient,
    const SolverSpec& spec = {}
);

/// Mean velocity of the fluid over the whole cell (superficial) [m/s].
Vec3 mean_velocity(const pores::PoreNetwork& network, std::span<const double> flux);

/// Multiplies everything that is linear in the gradient.
void scale(FlowField& field, double factor);

} // namespace suffuse::flow
