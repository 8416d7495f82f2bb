// World.migrate: fines that travel with the water in true time.

#include "suffuse/erosion/migration.hpp"

#include "suffuse/run/migration_numbers.hpp"

#include "python/bindings/bindings.hpp"
#include "python/bindings/convert.hpp"
#include "python/bindings/key_value.hpp"
#include "python/bindings/stage_work.hpp"
#include "python/bindings/typed.hpp"
#include "python/bindings/warn_caller.hpp"
#include "python/bindings/work.hpp"
#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

namespace suffuse::python {
namespace {

using erosion::MigrationRow;

/// A column of the rows.
template <class Row, class Value>
py::array_t<double> column_of(const std::vector<Row>& rows, Value value) {
    py::array_t<double> column(static_cast<py::ssize_t>(rows.size()));
    std::ranges::transform(rows, column.mutable_data(), value);
    return column;
}

/// Not a number where the time never came.
py::array_t<double> times_of(const std::vector<double>& times) {
    return column_of(times, [](double time) { return time < 0 ? std::numeric_limits<double>::quiet_NaN() : time; });
}

py::dict ledger_of(const erosion::MigrationLedger& ledger) {
    py::array_t<std::uint32_t> id(static_cast<py::ssize_t>(ledger.size()));
    std::ranges::copy(ledger.id, id.mutable_data());
    py::array_t<std::int32_t> throats(id.size());
    std::ranges::transform(ledger.passed, throats.mutable_data(), &erosion::PassedThroats::count);
    py::list fate;
    for (const erosion::Whereabouts where : ledger.where) {
        fate.append(std::string(name_of(where)));
    }
    const auto as_it_is = [](double value) { return value; };
    py::dict dict;
    dict["id"] = id;
    dict["diameter"] = column_of(ledger.diameter, as_it_is);
    dict["mass"] = column_of(ledger.mass, as_it_is);
    dict["start"] = to_array(ledger.start);
    dict["end"] = to_array(ledger.end);
    dict["entered"] = times_of(ledger.entered);
    dict["departed"] = times_of(ledger.departed);
    dict["left"] = times_of(ledger.left);
    dict["throats"] = throats;
    dict["narrowest"] = column_of(ledger.passed, [](const erosion::PassedThroats& passed) { return passed.narrowest; });
    dict["fate"] = fate;
    return dict;
}

py::dict to_dict(const erosion::Migration& migration) {
    const erosion::MigrationResult& result = migration.result;
    const std::vector<MigrationRow>& rows = result.rows;
    const double all = result.fines_mass;
    py::dict table;
    table["time"] = column_of(rows, [](const MigrationRow& row) { return row.time; });
    table["gradient"] = column_of(rows, [](const MigrationRow& row) { return row.gradient; });
    table["permeability"] = column_of(rows, [](const MigrationRow& row) { return row.permeability; });
    table["eroded_mass_share"] = column_of(rows, [all](const MigrationRow& row) { return row.eroded_mass / all; });
    table["moving_mass_share"] = column_of(rows, [all](const MigrationRow& row) { return row.moving_mass / all; });
    table["lodged_mass_share"] = column_of(rows, [all](const MigrationRow& row) { return row.lodged_mass / all; });
    table["energy"] = column_of(rows, [](const MigrationRow& row) { return row.energy; });
    auto dict = to_python(run::migration_numbers(migration)).cast<py::dict>();
    dict["rows"] = table;
    dict["grains"] = ledger_of(migration.ledger);
    return dict;
}

py::dict migrate(
    WorldHandle& w, const Numbers& gradients, const Direction& direction, const Direction& down,
    const QuantityOrNone& exit, const std::string& skeleton, const Quantity& hold_at_most, const Quantity& still,
    const Quantity& still_for, const Quantity& softness, const QuantityOrNone& friction, const Quantity& with_water,
    const Quantity& solve_after, const QuantityOrNone& feed, const QuantityOrNone& time_at_most,
    const std::optional<std::int64_t>& steps_at_most, const Quantity& acceleration, const flow::Fluid& fluid,
    const CallableOrNone& on_progress
) {
    const auto key = [](const char* name) -> const casefile::Key& { return key_of("stage.migrate", name); };
    const auto value = [&key](const Quantity& given, const char* name) { return value_of(key(name), given, name); };
    erosion::MigrateSpec spec;
    spec.gradients = numbers_of(gradients, "gradients");
    spec.direction = direction_of(direction);
    spec.exit = optional_value_of(key("exit"), exit, "exit");
    spec.skeleton = word_of(skeleton, casefile::names::skeleton, "skeleton");
    spec.hold_at_most = value(hold_at_most, "hold_at_most");
    spec.still = value(still, "still");
    spec.still_for = value(still_for, "still_for");
    spec.softness = value(softness, "softness");
    spec.friction = optional_value_of(key("friction"), friction, "friction");
    spec.with_water = value(with_water, "with_water");
    spec.solve_after = value(solve_after, "solve_after");
    spec.feed = optional_value_of(key("feed"), feed, "feed");
    spec.time_at_most = optional_value_of(key("time_at_most"), time_at_most, "time_at_most");
    if (steps_at_most) {
        spec.steps_at_most = count_of(key("steps_at_most"), *steps_at_most, "steps_at_most");
    }
    spec.gravity = {direction_of(down), value_of(key_of("gravity", "acceleration"), acceleration, "acceleration")};
    Stepping call(w);
    Attention attention(on_progress, call);
    erosion::Surroundings around;
    around.fluid = fluid;
    around.pulse = [&](std::string_view part, long long steps) { attention.beat(part, steps); };
    const dem::World sample = begin_copy(call);
    erosion::Migration migration;
    dem::World after;
    {
        const Working working;
        migration = erosion::begin_migration(sample, spec, around);
        while (!migration.over) {
            erosion::migrate_on(migration, spec, around);
        }
        after = erosion::migrated_sample(migration, around.pulse);
    }
    call.world_for_new_rows() = std::move(after);
    for (const std::string& remark : run::migration_remarks(migration, spec)) {
        warn_caller("migrate: " + remark);
    }
    return to_dict(migration);
}

} // namespace

void bind_migration(py::module_& m) {
    auto type = py::reinterpret_borrow<py::class_<WorldHandle, Handle>>(m.attr("World"));
    const erosion::MigrateSpec usual;
    type.def(
        "migrate", &migrate, py::arg("gradients"), py::kw_only(), py::arg("direction") = "z", py::arg("down") = "-z",
        py::arg("exit") = py::none(), py::arg("skeleton") = "held", py::arg("hold_at_most") = usual.hold_at_most,
        py::arg("still") = usual.still, py::arg("still_for") = usual.still_for, py::arg("softness") = usual.softness,
        py::arg("friction") = py::none(), py::arg("with_water") = usual.with_water,
        py::arg("solve_after") = usual.solve_after, py::arg("feed") = py::none(), py::arg("time_at_most") = py::none(),
        py::arg("steps_at_most") = py::none(), py::arg("acceleration") = gravity,
        py::arg_v("fluid", flow::Fluid{}, "Fluid()"), py::arg("on_progress") = py::none(),
        with_keys(
            "Lets the fines travel with the water in true time while the skeleton is held, as a stage that does "
            "\"migrate\"; the grains that leave are removed from the world. Returns a dictionary: the numbers of "
            "stage.json; `rows`, arrays of a row a solution of the flow: `time` [s], `gradient`, `permeability` [m2], "
            "`eroded_mass_share`, `moving_mass_share`, `lodged_mass_share`, `energy` [J]; and `grains`, arrays of a "
            "row "
            "a fine grain of the world before: `id`, `diameter` [m], `mass` [kg], `start` and `end` (n x 3) [m], "
            "`entered` by `feed`, `departed` and `left` [s], not a number where it never did, `throats` passed between "
            "coarse grains and the `narrowest` of them [m] (0: none), and `fate`: stayed, lodged, moving, eroded or "
            "fixed. A call that is interrupted leaves the world as it was.\n"
            "on_progress: called as on_progress(part, steps) ten times a second at most; what it raises ends the work",
            {{"stage.migrate", "gradients"},
             {"stage.migrate", "direction"},
             {"gravity", "down"},
             {"stage.migrate", "exit"},
             {"stage.migrate", "skeleton"},
             {"stage.migrate", "hold_at_most"},
             {"stage.migrate", "still"},
             {"stage.migrate", "still_for"},
             {"stage.migrate", "softness"},
             {"stage.migrate", "friction"},
             {"stage.migrate", "with_water"},
             {"stage.migrate", "solve_after"},
             {"stage.migrate", "feed"},
             {"stage.migrate", "time_at_most"},
             {"stage.migrate", "steps_at_most"},
             {"gravity", "acceleration"}}
        ).c_str()
    );
}

} // namespace suffuse::python
