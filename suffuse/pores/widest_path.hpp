#pragma once
// How large a sphere can travel through a skeleton for ever: for each pore the largest diameter for which a path of
// throats leads from the pore to its own image one period further along a cell axis, whatever the periods across.
// Throats are opened from the widest to the narrowest; pores that they join keep count of the loops that lead through
// the cell.

#include "suffuse/base/vec3.hpp"
#include "suffuse/pores/network.hpp"

#include <vector>

namespace suffuse::pores {

/// The cell axis (0, 1 or 2) whose direction is closest to `direction`, forwards or backwards.
int axis_along(const Mat3& h, const Vec3& direction);

/// Diameter of the widest path of each pore along cell axis `axis` [m]; minus infinity where no path leads through.
std::vector<double> widest_paths(const PoreNetwork& network, int axis);

} // namespace suffuse::pores
