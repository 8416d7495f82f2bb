// Packings from and for other programs.

#include "suffuse/dem/order.hpp"
#include "suffuse/io/packing_export.hpp"
#include "suffuse/io/packing_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "python/bindings/bindings.hpp"
#include "python/bindings/convert.hpp"
#include "python/bindings/world_handle.hpp"

namespace suffuse::python {
namespace {

py::tuple read_packing(
    const std::filesystem::path& path, const py::object& cell, const grains::Material& material, const py::object& unit
) {
    const double length = unit_of(unit, dimension::length, "unit");
    std::optional<Mat3> own;
    if (!cell.is_none()) {
        own = cell_of(cell);
    }
    io::ImportedPacking packing;
    {
        const py::gil_scoped_release released;
        packing = io::read_packing(path, material.density, length);
    }
    if (!own && !packing.cell) {
        throw CaseError(
            path.string() + ": carries no cell; give cell=(LX, LY, LZ) in meters, or its 3 x 3 matrix", path.string()
        );
    }
    if (auto strange = io::size_warning(packing.grains, path.string())) {
        packing.warnings.push_back(std::move(*strange));
    }
    const Mat3 h = own ? *own : packing.cell->h;
    if (auto narrow = io::narrow_cell_warning(packing.grains, h, path.string())) {
        packing.warnings.push_back(std::move(*narrow));
    }
    dem::World world;
    world.cell.h = world.reference_h = h;
    world.grains = std::move(packing.grains);
    world.material = material;
    return py::make_tuple(std::make_shared<WorldHandle>(std::move(world)), packing.warnings);
}

} // namespace

void bind_files(py::module_& m) {
    m.def(
        "write_packing",
        [](const std::filesystem::path& path, const WorldHandle& w, const std::string& name) {
            const auto format = name.empty() ? io::packing_format_of_file(path) : io::packing_format_of_name(name);
            if (!format) {
                throw CaseError(fmt::format(
                    "{}: which format? give format=, one of {}", path.string(),
                    fmt::join(io::packing_format_names(), ", ")
                ));
            }
            const Reading reading(w);
            const py::gil_scoped_release released;
            dem::World world = reading.world();
            dem::sort_by_id(world);
            io::export_packing(path, world, *format);
        },
        py::arg("path"), py::arg("world"), py::arg("format")
    );
    m.def("read_packing", &read_packing, py::arg("path"), py::arg("cell"), py::arg("material"), py::arg("unit"));
    m.def(
        "largest_overlap",
        [](const WorldHandle& w) {
            const Reading reading(w);
            const py::gil_scoped_release released;
            return io::check_overlaps(reading.world().grains, reading.world().cell, 2, "packing");
        },
        "Largest overlap of two grains / the smaller radius [-]."
    );
}

} // namespace suffuse::python
