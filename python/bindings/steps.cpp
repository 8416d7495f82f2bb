// What moves a world: steps under a loading and under forces, settling, relaxing.

#include "suffuse/base/error.hpp"
#include "suffuse/dem/drive_world.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/dem/relax.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/record/result_json.hpp"
#include "suffuse/run/measure.hpp"

#include <fmt/format.h>

#include "python/bindings/bindings.hpp"
#include "python/bindings/convert.hpp"
#include "python/bindings/key_value.hpp"
#include "python/bindings/stage_work.hpp"
#include "python/bindings/step_arguments.hpp"
#include "python/bindings/typed.hpp"
#include "python/bindings/views.hpp"
#include "python/bindings/warn_caller.hpp"
#include "python/bindings/work.hpp"
#include "python/bindings/world_handle.hpp"
#include <cstdint>
#include <limits>

namespace suffuse::python {
namespace {

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
}

} // namespace suffuse::python
