#pragma once
// The law of conductances and forces whose drag is bounded at both ends (throat_drag.hpp), without the water that rests
// near contacts (throat_edges.hpp). Water exchanges momentum between throats (momentum_exchange.hpp): a throat among
// fine grains in a wide void is held back by the void's walls, and hands on to them what it cannot hold. Conductances,
// with the area along a throat (passage_area.hpp), and forces follow from the same equations.
// docs/theory/pore-flow.md, "Bounded drag".

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
    /// wetted surfaces.
    BoundedDrag(const pores::PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius);

    /// Conductance of each throat in a fluid of viscosity [Pa s]; 0 for throats inside a body of water [m3/(Pa s)].
    [[nodiscard]] std::vector<double> conductances(double viscosity) const;

    /// Of each throat, overlaps of grains counted once [m3].
    [[nodiscard]] std::span<const double> water() const { return water_; }

    /// What of all throats' water grains that overlap cover twice [m3].
    [[nodiscard]] double covered_twice() const { return covered_twice_; }

    /// Frees what conductances and `water` need and forces do not.
    void forget_water() { water_ = RawColumn<double>(), passage_ = RawColumn<double>(); }

    /// Force on each grain [N], in the order of the rows given. `gradient`: the mean pressure gradient that the
    /// pressures were solved for [Pa/m].
    [[nodiscard]] std::vector<Vec3> grain_forces(std::span<const double> pressure, const Vec3& gradient) const;

private:
    /// Enters water and passage of all throats, and returns their drag [m].
    RawColumn<double> measure_water();
    [[nodiscard]] double pressure_on_void(std::size_t t, double drop) const;
    void forces_at(
        std::size_t first, std::size_t last, std::span<const double> to_wall, std::span<const double> drop,
        std::span<const Vec3> drag, std::span<std::array<Vec3, 3>> force
    ) const;

    const pores::PoreNetwork& network_;
    std::span<const Vec3> position_;
    std::span<const double> radius_;
    double least_layer_;      ///< no water on grains is thinner [m]
    RawColumn<double> water_; ///< of each throat [m3]
    double covered_twice_ = 0;
    RawColumn<double> passage_; ///< area through which it goes [m2]
    MomentumExchange exchange_;
};

} // namespace suffuse::flow
