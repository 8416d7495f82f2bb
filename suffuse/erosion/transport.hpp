#pragma once
// Step 5 where grains travel: the detached fines follow the water; those that get far enough leave, those that are held
// lodge, where they stand in the way of the next.

#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/result.hpp"
#include "suffuse/erosion/spec.hpp"
#include "suffuse/flow/fluid.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace suffuse::erosion {

/// Lets the grains of `detached` travel through the pores between all others, and puts those that are held where they
/// are held. How each fared is in `pass.transport`.
/// @return rows of the grains that left, which still are in the world
std::vector<std::uint32_t> carry_off(
    dem::World& world, std::span<const std::uint32_t> detached, const ErodeSpec& spec, const flow::Fluid& fluid,
    PassResult& pass
);

/// Mass held over mass times travel, if grains are held by chance, as often on each length of the flow: the coefficient
/// of an exponential law [Iwasaki1937] that makes the travels seen likeliest [1/m]. Nothing where none travelled.
std::optional<double> filter_coefficient(const Transport& transport);

} // namespace suffuse::erosion
