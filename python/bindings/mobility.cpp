// Gradients that move the fines of a World against their weight.

#include "suffuse/erosion/mobility.hpp"

#include "suffuse/stokes/water.hpp"

#include "python/bindings/bindings.hpp"
#include "python/bindings/convert.hpp"
#include "python/bindings/key_value.hpp"
#include "python/bindings/stage_work.hpp"
#include "python/bindings/typed.hpp"
#include "python/bindings/work.hpp"
#include <cmath>
#include <limits>
#include <unordered_map>

namespace suffuse::python {
namespace {

/// A column of the ramp.
template <class Value>
auto of_ramp(const erosion::MobilityResult& mobility, Value value) {
    py::array_t<decltype(value(erosion::MobilityStep{}))> column(static_cast<py::ssize_t>(mobility.ramp.size()));
    for (std::size_t k = 0; k < mobility.ramp.size(); ++k) {
        column.mutable_at(static_cast<py::ssize_t>(k)) = value(mobility.ramp[k]);
    }
    return column;
}

/// A row a grain of the world, in its order; not a number where the grain is coarse or stays.
py::array_t<double> by_grain(const erosion::MobilityResult& mobility, const dem::World& world) {
    std::unordered_map<std::uint32_t, double> known;
    for (std::size_t k = 0; k < mobility.id.size(); ++k) {
        known[mobility.id[k]] = mobility.mobile_gradient[k];
    }
    py::array_t<double> column(static_cast<py::ssize_t>(world.grains.size()));
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        const auto found = known.find(world.grains.id[g]);
        column.mutable_at(static_cast<py::ssize_t>(g)) =
            found == known.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
    }
    return column;
}

py::dict to_dict(const erosion::MobilityResult& mobility, const dem::World& world) {
    using erosion::MobilityStep;
    py::dict moves, at_most, dict;
    moves["1 %"] = mobility.moves_1;
    moves["10 %"] = mobility.moves_10;
    moves["50 %"] = mobility.moves_50;
    at_most["1 %"] = erosion::is_upper_bound(mobility, 0.01);
    at_most["10 %"] = erosion::is_upper_bound(mobility, 0.1);
    at_most["50 %"] = erosion::is_upper_bound(mobility, 0.5);
    dict["gradient"] = of_ramp(mobility, [](const MobilityStep& s) { return s.gradient; });
    dict["mobile_mass_share"] = of_ramp(mobility, [](const MobilityStep& s) { return s.mobile_mass_share; });
    dict["mobile_number_share"] = of_ramp(mobility, [](const MobilityStep& s) { return s.mobile_number_share; });
    dict["lifted_mass_share"] = of_ramp(mobility, [](const MobilityStep& s) { return s.lifted_mass_share; });
    dict["held_for"] = of_ramp(mobility, [](const MobilityStep& s) { return s.held_for; });
    dict["still_moving"] = of_ramp(mobility, [](const MobilityStep& s) { return s.still_moving; });
    dict["still_growing"] = of_ramp(mobility, [](const MobilityStep& s) { return erosion::is_still_growing(s); });
    dict["permeability"] = of_ramp(mobility, [](const MobilityStep& s) { return s.permeability; });
    dict["mobile_gradient"] = by_grain(mobility, world);
    dict["critical_gradient"] = moves;
    dict["critical_gradient_at_most"] = at_most;
    dict["terzaghi_gradient"] = mobility.critical_gradient;
    dict["heave_gradient"] = mobility.heave_gradient;
    dict["alpha_fines"] = mobility.alpha_fines;
    dict["skempton_brogan_gradient"] = mobility.skempton_brogan_gradient;
    dict["fines_heave_gradient"] = mobility.fines_heave_gradient;
    dict["fines_drag_share"] = mobility.drag_share;
    dict["load_bearing_mass_share"] = mobility.load_bearing_mass_share;
    dict["sifting_mass_share"] = mobility.sifting_mass_share;
    dict["weight_scale"] = mobility.weight_scale;
    dict["steps"] = mobility.rest_steps + mobility.ramp_steps;
    if (const std::optional<erosion::FactorOfSafety> safety = erosion::factor_of_safety(mobility)) {
        dict["factor_of_safety"] = safety->factor;
        dict["factor_of_safety_at_least"] = safety->at_least;
        dict["factor_of_safety_at_most"] = safety->is_at_most;
    }
    return dict;
}

/// A list, or the ramp of a case that does not say.
std::vector<double> gradients_of(const py::object& gradients) {
    if (gradients.is_none()) {
        return erosion::even_gradients(1.2, 24);
    }
    return numbers_of(gradients, "gradients");
}

py::dict mobility(
    WorldHandle& w, const NumbersOrNone& gradients, const Direction& direction, const Direction& down,
    const QuantityOrNone& specified_gradient, const Quantity& acceleration, const flow::Fluid& fluid,
    const std::string& solver, const Quantity& hold_at_most, const Quantity& fluid_drag, const Quantity& moved,
    const Quantity& softness, const CallableOrNone& on_progress
) {
    erosion::MobilitySetting setting;
    setting.gravity = {direction_of(down), value_of(key_of("gravity", "acceleration"), acceleration, "acceleration")};
    setting.fluid = fluid;
    setting.direction = direction_of(direction);
    setting.gradients = gradients_of(gradients);
    setting.specified_gradient =
        optional_value_of(key_of("stage.detach", "asked_gradient"), specified_gradient, "asked_gradient");
    const auto motion_value = [](const Quantity& value, const char* key) {
        return value_of(key_of("stage.detach", key), value, key);
    };
    setting.motion = {
        motion_value(hold_at_most, "hold_at_most"), motion_value(fluid_drag, "fluid_drag"),
        motion_value(moved, "moved"), motion_value(softness, "softness")};
    flow::SolverChoice how{word_of(solver, casefile::names::solver, "solver")};
    erosion::MobilityResult result;
    Stepping call(w);
    Attention attention(on_progress, call);
    {
        const Working working;
        dem::World sample = call.world(); // whose rows stay in their order, and which stays as it is
        if (dem::awaits_first_step(sample)) {
            dem::add_first_contacts(sample);
        }
        const Pulse pulse = [&](std::string_view part, long long steps) { attention.beat(part, steps); };
        const auto solve = [&](const dem::World& copy) {
            const stokes::Water water = stokes::solve_water(
                copy.cell, copy.grains.position, copy.grains.radius, copy.grains.fine, {1, setting.direction}, fluid,
                how, pulse
            );
            return erosion::UnitSeepage{water.grain_force(), water.source, water.permeability()};
        };
        result = erosion::find_mobility(sample, setting, solve, pulse);
    }
    return to_dict(result, call.world());
}

} // namespace

void bind_mobility(py::module_& m) {
    auto type = py::reinterpret_borrow<py::class_<WorldHandle, Handle>>(m.attr("World"));
    type.def(
        "mobility", &mobility, py::arg("gradients") = py::none(), py::kw_only(), py::arg("direction") = "z",
        py::arg("down") = "-z", py::arg("asked_gradient") = py::none(), py::arg("acceleration") = gravity,
        py::arg_v("fluid", flow::Fluid{}, "Fluid()"), py::arg("solver") = "network",
        py::arg("hold_at_most") = erosion::WeighedMotion{}.hold_at_most,
        py::arg("fluid_drag") = erosion::WeighedMotion{}.fluid_drag, py::arg("moved") = erosion::WeighedMotion{}.moved,
        py::arg("softness") = erosion::WeighedMotion{}.softness, py::arg("on_progress") = py::none(),
        with_keys(
            "Which fines a rising gradient moves against their weight, as a stage that does \"detach\" in a case with "
            "[gravity]; the world itself does not change. The ramp is refined until the gradients that move 1 and 10 % "
            "are known to 0.01. Returns a dictionary: for each gradient that was borne arrays `gradient`, "
            "`mobile_mass_share`, `mobile_number_share`, `lifted_mass_share`, `held_for`, `still_moving`, "
            "`still_growing` (the shares are then lower bounds) and `permeability`; for each grain `mobile_gradient`; "
            "and the numbers of stage.json.\n"
            "on_progress: called as on_progress(part, steps) ten times a second at most; what it raises ends the work",
            {{"stage.detach", "gradients"},
             {"stage.detach", "direction"},
             {"gravity", "down"},
             {"gravity", "acceleration"},
             {"stage.detach", "asked_gradient"},
             {"stage.flow", "solver"},
             {"stage.detach", "hold_at_most"},
             {"stage.detach", "fluid_drag"},
             {"stage.detach", "moved"},
             {"stage.detach", "softness"}}
        ).c_str()
    );
}

} // namespace suffuse::python
