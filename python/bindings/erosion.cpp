// World.erode: passes of the erosion procedure on a world by hand.

#include "suffuse/base/error.hpp"
#include "suffuse/casefile/names.hpp"
#include "suffuse/erosion/loop.hpp"
#include "suffuse/run/water_notes.hpp"
#include "suffuse/run/water_numbers.hpp"

#include "python/bindings/bindings.hpp"
#include "python/bindings/convert.hpp"
#include "python/bindings/key_value.hpp"
#include "python/bindings/own_rule.hpp"
#include "python/bindings/stage_work.hpp"
#include "python/bindings/typed.hpp"
#include "python/bindings/warn_caller.hpp"
#include "python/bindings/work.hpp"
#include <algorithm>
#include <cstdint>
#include <optional>

namespace suffuse::python {
namespace {

using Rule = Typed<"str | Callable[[Probe], ArrayLike]">;

py::dict ledger_of(const std::vector<erosion::LedgerRow>& ledger) {
    const auto column = [&](auto read) {
        using Value = decltype(read(ledger.front()));
        py::array_t<Value> values(static_cast<py::ssize_t>(ledger.size()));
        std::transform(ledger.begin(), ledger.end(), values.mutable_data(), read);
        return values;
    };
    py::dict dict;
    dict["pass"] = column([](const erosion::LedgerRow& row) { return row.pass; });
    dict["id"] = column([](const erosion::LedgerRow& row) { return row.grain; });
    dict["diameter"] = column([](const erosion::LedgerRow& row) { return row.diameter; });
    dict["mass"] = column([](const erosion::LedgerRow& row) { return row.mass; });
    dict["coordination"] = column([](const erosion::LedgerRow& row) { return row.coordination; });
    return dict;
}

/// Within a call that steps: the world may be looked at meanwhile.
std::optional<erosion::OwnRule> rule_of(const Rule& rule, Stepping& call, erosion::DetachSpec& spec) {
    if (py::isinstance<py::str>(rule)) {
        spec.by = word_of(rule.cast<std::string>(), casefile::names::detach_by, "rule");
        return std::nullopt;
    }
    return own_rule_of(rule, [&call](const std::function<void()>& work) {
        Working::call([&] {
            const Stepping::Pause pause(call);
            work();
        });
    });
}

py::dict erode(
    WorldHandle& w, const Quantity& gradient, const Rule& rule, int passes, const Direction& direction,
    const std::string& size, std::int64_t ramp, std::int64_t watch, double probe_unbalanced_force,
    const Quantity& max_strain, const flow::Fluid& fluid, const std::string& solver, const dem::BalanceSpec& balance,
    const Quantity& damping, const CallableOrNone& on_progress
) {
    const auto key = [](const char* name) -> const casefile::Key& { return key_of("stage.erode", name); };
    erosion::ErodeSpec spec;
    spec.gradient = value_of(key("gradient"), gradient, "gradient");
    spec.passes = static_cast<int>(count_of(key("passes"), passes, "passes"));
    spec.direction = direction_of(direction);
    spec.passes_constriction = word_of(size, casefile::names::constriction_size, "size");
    spec.probe.ramp = count_of(key("ramp"), ramp, "ramp");
    spec.probe.watch = count_of(key("watch"), watch, "watch");
    spec.probe.unbalanced_force =
        value_of(key("probe_unbalanced_force"), py::float_(probe_unbalanced_force), "probe_unbalanced_force");
    spec.probe.flow.solver = word_of(solver, casefile::names::solver, "solver");
    spec.resettle.max_strain = value_of(key("max_strain"), max_strain, "max_strain");
    erosion::Surroundings around;
    around.fluid = fluid;
    around.balance = balance;
    around.damping = value_of(key_of("contact", "damping"), damping, "damping");
    Stepping call(w);
    if (std::ranges::count(call.world().grains.fine, std::uint8_t{1}) == 0) {
        throw StateError("erode: no grain is fine, so that none could leave; mark them, as in world.grains.fine[:] = "
                         "2 * world.grains.radius < 0.26e-3");
    }
    const std::optional<erosion::OwnRule> own = rule_of(rule, call, spec.detached);
    around.rule = own ? &*own : nullptr;
    Attention attention(on_progress, call);
    around.pulse = [&](std::string_view part, long long steps) { attention.beat(part, steps); };
    erosion::ErosionResult result;
    dem::World next = begin_copy(call);
    {
        const Working working;
        result = erosion::begin_erosion(next);
        erosion::PassUnderWay now;
        for (bool goes_on = true; goes_on && std::ssize(result.passes) < passes;) {
            goes_on = erosion::erode_once(next, spec, around, result, now);
            const Holding interpreter; // arrays that were taken meanwhile keep their rows
            call.world_for_new_rows() = next;
        }
    }
    const auto hits = std::ranges::find_if(result.passes, [](const erosion::PassResult& pass) {
        return !run::describe_hits(pass.probe).empty();
    });
    if (hits != result.passes.end()) {
        warn_caller(run::describe_hits(hits->probe));
    }
    nlohmann::json by_pass = nlohmann::json::array();
    for (const erosion::PassResult& pass : result.passes) {
        by_pass.push_back(run::pass_numbers(pass));
    }
    py::dict dict;
    dict["passes"] = to_python(by_pass);
    dict["removed"] = ledger_of(result.ledger);
    dict["rule"] = own ? py::cast(own->name) : py::object(rule);
    return dict;
}

} // namespace

void bind_erosion(py::module_& m) {
    const erosion::ErodeSpec usual;
    auto type = py::reinterpret_borrow<py::class_<WorldHandle, Handle>>(m.attr("World"));
    type.def(
        "erode", &erode, py::arg("gradient") = usual.gradient, py::kw_only(), py::arg("rule") = "velocity",
        py::arg("passes") = 1, py::arg("direction") = "z", py::arg("size") = "mean", py::arg("ramp") = usual.probe.ramp,
        py::arg("watch") = usual.probe.watch, py::arg("probe_unbalanced_force") = usual.probe.unbalanced_force,
        py::arg("max_strain") = usual.resettle.max_strain, py::arg_v("fluid", flow::Fluid{}, "Fluid()"),
        py::arg("solver") = "network", py::arg_v("balance", dem::BalanceSpec{}, "Balance()"),
        py::arg("damping") = dem::usual_damping, py::arg("on_progress") = py::none(),
        with_keys(
            "Passes of the erosion procedure on a world at rest, as a stage that does \"erode\": flow, probe and twin, "
            "constrictions, extraction, new equilibrium. Fines have no weight. Returns a dictionary: `passes`, of the "
            "keys in stage.json; `removed`, arrays `pass`, `id`, `diameter` [m], `mass` [kg], `coordination` of the "
            "grains that left; `rule`, by its name. A pass that is interrupted leaves the world as it was before it.\n"
            "rule: \"velocity\" or \"displacement\"; or a function of your own from what the probe measured, a Probe, "
            "to a truth value for each of its fines: which are detachable\n"
            "size: which constriction a detachable grain must pass to leave, as in `passes_constriction`\n"
            "on_progress: called as on_progress(part, steps) ten times a second at most; what it raises ends the work",
            {{"stage.erode", "gradient"},
             {"stage.erode", "passes"},
             {"stage.erode", "direction"},
             {"stage.erode", "ramp"},
             {"stage.erode", "watch"},
             {"stage.erode", "probe_unbalanced_force"},
             {"stage.erode", "max_strain"},
             {"stage.flow", "solver"}}
        ).c_str()
    );
}

} // namespace suffuse::python
