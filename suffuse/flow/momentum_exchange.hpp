#pragma once
// How the waters of neighboring throats pull each other along: each throat exchanges momentum with the pores on its two
// sides in proportion to the difference of their velocities, and what does not go on stays with its grains. Velocities
// of pores are the unknowns, by conjugate gradients: grains hold every pore, so that few iterations do. Viscosity 1.
// docs/theory/pore-flow.md, "Bounded drag".

#include "suffuse/base/raw_column.hpp"
#include "suffuse/base/vec3.hpp"
#include "suffuse/pores/network.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace suffuse::flow {

/// Momentum per difference of velocity that each throat exchanges with the pores on its sides 0 and 1 [m]. Single
/// precision: what one loses the other gains whatever the leg is.
using ExchangeLegs = RawColumn<std::array<float, 2>>;

/// Two throats of a pore share an edge between two grains. They exchange through the triangle from this edge to the
/// pore's center, as far as it is void, over the distance between their middles.
ExchangeLegs
exchange_legs(const pores::PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius);

struct ExchangeSpec {
    double tolerance = 1e-6; ///< on the momentum that is out of balance in the pores, over all that enters them [-]
    int iteration_limit = 2000;
};

class MomentumExchange {
public:
    /// `drag`: of each throat [m]. The network must outlive the object.
    MomentumExchange(
        const pores::PoreNetwork& network, RawColumn<double> drag, ExchangeLegs leg, const ExchangeSpec& spec = {}
    );

    /// Velocity in each throat under the pushes on all. @throws SolverError where the tolerance is not reached.
    [[nodiscard]] std::vector<double> velocities(std::span<const double> push) const;

    /// How pores move under pressures on the facets of throats, pushes along their area vectors.
    struct Motion {
        RawColumn<Vec3> velocity; ///< that balances what enters and leaves each pore, to the tolerance
        RawColumn<Vec3> mean;     ///< of its throats, by legs: the same, but exactly what makes their exchange vanish
    };

    /// @throws SolverError where the tolerance is not reached.
    [[nodiscard]] Motion motion(std::span<const double> pressure) const;

    /// What of the pushes reaches the grains of throat t. Over all throats it adds up to the pushes, to rounding and
    /// whatever the tolerance.
    [[nodiscard]] Vec3 to_grains(const Motion& motion, std::span<const double> pressure, std::size_t t) const;

private:
    template <class T>
    [[nodiscard]] RawColumn<T> velocities_in_pores(std::span<const double> push) const;
    template <class T>
    [[nodiscard]] T velocity(const RawColumn<T>& in_pore, const T& push, std::size_t t) const;

    const pores::PoreNetwork& network_;
    RawColumn<double> drag_;
    ExchangeLegs leg_;
    ExchangeSpec spec_;
};

} // namespace suffuse::flow
