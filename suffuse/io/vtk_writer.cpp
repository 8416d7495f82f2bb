#include "suffuse/io/vtk_writer.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/atomic_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <string_view>
#include <type_traits>
#include <utility>

namespace suffuse::io {
namespace {

template <class T>
constexpr std::string_view type_name() {
    if constexpr (std::is_same_v<T, float>) {
        return "Float32";
    }
    if constexpr (std::is_same_v<T, double>) {
        return "Float64";
    }
    if constexpr (std::is_same_v<T, std::int64_t>) {
        return "Int64";
    }
    if constexpr (std::is_same_v<T, std::uint32_t>) {
        return "UInt32";
    }
    if constexpr (std::is_same_v<T, std::uint8_t>) {
        return "UInt8";
    }
}

template <class T>
std::string_view bytes_of(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// The XML of a file, and the arrays that follow it: each is announced with its place, then appended.
class Document {
public:
    void text(std::string_view line) { xml_.append(line); }

    /// Announces an array of `rows` rows; it must live until `save`.
    /// @param further attributes of its tag
    void array(const VtkArray& a, std::size_t rows, std::string_view further = "") {
        std::visit(
            [&](const auto& values) {
                using T = typename std::remove_cvref_t<decltype(values)>::value_type;
                expects(
                    values.size() == rows * static_cast<std::size_t>(a.components),
                    "an array has a row for each point or cell"
                );
                fmt::format_to(
                    std::back_inserter(xml_),
                    "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"{} format=\"appended\" "
                    "offset=\"{}\"/>\n",
                    type_name<T>(), a.name, a.components, further, offset_
                );
                blocks_.push_back(bytes_of(values));
                offset_ += sizeof(std::uint64_t) + blocks_.back().size();
            },
            a.values
        );
    }

    void save(const std::filesystem::path& path) {
        AtomicFile file(path);
        file.write(xml_);
        file.write("<AppendedData encoding=\"raw\">\n_");
        for (const std::string_view block : blocks_) {
            const std::uint64_t size = block.size();
            file.write({reinterpret_cast<const char*>(&size), sizeof size});
            file.write(block);
        }
        file.write("\n</AppendedData>\n</VTKFile>\n");
        file.commit();
    }

private:
    std::string xml_;
    std::vector<std::string_view> blocks_;
    std::uint64_t offset_ = 0;
};

std::size_t corners_of(VtkCell cell) {
    switch (cell) {
    case VtkCell::Vertex:
        return 1;
    case VtkCell::Line:
        return 2;
    case VtkCell::Tetrahedron:
        break;
    }
    return 4;
}

/// Where the corners of each cell end in the list of all corners.
std::vector<std::int64_t> ends_of(std::size_t cells, std::size_t corners) {
    std::vector<std::int64_t> end(cells);
    for (std::size_t k = 0; k < cells; ++k) {
        end[k] = static_cast<std::int64_t>((k + 1) * corners);
    }
    return end;
}

void section(Document& file, std::string_view name, const std::vector<VtkArray>& arrays, std::size_t rows) {
    file.text(fmt::format("<{}>\n", name));
    for (const VtkArray& a : arrays) {
        file.array(a, rows);
    }
    file.text(fmt::format("</{}>\n", name));
}

template <class T>
std::vector<T> flattened(const std::vector<Vec3>& values) {
    std::vector<T> flat;
    flat.reserve(3 * values.size());
    for (const Vec3& v : values) {
        for (int a = 0; a < 3; ++a) {
            flat.push_back(static_cast<T>(v[a]));
        }
    }
    return flat;
}

} // namespace

VtkArray vtk_scalars(std::string name, const std::vector<double>& values) {
    return {std::move(name), 1, std::vector<float>(values.begin(), values.end())};
}

VtkArray vtk_vectors(std::string name, const std::vector<Vec3>& values) {
    return {std::move(name), 3, flattened<float>(values)};
}

VtkArray precise_vtk_vectors(std::string name, const std::vector<Vec3>& values) {
    return {std::move(name), 3, flattened<double>(values)};
}

void write_mesh(const std::filesystem::path& path, const VtkMesh& mesh) {
    const bool unstructured = mesh.cell == VtkCell::Tetrahedron;
    const std::string_view type = unstructured ? "UnstructuredGrid" : "PolyData";
    const std::size_t corners = corners_of(mesh.cell), points = mesh.point.size(), cells = mesh.corner.size() / corners;
    expects(cells * corners == mesh.corner.size(), "the last cell has all its corners");
    constexpr std::uint8_t tetrahedron = 10; // VTK's number for it

    const VtkArray position = (mesh.precise ? precise_vtk_vectors : vtk_vectors)("position", mesh.point);
    const VtkArray connectivity{"connectivity", 1, mesh.corner}, ends{"offsets", 1, ends_of(cells, corners)};
    const VtkArray types{"types", 1, std::vector<std::uint8_t>(unstructured ? cells : 0, tetrahedron)};

    Document file;
    file.text(fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"{}\" "
        "header_type=\"UInt64\">\n<{}>\n",
        type, std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian", type
    ));
    if (!mesh.field_data.empty()) {
        file.text("<FieldData>\n");
        for (const VtkArray& a : mesh.field_data) {
            file.array(a, 1, " NumberOfTuples=\"1\"");
        }
        file.text("</FieldData>\n");
    }
    file.text(fmt::format("<Piece NumberOfPoints=\"{}\" ", points));
    if (unstructured) {
        file.text(fmt::format("NumberOfCells=\"{}\">\n", cells));
    } else {
        const bool lines = mesh.cell == VtkCell::Line;
        file.text(fmt::format(
            "NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n", lines ? 0 : cells,
            lines ? cells : 0
        ));
    }
    section(file, "PointData", mesh.point_data, points);
    section(file, "CellData", mesh.cell_data, cells);
    file.text("<Points>\n");
    file.array(position, points);
    file.text("</Points>\n");
    const std::string_view topology = unstructured ? "Cells" : mesh.cell == VtkCell::Line ? "Lines" : "Verts";
    file.text(fmt::format("<{}>\n", topology));
    file.array(connectivity, mesh.corner.size());
    file.array(ends, cells);
    if (unstructured) {
        file.array(types, cells);
    }
    file.text(fmt::format("</{}>\n</Piece>\n</{}>\n", topology, type));
    file.save(path);
}

} // namespace suffuse::io
