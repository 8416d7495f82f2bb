// World, its grains and contacts: a state that is looked at, changed by hand, saved and loaded.

#include "suffuse/base/error.hpp"
#include "suffuse/cell/coincident.hpp"
#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/grains/gradation.hpp"
#include "suffuse/io/checkpoint.hpp"
#include "suffuse/io/overlaps.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/run/measure.hpp"

#include <fmt/format.h>

#include "python/bindings/bindings.hpp"
#include "python/bindings/contacts.hpp"
#include "python/bindings/convert.hpp"
#include "python/bindings/interpreter.hpp"
#include "python/bindings/key_doc.hpp"
#include "python/bindings/key_value.hpp"
#include "python/bindings/typed.hpp"
#include "python/bindings/views.hpp"
#include "python/bindings/world_handle.hpp"
#include <algorithm>
#include <cmath>

namespace suffuse::python {
namespace {

using Handle = std::shared_ptr<WorldHandle>;

std::vector<std::uint8_t> claims_of(const py::object& given, std::size_t rows, std::string_view what) {
    std::vector<std::uint8_t> claims(rows, 0);
    if (!given.is_none()) {
        const std::vector<double> values = numbers_of(given, what, rows);
        std::transform(values.begin(), values.end(), claims.begin(), [](double v) { return v != 0 ? 1 : 0; });
    }
    return claims;
}

/// @throws CaseError where grains are too large for the cell: their pairs would take all memory
void check_room(const grains::Grains& grains, const Mat3& h, std::string_view what) {
    if (const auto complaint = io::size_complaint(grains, h)) {
        throw CaseError(fmt::format("{}: {}", what, *complaint));
    }
}

Handle make_world(
    const Numbers& cell, const Numbers& position, const Numbers& radius, const NumbersOrNone& velocity,
    const NumbersOrNone& spin, const NumbersOrNone& fine, const grains::Material& material, std::uint64_t seed
) {
    dem::World world;
    world.cell.h = world.reference_h = cell_of(cell);
    world.material = material;
    world.seed = seed;
    const std::vector<Vec3> x = vectors_of(position, "position");
    const std::vector<double> r = numbers_of(radius, "radius", x.size());
    for (std::size_t g = 0; g < x.size(); ++g) {
        if (!(r[g] > 0)) {
            throw CaseError(fmt::format("radius: found {} at grain {}, expected a positive one", r[g], g));
        }
        grains::add_grain(world.grains, x[g], r[g], material.density);
    }
    check_room(world.grains, world.cell.h, "radius");
    if (const auto rows = cell::find_coincident(world.cell.h, x, r)) {
        throw GeometryError(fmt::format(
            "position: the grains in rows {} and {} are at the same place or an image of it; remove one of them",
            rows->first, rows->second
        ));
    }
    if (!velocity.is_none()) {
        world.grains.velocity = vectors_of(velocity, "velocity", x.size());
    }
    if (!spin.is_none()) {
        world.grains.spin = vectors_of(spin, "spin", x.size());
    }
    world.grains.fine = claims_of(fine, x.size(), "fine");
    return std::make_shared<WorldHandle>(std::move(world));
}

/// Rows as numbers, or a row of truth values for each grain.
std::vector<std::uint32_t> rows_of(const py::object& given, std::size_t grains) {
    const auto array = py::array(given);
    std::vector<std::uint32_t> rows;
    if (array.dtype().kind() == 'b') {
        const std::vector<std::uint8_t> leaves = claims_of(given, grains, "rows to remove");
        for (std::uint32_t g = 0; g < grains; ++g) {
            if (leaves[g] != 0) {
                rows.push_back(g);
            }
        }
        return rows;
    }
    const std::vector<double> values = numbers_of(given, "rows to remove");
    const auto is_truth = [](double value) { return value == 0 || value == 1; };
    const bool is_decimal = array.dtype().kind() == 'f' && !values.empty(); // as an empty list is, too
    if (is_decimal || (grains > 2 && values.size() == grains && std::ranges::all_of(values, is_truth))) {
        throw CaseError(fmt::format(
            "rows to remove: found {}, expected whole numbers of rows, or truth values: write MASK == 1 for a column "
            "of "
            "0 and 1",
            is_decimal ? "numbers with decimals" : "0 or 1 for each grain"
        ));
    }
    for (const double value : values) {
        if (value < 0 || value >= static_cast<double>(grains) || value != std::floor(value)) {
            throw CaseError(
                fmt::format("rows to remove: found {}, expected rows, counted from 0, of the {} grains", value, grains)
            );
        }
        rows.push_back(static_cast<std::uint32_t>(value));
    }
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
}

/// A Gradation or a Grading: sizes, and shares of the mass.
template <class Curve>
py::tuple curve_arrays(const Curve& curve) {
    const auto rows = static_cast<py::ssize_t>(curve.diameter.size());
    return py::make_tuple(
        py::array_t<double>(rows, curve.diameter.data()), py::array_t<double>(rows, curve.passing.data())
    );
}

py::dict describe(const dem::Equilibrium& balance) {
    py::dict dict;
    dict["unbalanced_force"] = balance.unbalanced_force;
    dict["unbalanced_force_all"] = balance.unbalanced_force_all;
    dict["mean_contact_force"] = balance.mean_contact_force;
    dict["kinetic_energy"] = balance.kinetic_energy;
    dict["max_overlap_ratio"] = balance.max_overlap_ratio;
    dict["contacts"] = balance.contacts;
    dict["rattlers"] = balance.rattlers;
    return dict;
}

// ---- grains

void bind_grains(py::module_& m) {
    py::class_<GrainTable> type(
        m, "Grains",
        "The grain table: NumPy arrays that look into the world without copying. They follow it as it steps, and keep "
        "it alive; when grains are removed or reordered, arrays taken before keep the rows of before."
    );
    type.def("__len__", [](const GrainTable& table) { return table.handle->world().grains.size(); });
    type.def("__repr__", [](const GrainTable& table) {
        if (!table.handle->is_open()) {
            return std::string("<suffuse.Grains: in use by a call that steps them>");
        }
        const std::vector<double>& radius = table.handle->world().grains.radius;
        if (radius.empty()) {
            return std::string("<suffuse.Grains: none>");
        }
        const auto [least, most] = std::ranges::minmax_element(radius);
        return fmt::format("<suffuse.Grains: {}, of {:.4g} to {:.4g} mm>", radius.size(), 2e3 * *least, 2e3 * *most);
    });
    type.def("__reduce__", [](const GrainTable& table) { // with its world
        return py::make_tuple(py::module_::import("builtins").attr("getattr"), py::make_tuple(table.handle, "grains"));
    });
    bind_grain_columns(type);
    type.def_property_readonly(
        "diameter",
        [](const GrainTable& table) {
            const std::vector<double>& radius = table.handle->world().grains.radius;
            py::array_t<double> values(static_cast<py::ssize_t>(radius.size()));
            std::transform(radius.begin(), radius.end(), values.mutable_data(), [](double r) { return 2 * r; });
            return values;
        },
        "grains: twice the radius [m]; a new array."
    );
    type.def_property_readonly(
        "coordination",
        [](const GrainTable& table) {
            const std::vector<int> counts = dem::coordination(SeenWorld(*table.handle));
            return py::array_t<int>(static_cast<py::ssize_t>(counts.size()), counts.data());
        },
        "grains: number of touching contacts [-]; a new array."
    );
}

// ---- world

void bind_cell(py::class_<WorldHandle, Handle>& type) {
    type.def_property(
        "cell", [](const WorldHandle& w) { return to_array(w.world().cell.h); },
        [](WorldHandle& w, const Numbers& value) {
            const Mat3 h = cell_of(value);
            check_room(w.world().grains, h, "cell");
            w.world().cell.h = h;
        },
        "3 x 3: the periodic cell, columns are its vectors [m]. Grains do not move when it is set."
    );
    type.def_property(
        "reference_cell", [](const WorldHandle& w) { return to_array(w.world().reference_h); },
        [](WorldHandle& w, const Numbers& value) { w.world().reference_h = cell_of(value); },
        "3 x 3: the cell at which the strain counts as zero [m]."
    );
    type.def_property_readonly(
        "velocity_gradient", [](const WorldHandle& w) { return to_array(w.world().cell.velocity_gradient); },
        "3 x 3: dv/dx of the cell in the last step, extension positive [1/s]. The loading of a step sets it: "
        "world.step(n, suffuse.Loading(velocity_gradient=...))."
    );
}

void bind_measures(py::class_<WorldHandle, Handle>& type) {
    type.def_property_readonly(
        "stress", [](const WorldHandle& w) { return to_array(dem::mean_stress_tensor(SeenWorld(w))); },
        "3 x 3: mean stress of the contact forces, compression positive [Pa]; before the first step of the normal "
        "forces "
        "of the overlaps."
    );
    type.def_property_readonly(
        "mean_stress", [](const WorldHandle& w) { return dem::mean_stress(dem::mean_stress_tensor(SeenWorld(w))); },
        "A third of the trace of the stress [Pa]."
    );
    type.def_property_readonly(
        "deviator_stress",
        [](const WorldHandle& w) { return dem::deviator_stress(dem::mean_stress_tensor(SeenWorld(w))); },
        "sqrt(3 J2) of the stress [Pa]."
    );
    type.def_property_readonly(
        "strain", [](const WorldHandle& w) { return to_array(dem::strain(w.world())); },
        "3: logarithmic, along the axes since reference_cell, compression positive [-]."
    );
    type.def_property_readonly(
        "void_ratio", [](const WorldHandle& w) { return dem::void_ratio(w.world()); }, "Voids / solid [-]."
    );
    type.def_property_readonly(
        "porosity", [](const WorldHandle& w) { return dem::porosity(w.world()); }, "Voids / all [-]."
    );
    type.def_property_readonly(
        "balance", [](const WorldHandle& w) { return describe(dem::measure_equilibrium(SeenWorld(w))); },
        "How near the state is to equilibrium: unbalanced_force (of grains with two contacts or more), "
        "unbalanced_force_all, max_overlap_ratio [-], mean_contact_force [N], kinetic_energy [J], contacts, rattlers."
    );
    type.def(
        "measure", [](const WorldHandle& w) { return py::dict(to_python(run::measure_state(SeenWorld(w)))); },
        "The numbers of a state as in stage.json: void ratio, stress, coordination, fines, hash, ..."
    );
    type.def_property_readonly(
        "hash", [](const WorldHandle& w) { return dem::state_hash(w.world()); },
        "Of all that the next step depends on, grain by grain: the same for any storage order (World.sort), which "
        "decides only "
        "in which order forces are summed."
    );
    type.def(
        "gradation", [](const WorldHandle& w) { return curve_arrays(grains::measure_gradation(w.world().grains)); },
        "Diameters [m], ascending, and the share by mass of the grains up to each [-]."
    );
    type.def_property_readonly(
        "psd", [](const WorldHandle& w) { return curve_arrays(grading_of(w.world().grains)); },
        "The grading of the grains that are there, as suffuse.assess takes it: sizes [m], rising, with a step at each "
        "size, and the shares of the mass finer."
    );
    type.def(
        "stable_time_step",
        [](const WorldHandle& w, double safety, const Quantity& damping) {
            const double given_damping = value_of(key_of("contact", "damping"), damping, "damping");
            if (!(safety > 0 && std::isfinite(safety))) {
                throw CaseError(fmt::format("safety: found {}, expected a number above 0", safety));
            }
            const Reading reading(w);
            const Released released;
            return dem::stable_time_step(reading.world(), {given_damping}, safety);
        },
        py::arg("safety") = dem::default_step_safety, py::kw_only(), py::arg("damping") = dem::usual_damping,
        "`safety` times the stability limit under this local damping, of the stiffest mode of the contact network and "
        "of "
        "contacts to come [s]."
    );
}

void bind_changes(py::class_<WorldHandle, Handle>& type) {
    type.def(
        "remove",
        [](WorldHandle& w, const Numbers& given) {
            const std::vector<std::uint32_t> rows = rows_of(given, w.world().grains.size());
            dem::remove_grains(w.world_for_new_rows(), rows);
            return rows.size();
        },
        py::arg("rows"),
        "Takes grains out, with their contacts: rows by number, or a truth value for each grain. Returns how many."
    );
    type.def(
        "sort",
        [](WorldHandle& w, const std::string& by) {
            if (by != "curve" && by != "id") {
                throw CaseError(fmt::format("sort: found \"{}\", expected \"curve\" or \"id\"", by));
            }
            (by == "id" ? dem::sort_by_id : dem::sort_along_curve)(w.world_for_new_rows());
        },
        py::arg("by") = "curve",
        "Stores the grains along a space-filling curve (the step is then fastest), or by \"id\". The state, its "
        "measures "
        "and its hash stay; forces are then summed in another order, so that steps from it differ by rounding."
    );
    const auto copy = [](const WorldHandle& w) { return std::make_shared<WorldHandle>(w.world()); };
    type.def("copy", copy, "An independent world.");
    type.def("__copy__", copy);
    type.def(
        "__deepcopy__", [copy](const WorldHandle& w, const py::dict&) { return copy(w); }, py::arg("memo")
    );
    type.def(py::pickle(
        [](const WorldHandle& w) {
            std::string bytes;
            {
                const Reading reading(w);
                const Released released;
                bytes = io::world_to_bytes(reading.world());
            }
            return py::bytes(bytes);
        },
        [](const py::bytes& bytes) {
            const auto held = static_cast<std::string_view>(bytes);
            const Released released;
            return std::make_shared<WorldHandle>(io::world_from_bytes(held));
        }
    ));
    type.def(
        "save",
        [](const WorldHandle& w, const std::filesystem::path& path) {
            job::require_outside_runs(path);
            const Reading reading(w);
            const Released released;
            io::save_world(path, reading.world());
        },
        py::arg("path"), "Saves the state to the last bit, as a stage's state.h5."
    );
    type.def_static(
        "load",
        [](const std::filesystem::path& path) {
            const Released released;
            return std::make_shared<WorldHandle>(io::load_world(path).world);
        },
        py::arg("path"), "Loads a state.h5; an IoError where any byte of it has changed since it was written."
    );
}

} // namespace

void bind_world(py::module_& m) {
    bind_grains(m);
    py::class_<WorldHandle, Handle> type(
        m, "World",
        "Grains in a periodic cell, with contacts and their memory: a state that steps.\n\n"
        "cell: three edges, or a 3 x 3 matrix whose columns are the cell vectors [m]\nposition: n x 3 [m]\n"
        "radius: n [m]\nvelocity, spin: n x 3 [m/s], [rad/s]\nfine: n truth values"
    );
    type.def(
        py::init(&make_world), py::arg("cell"), py::arg("position"), py::arg("radius"), py::kw_only(),
        py::arg("velocity") = py::none(), py::arg("spin") = py::none(), py::arg("fine") = py::none(),
        py::arg_v("material", grains::Material{}, "Material()"), py::arg("seed") = 0
    );
    type.def_property_readonly(
        "grains", [](const Handle& w) { return GrainTable{w}; }, "The grain table: a row a grain."
    );
    type.def_property_readonly(
        "contacts", [](const WorldHandle& w) { return take_contacts(SeenWorld(w)); },
        "The touching contacts as the last step left them, a row each; before the first step those of the geometry, "
        "without "
        "shear forces and moments."
    );
    type.def_property(
        "material", [](WorldHandle& w) -> grains::Material& { return w.world().material; },
        [](WorldHandle& w, const grains::Material& material) { w.world().material = material; },
        py::return_value_policy::reference_internal,
        "Constants of the contact law; fields may be set. Masses follow the density."
    );
    type.def_property_readonly(
        "step_number", [](const WorldHandle& w) { return w.world().clock.step; }, "Steps made so far [-]."
    );
    type.def_property_readonly(
        "time", [](const WorldHandle& w) { return w.world().clock.time; }, "Simulated so far [s]."
    );
    type.def_property_readonly(
        "seed", [](const WorldHandle& w) { return w.world().seed; }, "Of all random numbers [-]."
    );
    type.def("__len__", [](const WorldHandle& w) { return w.world().grains.size(); });
    type.def("__repr__", [](const WorldHandle& w) {
        if (!w.is_open()) {
            return std::string("<suffuse.World: in use by a call that steps it>");
        }
        return fmt::format(
            "<suffuse.World: {} grains, void ratio {:.4f}, mean stress {:.4g} kPa>", w.world().grains.size(),
            dem::void_ratio(w.world()), dem::mean_stress(dem::mean_stress_tensor(SeenWorld(w))) / 1e3
        );
    });
    bind_cell(type);
    bind_measures(type);
    bind_changes(type);
}

} // namespace suffuse::python
