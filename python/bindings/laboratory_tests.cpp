// Tests of a laboratory on a world: triaxial, oedometer, isotropic, plane strain, shear, cyclic; stress probes and
// stiffness.

#include "suffuse/base/error.hpp"
#include "suffuse/casefile/names.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/record/result_json.hpp"
#include "suffuse/run/laboratory_numbers.hpp"
#include "suffuse/run/measure.hpp"
#include "suffuse/triaxial/response.hpp"
#include "suffuse/triaxial/stiffness.hpp"
#include "suffuse/triaxial/stress_probe.hpp"

#include "python/bindings/bindings.hpp"
#include "python/bindings/convert.hpp"
#include "python/bindings/key_value.hpp"
#include "python/bindings/stage_work.hpp"
#include "python/bindings/step_arguments.hpp"
#include "python/bindings/typed.hpp"
#include "python/bindings/warn_caller.hpp"
#include "python/bindings/work.hpp"
#include "python/bindings/world_handle.hpp"

namespace suffuse::python {
namespace {

using WorldClass = py::class_<WorldHandle, Handle>;

/// A number, or one of the words of a case.
double inertial_number_of(const py::object& value) {
    if (py::isinstance<py::str>(value)) {
        for (const auto& known : casefile::names::inertial_number) {
            if (known.word == value.cast<std::string>()) {
                return known.value;
            }
        }
    }
    return value_of(key_of("stage.triaxial", "inertial_number"), value, "inertial_number");
}

/// How quickly a test loads, how closely it is recorded, and what is called meanwhile.
struct Pace {
    Quantity inertial_number;
    std::string inertia;
    QuantityOrNone time_step;
    int rows;
    Quantity damping;
    std::string mode;
    CallableOrNone on_progress;
    flow::Fluid fluid = {}; ///< of an undrained test
};

py::dict run_test(Stepping& call, triaxial::TriaxialSpec spec, const Pace& pace) {
    const dem::Mode given_mode = mode_of(pace.mode);
    spec.inertia = word_of(pace.inertia, casefile::names::grain_inertia, "inertia");
    spec.inertial_number = inertial_number_of(pace.inertial_number);
    const double given_damping = damping_of(pace.damping);
    spec.time_step = time_step_of(pace.time_step, given_damping, call).value_or(0);
    spec.rows = static_cast<int>(count_of(key_of("stage.triaxial", "rows"), pace.rows, "rows"));
    triaxial::PathState state;
    Attention attention(pace.on_progress, call);
    dem::World& world = begin(call);
    {
        const Working working;
        std::optional<triaxial::PoreFluid> fluid;
        if (pace.fluid.bulk_modulus && spec.path == triaxial::Path::Undrained) {
            const Pulse pulse = [&](std::string_view part, long long steps) { attention.beat(part, steps); };
            fluid = {*pace.fluid.bulk_modulus, triaxial::measure_skeleton_modulus(world, given_damping, pulse)};
        }
        const Loan loan(call, state);
        state = triaxial::begin_path(world, spec, dem::mean_stress_tensor(world), fluid);
        for (bool over = false; !over;) {
            over = triaxial::path_burst(world, call.caches(), spec, {}, given_damping, given_mode, state);
            call.remember_place();
            attention.beat("shear", state.steps);
        }
    }
    warn_caller(run::words_on_hold(state.rows, spec));
    nlohmann::json result = run::laboratory_numbers(spec, state.rows);
    if (result.empty()) {
        result["response"] = triaxial::summarize(state.rows, spec);
    }
    result["curve"] = state.rows;
    if (spec.path == triaxial::Path::Undrained) {
        result["skempton_b"] = state.skempton_b;
    }
    result["steps"] = state.steps;
    result["strain_rate"] = state.strain_rate;
    result["median_diameter"] = state.median_diameter;
    return to_python(result);
}

py::dict run_triaxial(
    WorldHandle& w, const Quantity& strain, const std::string& path, const std::string& direction,
    const QuantityOrNone& b, const QuantityOrNone& strain_ratio, const QuantityOrNone& deviator_stress,
    const QuantityOrNone& stress_ratio, const Quantity& inertial_number, const std::string& inertia,
    const QuantityOrNone& time_step, int rows, const Quantity& damping, const std::string& mode,
    const CallableOrNone& on_progress, const flow::Fluid& fluid
) {
    Stepping call(w);
    triaxial::TriaxialSpec spec;
    const auto key = [](const char* name) -> const casefile::Key& { return key_of("stage.triaxial", name); };
    spec.strain = value_of(key("strain"), strain, "strain");
    spec.path = word_of(path, casefile::names::triaxial_path, "path");
    spec.direction = word_of(direction, casefile::names::direction, "direction");
    spec.b = optional_value_of(key("b"), b, "b");
    spec.strain_ratio = optional_value_of(key("strain_ratio"), strain_ratio, "strain_ratio");
    spec.deviator_stress = optional_value_of(key("deviator_stress"), deviator_stress, "deviator_stress");
    refuse_too_soft(call.world().material, spec.deviator_stress.value_or(0));
    spec.stress_ratio = optional_value_of(key("stress_ratio"), stress_ratio, "stress_ratio");
    return run_test(call, spec, {inertial_number, inertia, time_step, rows, damping, mode, on_progress, fluid});
}

/// `Spec` is that of the oedometer or of isotropic compression.
template <class Spec>
py::dict run_stresses(
    WorldHandle& w, const std::vector<Quantity>& stresses, const Quantity& strain, const Quantity& inertial_number,
    const std::string& inertia, const QuantityOrNone& time_step, int rows, const Quantity& damping,
    const std::string& mode, const CallableOrNone& on_progress
) {
    if (stresses.empty()) {
        throw CaseError("stresses: found none; expected one and more, as in [\"400 kPa\", \"50 kPa\"]");
    }
    Stepping call(w);
    Spec spec;
    spec.stresses.reserve(stresses.size());
    for (const Quantity& stress : stresses) {
        spec.stresses.push_back(value_of(key_of("stage.oedometer", "stresses"), stress, "stresses"));
        refuse_too_soft(call.world().material, spec.stresses.back());
    }
    spec.strain = value_of(key_of("stage.oedometer", "strain"), strain, "strain");
    return run_test(call, spec, {inertial_number, inertia, time_step, rows, damping, mode, on_progress});
}

py::dict run_plane_strain(
    WorldHandle& w, const Quantity& strain, const std::string& direction, const Quantity& inertial_number,
    const std::string& inertia, const QuantityOrNone& time_step, int rows, const Quantity& damping,
    const std::string& mode, const CallableOrNone& on_progress
) {
    Stepping call(w);
    triaxial::PlaneStrainSpec spec;
    spec.strain = value_of(key_of("stage.plane-strain", "strain"), strain, "strain");
    spec.direction = word_of(direction, casefile::names::direction, "direction");
    return run_test(call, spec, {inertial_number, inertia, time_step, rows, damping, mode, on_progress});
}

py::dict run_shear(
    WorldHandle& w, const Quantity& strain, const std::string& hold, const std::string& axes,
    const Quantity& inertial_number, const std::string& inertia, const QuantityOrNone& time_step, int rows,
    const Quantity& damping, const std::string& mode, const CallableOrNone& on_progress
) {
    Stepping call(w);
    triaxial::ShearSpec spec;
    spec.strain = value_of(key_of("stage.shear", "strain"), strain, "strain");
    spec.path = word_of(hold, casefile::names::shear_hold, "hold");
    spec.shear_axes = word_of(axes, casefile::names::shear_axes, "axes");
    spec.axis = spec.shear_axes.normal;
    return run_test(call, spec, {inertial_number, inertia, time_step, rows, damping, mode, on_progress});
}

py::dict run_cyclic(
    WorldHandle& w, const QuantityOrNone& csr, const QuantityOrNone& strain_amplitude, const std::string& drainage,
    int cycles, const Quantity& pore_pressure_ratio, const Quantity& double_amplitude, const flow::Fluid& fluid,
    const Quantity& inertial_number, const std::string& inertia, const QuantityOrNone& time_step, int rows,
    const Quantity& damping, const std::string& mode, const CallableOrNone& on_progress
) {
    Stepping call(w);
    triaxial::CyclicSpec spec;
    const auto key = [](const char* name) -> const casefile::Key& { return key_of("stage.cyclic", name); };
    spec.path = word_of(drainage, casefile::names::drainage, "drainage");
    spec.cycles->csr = optional_value_of(key("csr"), csr, "csr");
    spec.cycles->strain = optional_value_of(key("strain_amplitude"), strain_amplitude, "strain_amplitude");
    spec.cycles->number = static_cast<int>(count_of(key("cycles"), cycles, "cycles"));
    const auto until = [](const char* name) -> const casefile::Key& { return key_of("stage.cyclic.until", name); };
    spec.cycles->pore_pressure_ratio =
        value_of(until("pore_pressure_ratio"), pore_pressure_ratio, "pore_pressure_ratio");
    spec.cycles->double_amplitude = value_of(until("double_amplitude"), double_amplitude, "double_amplitude");
    spec.strain = spec.cycles->double_amplitude;
    return run_test(call, spec, {inertial_number, inertia, time_step, rows, damping, mode, on_progress, fluid});
}

py::list run_stress_probe(
    WorldHandle& w, const Quantity& increment, int directions, const Quantity& unbalanced_force,
    const QuantityOrNone& time_step, const Quantity& damping, const CallableOrNone& on_progress
) {
    Stepping call(w);
    triaxial::StressProbeSpec spec;
    const auto key = [](const char* name) -> const casefile::Key& { return key_of("stage.stress-probe", name); };
    spec.increment = value_of(key("increment"), increment, "increment");
    spec.directions = static_cast<int>(count_of(key("directions"), directions, "directions"));
    spec.unbalanced_force = value_of(key("unbalanced_force"), unbalanced_force, "unbalanced_force");
    const double given_damping = damping_of(damping);
    spec.time_step = time_step_of(time_step, given_damping, call).value_or(0);
    std::vector<triaxial::StressProbe> probes;
    Attention attention(on_progress, call);
    const dem::World world = begin_copy(call);
    {
        const Working working;
        const Pulse pulse = [&](std::string_view part, long long steps) { attention.beat(part, steps); };
        const triaxial::ProbedState state = triaxial::rest_for_probes(world, spec, given_damping, pulse);
        for (int number = 0; number < directions; ++number) {
            probes.push_back(triaxial::probe_direction(state, spec, number, given_damping, pulse));
        }
    }
    return to_python(nlohmann::json(probes));
}

py::dict run_stiffness(
    WorldHandle& w, const Quantity& increment, const Quantity& unbalanced_force, const QuantityOrNone& time_step,
    const Quantity& damping, const CallableOrNone& on_progress
) {
    Stepping call(w);
    triaxial::StiffnessSpec spec;
    spec.increment = value_of(key_of("stage.stiffness", "increment"), increment, "increment");
    spec.unbalanced_force =
        value_of(key_of("stage.stiffness", "unbalanced_force"), unbalanced_force, "unbalanced_force");
    const double given_damping = damping_of(damping);
    spec.time_step = time_step_of(time_step, given_damping, call).value_or(0);
    std::vector<triaxial::StrainProbe> probes;
    Attention attention(on_progress, call);
    const dem::World world = begin_copy(call);
    triaxial::Stiffness stiffness;
    {
        const Working working;
        const Pulse pulse = [&](std::string_view part, long long steps) { attention.beat(part, steps); };
        triaxial::ProbeAdvice advice;
        advice.at_yielding = "probe a state further from failure";
        triaxial::RestedState state = triaxial::rest_for_strains(world, spec, given_damping, pulse, advice);
        for (int number = 0; number < triaxial::strain_directions; ++number) {
            const Mat3 direction = triaxial::strain_direction(number);
            probes.push_back(triaxial::probe_strain(state, spec, direction, given_damping, pulse, advice));
        }
        stiffness = triaxial::stiffness_of(state, probes);
    }
    warn_caller(run::words_on_stiffness(stiffness, spec));
    return to_python(nlohmann::json(stiffness));
}

void bind_triaxial(WorldClass& type) {
    type.def(
        "triaxial", &run_triaxial, py::arg("strain") = triaxial::TriaxialSpec{}.strain, py::kw_only(),
        py::arg("path") = "drained", py::arg("direction") = "compression", py::arg("b") = py::none(),
        py::arg("strain_ratio") = py::none(), py::arg("deviator_stress") = py::none(),
        py::arg("stress_ratio") = py::none(), py::arg("inertial_number") = triaxial::TriaxialSpec{}.inertial_number,
        py::arg("inertia") = "lent", py::arg("time_step") = py::none(), py::arg("rows") = triaxial::TriaxialSpec{}.rows,
        py::arg("damping") = dem::usual_damping, py::arg("mode") = usual_mode, py::arg("on_progress") = py::none(),
        py::arg_v("fluid", flow::Fluid{}, "Fluid()"),
        with_keys(
            "Compresses or extends along z, as a stage that does \"triaxial\". Returns a dictionary: `curve`, "
            "`response`, "
            "`steps`, `strain_rate` [1/s] and `median_diameter` [m].\n\n"
            "curve: a list of rows, each with axial_strain, volumetric_strain [-], stress (3 x 3), mean_stress p, "
            "deviator_stress q (axial minus mean lateral), excess_pore_pressure [Pa], void_ratio, coordination, "
            "mechanical_coordination, unbalanced_force, inertial_number [-], second_order_work (since the row before) "
            "and energy (its parts, since the start) [J/m3]\n"
            "response: peak_deviator, final_deviator, stiffness (E50), excess_pore_pressure [Pa], peak_ratio (q/p), "
            "peak_strain, dilatancy, largest_contraction, final_volumetric_strain, lost_at [-], friction_angle [rad], "
            "instability (p, q, strain), liquefied, energy [J/m3]; None if the test does not determine it\n"
            "time_step: computed unless given\nrows: of the curve\n"
            "mode: \"reference\", or \"fast\": contact law and memory in single precision\n"
            "on_progress: called as on_progress(part, steps) ten times a second at most; what it raises ends the work\n"
            "fluid: of an undrained test; with its bulk_modulus the volume follows the pore pressure, and the "
            "dictionary "
            "has Skempton's B as skempton_b",
            {{"stage.triaxial", "strain"},
             {"stage.triaxial", "path"},
             {"stage.triaxial", "direction"},
             {"stage.triaxial", "b"},
             {"stage.triaxial", "strain_ratio"},
             {"stage.triaxial", "deviator_stress"},
             {"stage.triaxial", "stress_ratio"},
             {"stage.triaxial", "inertial_number"},
             {"stage.triaxial", "inertia"}}
        ).c_str()
    );
}

void bind_other_tests(WorldClass& type) {
    const std::string of_test =
        "\nReturns a dictionary as `triaxial` does, but without `response`; instead it has the numbers and rows that "
        "stage.json has.\ninertial_number, inertia, time_step, rows, damping, mode, on_progress: as for `triaxial`\n";
    const auto def_test = [&](const char* name, auto function, const std::string& words, const auto&... arguments) {
        const triaxial::TriaxialSpec usual;
        type.def(
            name, function, arguments..., py::arg("inertial_number") = usual.inertial_number,
            py::arg("inertia") = "lent", py::arg("time_step") = py::none(), py::arg("rows") = usual.rows,
            py::arg("damping") = dem::usual_damping, py::arg("mode") = usual_mode, py::arg("on_progress") = py::none(),
            words.c_str()
        );
    };
    const triaxial::Cycles cycles;
    const double strain = triaxial::TriaxialSpec{}.strain;
    def_test(
        "oedometer", &run_stresses<triaxial::OedometerSpec>,
        with_keys(
            "Compresses and extends along z without lateral strain." + of_test,
            {{"stage.oedometer", "stresses"}, {"stage.oedometer", "strain"}}
        ),
        py::arg("stresses"), py::kw_only(), py::arg("strain") = strain
    );
    def_test(
        "isotropic", &run_stresses<triaxial::IsotropicSpec>,
        with_keys(
            "Loads and unloads all axes alike." + of_test,
            {{"stage.isotropic", "stresses"}, {"stage.isotropic", "strain"}}
        ),
        py::arg("stresses"), py::kw_only(), py::arg("strain") = strain
    );
    def_test(
        "plane_strain", &run_plane_strain,
        with_keys(
            "Compresses or extends along z at constant length along x and constant stress along y. Returns a "
            "dictionary as `triaxial` does.\n",
            {{"stage.plane-strain", "strain"}, {"stage.plane-strain", "direction"}}
        ),
        py::arg("strain") = strain, py::kw_only(), py::arg("direction") = "compression"
    );
    def_test(
        "shear", &run_shear,
        with_keys(
            "Shears the cell." + of_test, {{"stage.shear", "strain"}, {"stage.shear", "hold"}, {"stage.shear", "axes"}}
        ),
        py::arg("strain") = strain, py::kw_only(), py::arg("hold") = "volume", py::arg("axes") = "zx"
    );
    def_test(
        "cyclic", &run_cyclic,
        with_keys(
            "Loads to and fro along z." + of_test + "fluid: as for `triaxial`\n",
            {{"stage.cyclic", "csr"},
             {"stage.cyclic", "strain_amplitude"},
             {"stage.cyclic", "drainage"},
             {"stage.cyclic", "cycles"},
             {"stage.cyclic.until", "pore_pressure_ratio"},
             {"stage.cyclic.until", "double_amplitude"}}
        ),
        py::kw_only(), py::arg("csr") = py::none(), py::arg("strain_amplitude") = py::none(),
        py::arg("drainage") = "undrained", py::arg("cycles") = cycles.number,
        py::arg("pore_pressure_ratio") = cycles.pore_pressure_ratio,
        py::arg("double_amplitude") = cycles.double_amplitude, py::arg_v("fluid", flow::Fluid{}, "Fluid()")
    );
}

void bind_stress_probe(WorldClass& type) {
    type.def(
        "stress_probe", &run_stress_probe, py::arg("increment") = triaxial::StressProbeSpec{}.increment, py::kw_only(),
        py::arg("directions") = triaxial::StressProbeSpec{}.directions,
        py::arg("unbalanced_force") = triaxial::StressProbeSpec{}.unbalanced_force, py::arg("time_step") = py::none(),
        py::arg("damping") = dem::usual_damping, py::arg("on_progress") = py::none(),
        with_keys(
            "Puts small loads of all directions of axisymmetric stress (z against x and y) on copies of the world, as "
            "a stage that does \"stress-probe\"; returns a list of dictionaries with `angle` [rad], `stress` (change "
            "of "
            "each axis) [Pa], `strain`, `second_order_work` [J/m3], `normalized` (that over |stress| |strain|) [-], "
            "`answer` and `steps` of each. The world stays as it is.\n",
            {{"stage.stress-probe", "increment"},
             {"stage.stress-probe", "directions"},
             {"stage.stress-probe", "unbalanced_force"}}
        ).c_str()
    );
}

void bind_stiffness(WorldClass& type) {
    const triaxial::StiffnessSpec usual;
    type.def(
        "stiffness", &run_stiffness, py::arg("increment") = usual.increment, py::kw_only(),
        py::arg("unbalanced_force") = usual.unbalanced_force, py::arg("time_step") = py::none(),
        py::arg("damping") = dem::usual_damping, py::arg("on_progress") = py::none(),
        with_keys(
            "Puts six small strains on copies of the world, as a stage that does \"stiffness\"; returns a dictionary "
            "with the numbers that stage.json has: `stiffness` (6 x 6 in Voigt's order) [Pa], `young_modulus`, "
            "`shear_modulus`, `bulk_modulus`, `poisson_ratio`, `anisotropy` and others. The world stays as it is.\n",
            {{"stage.stiffness", "increment"}, {"stage.stiffness", "unbalanced_force"}}
        ).c_str()
    );
}

} // namespace

void bind_laboratory_tests(py::module_& m) {
    auto type = py::reinterpret_borrow<WorldClass>(m.attr("World"));
    bind_triaxial(type);
    bind_other_tests(type);
    bind_stress_probe(type);
    bind_stiffness(type);
}

} // namespace suffuse::python
