// Packings from and for other programs.

#include "suffuse/dem/given_contacts.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/io/contact_table.hpp"
#include "suffuse/io/packing_checks.hpp"
#include "suffuse/io/packing_export.hpp"
#include "suffuse/job/run_folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "python/bindings/bindings.hpp"
#include "python/bindings/convert.hpp"
#include "python/bindings/work.hpp"
#include "python/bindings/world_handle.hpp"

namespace suffuse::python {
namespace {

/// Two corners.
io::Box box_of(const py::object& value) {
    const auto corners = py::isinstance<py::sequence>(value) ? value.cast<py::sequence>() : py::sequence(py::tuple());
    if (py::isinstance<py::str>(value) || corners.size() != 2) {
        throw CaseError("box: expected two corners, the lower and the upper, such as ((0, 0, 0), (4e-3, 4e-3, 4e-3))");
    }
    const py::object low = corners[0], high = corners[1];
    return {vector_of(low, dimension::length, "box"), vector_of(high, dimension::length, "box")};
}

py::tuple read_packing(
    const std::filesystem::path& path, const py::object& cell, const grains::Material& material, const py::object& unit,
    double max_overlap, const py::object& radius, const py::object& velocity_gradient, const py::object& box,
    const std::optional<std::filesystem::path>& contacts
) {
    io::PackingRequest request{.file = path, .density = material.density, .max_overlap = max_overlap};
    request.unit = unit_of(unit, dimension::length, "unit");
    request.radius = optional_quantity(radius, dimension::length, "radius");
    if (!velocity_gradient.is_none()) {
        request.velocity_gradient = matrix_of(velocity_gradient, dimension::rate, "velocity_gradient");
    }
    if (!cell.is_none()) {
        request.cell = cell_of(cell);
    }
    if (!box.is_none()) {
        request.box = box_of(box);
        if (contacts) {
            throw CaseError("box and contacts: contacts belong to all grains of the file; leave one of them out");
        }
    }
    io::TakenPacking taken;
    {
        const Computing computing;
        taken = io::take_packing(request);
    }
    if (!taken.h) {
        throw CaseError(taken.no_cell + "; give cell=(LX, LY, LZ) in meters, or its 3 x 3 matrix", path.string());
    }
    dem::World world;
    world.cell.h = world.reference_h = *taken.h;
    world.cell.velocity_gradient = taken.velocity_gradient;
    world.grains = std::move(taken.grains);
    world.material = material;
    if (contacts) {
        const Computing computing;
        const dem::TakenContacts found = dem::add_given_contacts(world, io::read_contacts(*contacts, world.grains));
        if (found.unknown + found.apart > 0) {
            taken.warnings.push_back(fmt::format(
                "{} knows {} of {} contacts; {} of its pairs do not touch here", contacts->string(), found.remembered,
                found.remembered + found.unknown, found.apart
            ));
        }
        if (const std::optional<std::string> words = dem::words_on_cut(found, contacts->string())) {
            taken.warnings.push_back(*words);
        }
    }
    return py::make_tuple(std::make_shared<WorldHandle>(std::move(world)), taken.warnings);
}

} // namespace

void bind_files(py::module_& m) {
    m.def(
        "require_outside_runs", &job::require_outside_runs, py::arg("path"),
        "Raises UsageError where the file would be written into the folder of a run."
    );
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
            const Released released;
            dem::World world = reading.world();
            dem::sort_by_id(world);
            io::export_packing(path, world, *format);
        },
        py::arg("path"), py::arg("world"), py::arg("format")
    );
    m.def(
        "read_packing", &read_packing, py::arg("path"), py::arg("cell"), py::arg("material"), py::arg("unit"),
        py::arg("max_overlap"), py::arg("radius"), py::arg("velocity_gradient"), py::arg("box"), py::arg("contacts")
    );
    m.def(
        "write_contacts",
        [](const std::filesystem::path& path, const WorldHandle& w) {
            const Reading reading(w);
            const Released released;
            dem::World world = SeenWorld(reading.world());
            dem::sort_by_id(world);
            io::export_contacts(path, world);
        },
        py::arg("path"), py::arg("world")
    );
    m.def(
        "largest_overlap",
        [](const WorldHandle& w) {
            const Reading reading(w);
            const Computing computing;
            return io::check_overlaps(reading.world().grains, reading.world().cell, 2, "packing");
        },
        "Largest overlap of two grains / the smaller radius [-]."
    );
}

} // namespace suffuse::python
