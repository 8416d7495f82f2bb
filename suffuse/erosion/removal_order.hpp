#pragma once
// Which fines go first where a part of them is taken out: by chance, by size, by the stress in them or by their
// contacts, as studies of removal do it [MuirWood2010; Scholtes2010; He2025].

#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/spec.hpp"

#include <vector>

namespace suffuse::erosion {

/// `rows` of the grain table in the order in which they go. Among equals, as all that carry nothing are, a number drawn
/// from the seed and the grain's id decides, so that the order depends neither on storage nor on threads.
std::vector<std::uint32_t> put_in_order(const dem::World& world, std::vector<std::uint32_t> rows, RemovalOrder order);

/// As many of `rows`, from the first on, as come nearest to `mass` together [kg].
std::vector<std::uint32_t> take_mass(const dem::World& world, std::vector<std::uint32_t> rows, double mass);

} // namespace suffuse::erosion
