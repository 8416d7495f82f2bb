#pragma once
// The arrays of a VTK XML file as numbers. [VTK file formats]

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::io {

struct VtkColumn {
    std::size_t components = 1;
    std::vector<double> values; ///< row after row
};

/// Arrays by section and name, "PointData/radius", "FieldData/cell"; the points, whatever their name, as "Points".
/// @throws CaseError where an array cannot be read; `file` is named.
std::map<std::string, VtkColumn> read_vtk_arrays(const std::string& file, std::string_view text);

} // namespace suffuse::io
