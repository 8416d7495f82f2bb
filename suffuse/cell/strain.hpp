#pragma once
// Strain of the cell from one shape to another: logarithmic, compression positive. `from` and `to` have the cell
// vectors as their columns.

#include "suffuse/base/vec3.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::cell {

/// Along the axes x, y, z [-].
inline Vec3 axial_strains(const Mat3& from, const Mat3& to) {
    const Mat3 deformation_gradient = to * inverse(from);
    return {
        -std::log(deformation_gradient(0, 0)), -std::log(deformation_gradient(1, 1)),
        -std::log(deformation_gradient(2, 2))};
}

/// Of the axis that strained most, either way [-].
inline double largest_strain(const Vec3& axial) {
    return std::max({std::abs(axial.x), std::abs(axial.y), std::abs(axial.z)});
}

/// Their sum, where nothing is sheared [-].
inline double volumetric_strain(const Mat3& from, const Mat3& to) {
    return -std::log(determinant(to) / determinant(from));
}

} // namespace suffuse::cell
