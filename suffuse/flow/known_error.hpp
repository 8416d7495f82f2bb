#pragma once
// Which flow a result is of, and how far such a one is known to be off: what validation/size_ratio.md measured, and a
// check that any packing can be put to: fines held in the water cannot make it faster.

#include "suffuse/cell/cell.hpp"
#include "suffuse/flow/fluid.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::flow {

/// Largest errors seen, over the right value; nothing where no bound is known.
struct KnownError {
    std::optional<double> permeability; ///< along one direction of one sample [-]
    std::optional<double> force_sum;    ///< of the forces on all fines, along the flow [-]
    std::optional<double> force;        ///< root mean square over single grains [-]
};

/// What the network is known to be bad at.
enum class Doubt {
    None,
    FewFines,      ///< fewer than 50 of them
    LittleFines,   ///< at most 1 % of the mass
    Overlaps,      ///< grains overlap far
    Channels,      ///< most of the flow keeps to ways much wider than the voids around
    RaisedByFines, ///< it has a higher permeability with the fines than without
};

/// "", "fewer than 50 fines" ...
std::string_view name_of(Doubt doubt);

/// Where a permeability and the forces on the grains are from.
struct FlowSource {
    Solver solver = Solver::Network; ///< never Auto
    KnownError known_error;
    std::optional<double> raised_by_fines; ///< the network's permeability over that of its coarse grains alone [-]
    bool is_limited = false;   ///< grains can only lower it: the permeability given is that of the coarse grains alone
    Doubt doubt = Doubt::None; ///< of the network
};

/// More than this and the network's word is doubted.
inline constexpr double most_raised = 1.02;

/// What is to be said of a permeability of the network that fines would raise by more; else empty.
/// @param when "of the sample", "after pass 2"
std::string words_of(const FlowSource& source, std::string_view when);

/// Grains of two kinds, and what a flow by bounded drag says of the water between them.
struct Mixture {
    double solid_fraction = 0;
    double size_ratio = 1;    ///< Sauter diameter of the coarse grains over that of the fines; 1 where one is missing
    double fines_content = 0; ///< by volume [-]
    std::size_t fines = 0, coarse = 0;
    double overlap = 0;    ///< as Seepage::overlap
    double channeling = 1; ///< as Seepage::channeling
};

/// 1 for a fine grain: those below the widest gap between neighboring sizes, if one is 1.5 times the other there; else
/// there are none. For packings that do not say.
std::vector<std::uint8_t> distinguish_fines(std::span<const double> radius);

/// @param fine 1 for a fine grain, a row a grain
Mixture describe_mixture(std::span<const double> radius, std::span<const std::uint8_t> fine, double volume);

/// Of the network under a law of conductances.
KnownError known_error(Conductance law, const Mixture& mixture);

/// Of the coarse grains alone, along a direction [m2]; nothing where grains are all of one kind, or where no water
/// passes. @throws as solve_seepage
std::optional<double> coarse_permeability(
    const cell::Cell& cell, std::span<const Vec3> position, std::span<const double> radius,
    std::span<const std::uint8_t> fine, const Vec3& direction, const Fluid& fluid
);

/// The first that holds, in the order of `Doubt`.
Doubt doubt_network(const Mixture& mixture, std::optional<double> raised_by_fines);

} // namespace suffuse::flow
