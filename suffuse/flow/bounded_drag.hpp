#pragma once
// The law of conductances and forces that stays right at any ratio of sizes. Each throat has a drag that is bounded at
// both ends (throat_drag.hpp), and water exchanges momentum between throats (momentum_exchange.hpp): a throat among
// fine grains in a wide void is held back by the void's walls, and hands on to them what it cannot hold. Conductances
// and forces follow from the same equations. docs/theory/pore-flow.md, "Bounded drag".

#include "suffuse/base/vec3.hpp"
#include "suffuse/flow/momentum_exchange.hpp"
#include "suffuse/pores/network.hpp"

#include <array>
#include <span>
#include <vector>

namespace suffuse::flow {

/// Distance from each grain's center to the nearest surface of a neighbor that is much larger, no less than its radius;
/// infinite where there is none [m].
std::vector<double>
distances_to_walls(const pores::PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius);

class BoundedDrag {
public:
    /// Positions and radii as given to build_network. All must outlive the object, but for what the network knows of
    /// wetted surfaces: it is needed until conductances are known.
    BoundedDrag(const pores::PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius);

    /// Conductance of each throat in a fluid of viscosity [Pa s]; 0 for throats inside a body of water [m3/(Pa s)].
    [[nodiscard]] std::vector<double> conductances(double viscosity) const;

    /// Force on each grain [N], in the order of the rows given. `gradient`: the mean pressure gradient that the
    /// pressures were solved for [Pa/m].
    [[nodiscard]] std::vector<Vec3> grain_forces(std::span<const double> pressure, const Vec3& gradient) const;

private:
    [[nodiscard]] double pressure_on_void(std::size_t t, double drop) const;
    [[nodiscard]] std::array<Vec3, 3>
    forces_at(std::size_t t, double drop, const Vec3& drag, std::span<const double> to_wall) const;

    const pores::PoreNetwork& network_;
    std::span<const Vec3> position_;
    std::span<const double> radius_;
    double least_layer_; ///< no water on grains is thinner [m]
    MomentumExchange exchange_;
};

} // namespace suffuse::flow
