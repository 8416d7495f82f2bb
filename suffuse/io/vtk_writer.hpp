#pragma once
// VTK's XML files: points, cells and named arrays, the arrays as raw binary behind the XML [VTK file formats]. In
// single precision unless requested: most of these files are for the eye, states are saved in HDF5.

#include "suffuse/base/vec3.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace suffuse::io {

struct VtkArray {
    std::string name;
    int components = 1;
    /// Row after row.
    std::variant<
        std::vector<float>, std::vector<double>, std::vector<std::int64_t>, std::vector<std::uint32_t>,
        std::vector<std::uint8_t>>
        values;
};

VtkArray vtk_scalars(std::string name, const std::vector<double>& values);
VtkArray vtk_vectors(std::string name, const std::vector<Vec3>& values);

/// The same to the last bit.
VtkArray precise_vtk_vectors(std::string name, const std::vector<Vec3>& values);

enum class VtkCell { Vertex, Line, Tetrahedron };

/// Cells of one kind; cell k joins the next 1, 2 or 4 of `corner`.
struct VtkMesh {
    VtkCell cell = VtkCell::Vertex;
    std::vector<Vec3> point;          ///< [m]
    std::vector<std::int64_t> corner; ///< rows of `point`
    std::vector<VtkArray> point_data, cell_data;
    std::vector<VtkArray> field_data; ///< of the file as a whole: one row each
    bool precise = false;             ///< points to the last bit
};

/// Vertices or lines as `.vtp`, tetrahedra as `.vtu`. Throws IoError, Bug where an array has not a row a point or cell.
void write_mesh(const std::filesystem::path& path, const VtkMesh& mesh);

} // namespace suffuse::io
