// What moves a world: steps under a loading and under forces, settling, relaxing, triaxial tests and stress probes.

#include "suffuse/base/error.hpp"
#include "suffuse/casefile/names.hpp"
#include "suffuse/dem/drive_world.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/dem/relax.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/record/result_json.hpp"
#include "suffuse/run/laboratory_numbers.hpp"
#include "suffuse/run/measure.hpp"
#include "suffuse/triaxial/response.hpp"
#include "suffuse/triaxial/stress_probe.hpp"

#include <fmt/format.h>

#include "python/bindings/bindings.hpp"
#include "python/bindings/convert.hpp"
#include "python/bindings/key_value.hpp"
#include "python/bindings/stage_work.hpp"
#include "python/bindings/typed.hpp"
#include "python/bindings/views.hpp"
#include "python/bindings/warn_caller.hpp"
#include "python/bindings/work.hpp"
#include "python/bindings/world_handle.hpp"
#include <cstdint>
#include <limits>

namespace suffuse::python {
namespace {

constexpr const char* usual_mode = "reference";

dem::Mode mode_of(const std::string& word) {
    for (const dem::Mode mode : {dem::Mode::Reference, dem::Mode::Fast}) {
        if (word == dem::name_of(mode)) {
            return mode;
        }
    }
    throw CaseError(fmt::format("mode: found \"{}\", expected reference or fast", word));
}

double damping_of(const py::object& value) {
    return value_of(key_of("contact", "damping"), value, "damping");
}

/// Nothing where it is to be computed. @throws CaseError where it is beyond what the sample can take
std::optional<double> time_step_of(const py::object& value, double damping, Stepping& call) {
    if (py::isinstance<py::str>(value) && value.cast<std::string>() == "computed") {
        return std::nullopt;
    }
    const auto given = optional_value_of(key_of("stage.advance", "time_step"), value, "time_step");
    if (given) {
        call.check_time_step(*given, damping);
    }
    return given;
}

/// What the caller of a step requested.
struct StepRequest {
    dem::StepPlan plan; ///< its time step is 0 where it is to be computed
    grains::GrainLoad load;
};

std::shared_ptr<StepRequest> read_request(
    Stepping& call, const cell::Loading& loading, const py::object& time_step, const py::object& damping,
    const py::object& force, const std::string& mode
) {
    auto given = std::make_shared<StepRequest>();
    given->plan.mode = mode_of(mode);
    given->plan.loading = loading;
    for (const cell::AxisControl& axis : loading.axis) {
        if (axis.control == cell::Control::Stress) {
            refuse_too_soft(call.world().material, axis.value);
        }
    }
    given->plan.damping = damping_of(damping);
    given->plan.dt = time_step_of(time_step, given->plan.damping, call).value_or(0);
    if (!force.is_none()) {
        given->load.force = vectors_of(force, "force", call.world().grains.size());
        given->plan.load = &given->load;
    }
    return given;
}

py::array_t<double> step(
    WorldHandle& w, std::int64_t steps, const cell::Loading& loading, const QuantityOrNone& time_step,
    const Quantity& damping, const NumbersOrNone& force, const std::string& mode, const CallableOrNone& on_progress
) {
    if (steps < 1) {
        throw CaseError(fmt::format("steps: found {}, expected 1 or more", steps));
    }
    Stepping call(w);
    const auto given = read_request(call, loading, time_step, damping, force, mode);
    dem::Advancing advancing;
    Mat3 stress;
    Attention attention(on_progress, call);
    {
        const Working working;
        stress = dem::advance_world(
            call.world(), call.caches(), given->plan, steps, advancing,
            [] { return std::numeric_limits<std::int64_t>::max(); },
            [&](std::int64_t /*steps*/) {
                call.remember_place(); // before an exception may end the work
                attention.beat("step", advancing.done);
                call.caches(); // afresh, where the world was changed meanwhile
            }
        );
    }
    return to_array(stress);
}

py::dict settle(
    WorldHandle& w, const cell::Loading& loading, const dem::BalanceSpec& balance, const QuantityOrNone& time_step,
    const Quantity& damping, std::int64_t max_steps, const NumbersOrNone& force, const std::string& mode,
    const CallableOrNone& on_progress
) {
    Stepping call(w);
    const auto given = read_request(call, loading, time_step, damping, force, mode);
    count_of(key_of("stage.settle", "max_steps"), max_steps, "max_steps");
    dem::Settling settling = dem::begin_settling(SeenWorld(call.world()));
    if (force.is_none()) {
        dem::sort_along_curve(call.world_for_new_rows()); // as a stage of a case; a force has the rows of its caller
    }
    Attention attention(on_progress, call);
    {
        const Working working;
        dem::settle_world(
            call.world(), call.caches(), given->plan, balance, max_steps, settling,
            [&](bool /*is_over*/) {
                call.remember_place();
                attention.beat("settle", settling.balance.steps);
                call.caches();
            }
        );
    }
    warn_caller(run::words_on_overlap(settling.balance.equilibrium.max_overlap_ratio, call.world().material));
    nlohmann::json reached(settling.balance);
    reached["collapsed"] = settling.collapsed;
    return to_python(reached);
}

py::dict relax(
    WorldHandle& w, double wanted, const QuantityOrNone& time_step, const Quantity& damping, std::int64_t max_steps,
    const CallableOrNone& on_progress
) {
    Stepping call(w);
    const auto given = read_request(call, {}, time_step, damping, py::none(), usual_mode);
    count_of(key_of("stage.settle", "max_steps"), max_steps, "max_steps");
    if (!(wanted > 0)) {
        throw CaseError(fmt::format("wanted: found {}, expected an unbalanced force above 0", wanted));
    }
    Attention attention(on_progress, call);
    dem::Relaxation relaxation;
    {
        const Working working;
        const double dt =
            given->plan.dt > 0 ? given->plan.dt : dem::stable_time_step(call.world(), {given->plan.damping});
        dem::relax(
            call.world(), call.caches(), dt, given->plan.damping, wanted, max_steps, relaxation,
            [&](std::string_view part, long long steps) {
                call.remember_place();
                attention.beat(part, steps);
            }
        );
        call.remember_place();
    }
    py::dict dict;
    dict["unbalanced_force"] = relaxation.unbalanced_force;
    dict["steps"] = relaxation.steps;
    dict["reached_floor"] = relaxation.reached_floor;
    return dict;
}

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
        const Loan loan(call, state);
        state = triaxial::begin_path(world, spec, dem::mean_stress_tensor(world));
        for (bool over = false; !over;) {
            over = triaxial::path_burst(world, call.caches(), spec, {}, given_damping, given_mode, state);
            call.remember_place();
            attention.beat("shear", state.steps);
        }
    }
    warn_caller(run::words_on_hold(state.rows, spec.path));
    nlohmann::json result = run::laboratory_numbers(spec, state.rows);
    if (result.empty()) {
        result["response"] = triaxial::summarize(state.rows, spec);
    }
    result["curve"] = state.rows;
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
    const CallableOrNone& on_progress
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
    spec.stress_ratio = optional_value_of(key("stress_ratio"), stress_ratio, "stress_ratio");
    return run_test(call, spec, {inertial_number, inertia, time_step, rows, damping, mode, on_progress});
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
    int cycles, const Quantity& pore_pressure_ratio, const Quantity& double_amplitude, const Quantity& inertial_number,
    const std::string& inertia, const QuantityOrNone& time_step, int rows, const Quantity& damping,
    const std::string& mode, const CallableOrNone& on_progress
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
    return run_test(call, spec, {inertial_number, inertia, time_step, rows, damping, mode, on_progress});
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

} // namespace

void bind_steps(py::module_& m) {
    auto type = py::reinterpret_borrow<py::class_<WorldHandle, Handle>>(m.attr("World"));
    const std::string pace =
        "\ntime_step: computed from the contact network, and again every 1000 steps and as contacts come, unless given"
        "\ndamping: " +
        key_doc(key_of("contact", "damping"));
    const std::string progress =
        "\non_progress: called as on_progress(part, steps) ten times a second at most; what it raises ends the work";
    const std::string common = pace +
                               "\nforce: n x 3, on each grain from outside the skeleton [N]"
                               "\nmode: \"reference\", or \"fast\": contact law and memory in single precision" +
                               progress;
    type.def(
        "step", &step, py::arg("steps"), py::arg_v("loading", cell::Loading{}, "Loading()"), py::kw_only(),
        py::arg("time_step") = py::none(), py::arg("damping") = dem::usual_damping, py::arg("force") = py::none(),
        py::arg("mode") = usual_mode, py::arg("on_progress") = py::none(),
        ("Advances by `steps` under `loading`, at constant volume unless given; returns the stress of the last step "
         "[Pa].\n" +
         common)
            .c_str()
    );
    type.def(
        "settle", &settle, py::arg_v("loading", cell::Loading{}, "Loading()"), py::kw_only(),
        py::arg_v("balance", dem::BalanceSpec{}, "Balance()"), py::arg("time_step") = py::none(),
        py::arg("damping") = dem::usual_damping, py::arg("max_steps") = dem::SettleSpec{}.max_steps,
        py::arg("force") = py::none(), py::arg("mode") = usual_mode, py::arg("on_progress") = py::none(),
        ("Steps until balanced, at constant volume or under the stresses of `loading`, as a stage that does "
         "\"settle\", "
         "to the same bits: a drag kills the slow modes, and the grains are stored along a curve first (World.sort) "
         "unless a `force` is given. Returns a dictionary of what was reached: `steps`, `balanced_steps` (in a "
         "row), "
         "`equilibrium` (as World.balance), `stress` [Pa]; `collapsed` is true where the volume is held and nothing is "
         "carried any more, which ends the settling.\n" +
         common)
            .c_str()
    );
    type.def(
        "relax", &relax, py::arg("wanted") = 1e-8, py::kw_only(), py::arg("time_step") = py::none(),
        py::arg("damping") = dem::usual_damping, py::arg("max_steps") = dem::most_relax_steps,
        py::arg("on_progress") = py::none(),
        ("Relaxes at constant volume until the unbalanced force is below `wanted`, or falls no more. Returns a "
         "dictionary: "
         "`unbalanced_force`, `steps`, `reached_floor` (it fell no more).\n" +
         pace + progress)
            .c_str()
    );
    type.def(
        "triaxial", &run_triaxial, py::arg("strain") = triaxial::TriaxialSpec{}.strain, py::kw_only(),
        py::arg("path") = "drained", py::arg("direction") = "compression", py::arg("b") = py::none(),
        py::arg("strain_ratio") = py::none(), py::arg("deviator_stress") = py::none(),
        py::arg("stress_ratio") = py::none(), py::arg("inertial_number") = triaxial::TriaxialSpec{}.inertial_number,
        py::arg("inertia") = "lent", py::arg("time_step") = py::none(), py::arg("rows") = triaxial::TriaxialSpec{}.rows,
        py::arg("damping") = dem::usual_damping, py::arg("mode") = usual_mode, py::arg("on_progress") = py::none(),
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
            "on_progress: called as on_progress(part, steps) ten times a second at most; what it raises ends the work",
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
            "Loads to and fro along z." + of_test, {{"stage.cyclic", "csr"},
                                                    {"stage.cyclic", "strain_amplitude"},
                                                    {"stage.cyclic", "drainage"},
                                                    {"stage.cyclic", "cycles"},
                                                    {"stage.cyclic.until", "pore_pressure_ratio"},
                                                    {"stage.cyclic.until", "double_amplitude"}}
        ),
        py::kw_only(), py::arg("csr") = py::none(), py::arg("strain_amplitude") = py::none(),
        py::arg("drainage") = "undrained", py::arg("cycles") = cycles.number,
        py::arg("pore_pressure_ratio") = cycles.pore_pressure_ratio,
        py::arg("double_amplitude") = cycles.double_amplitude
    );
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

} // namespace suffuse::python
