// bench: the speed on a packing made on the spot, or brought from elsewhere.

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/base/units.hpp"
#include "suffuse/plan/bench_flow.hpp"
#include "suffuse/plan/bench_scaling.hpp"
#include "suffuse/plan/bench_step.hpp"

#include <fmt/format.h>

#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/shared_options.hpp"
#include "apps/typed_value.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <cstdint>
#include <memory>

namespace suffuse::apps {
namespace {

struct BenchVerb final : Verb {
    BenchVerb() : Verb("bench", "measure the speed of a step and of a flow, and how they scale", "") {}

    std::string what; ///< "step", "flow" or "scaling"
    std::string packing;
    CellOption cell;
    ThreadOption threads;
    int replicate = 1;
    std::int64_t steps = 2000, scaling_steps = 500;
    std::string time_step;
    std::string mode = "reference";
    double gradient = 0.05;
    std::string conductance = "bounded";

    void add_to(Options& options) override {
        Options step =
            options.below("step", "settle a packing at 100 kPa, then time slow shear", "suffuse bench step --json");
        step.value("--steps", steps, "steps that are timed, 2000 unless given")
            .type("N")
            .whole_number(1, 1'000'000'000);
        step.value("--time-step", time_step, "in seconds; 4.1e-8 unless given").type("DT");
        step.value("--mode", mode, "of the timed steps: reference or fast; reference unless given")
            .type("NAME")
            .one_of({"reference", "fast"});
        add_common_to(step);
        Options scaling = options.below(
            "scaling", "on one thread, the share of a step and of a flow that more threads would not make faster",
            "suffuse bench scaling --replicate 3 --json"
        );
        scaling.value("--steps", scaling_steps, "steps that are measured, 500 unless given")
            .type("N")
            .whole_number(1, 1'000'000'000);
        add_common_to(scaling);
        Options flow = options.below(
            "flow", "time each part of a flow solution",
            "suffuse bench flow --packing packing.csv --cell 3.895e-3,3.894e-3,3.895e-3"
        );
        flow.value("--gradient", gradient, "hydraulic gradient along x, 0.05 unless given").type("I");
        flow.value("--conductance", conductance, "law of the throats: bounded or yade; bounded unless given")
            .type("NAME")
            .one_of({"bounded", "yade"});
        add_common_to(flow);
    }

    void add_common_to(Options& options) {
        options.value("--packing", packing, "your own packing; by default 10,000 grains of a sand are generated")
            .type("FILE");
        cell.add_to(options);
        threads.add_to(options);
        options.value("--replicate", replicate, "copies of the packing along each axis").type("N").whole_number(1, 30);
        options.keep_choice(what);
    }

    void check() const override {
        if (what.empty()) {
            throw UsageError("bench what? suffuse bench step, bench flow or bench scaling; see suffuse bench --help");
        }
        if (packing.empty() && cell.matrix()) {
            throw UsageError("--cell is that of a --packing; the packing that is made has its own");
        }
    }

    [[nodiscard]] int act(const CommandLine&, const Console& console) const override;
};

/// One `name value` a line, tables within joined by a dot.
std::string lines_of(const nlohmann::json& json, const std::string& prefix = "") {
    std::string text;
    for (const auto& [key, value] : json.items()) {
        if (value.is_object()) {
            text += lines_of(value, prefix + key + ".");
        } else {
            text +=
                fmt::format("{:28} {}\n", prefix + key, value.is_string() ? value.get<std::string>() : value.dump());
        }
    }
    return text;
}

/// What the numbers come to.
std::string sentence_of(const std::string& what, const nlohmann::json& r) {
    const std::string grains = count_text(r.at("grains"));
    if (what == "step") {
        return fmt::format(
            "{} grains on {}: {:.0f} steps a second, {:.2g} grain-steps a second, {:.1f} ns a contact and step", grains,
            plural(r.at("threads"), "thread"), r.at("steps_per_second").get<double>(),
            r.at("particle_steps_per_second").get<double>(), r.at("ns_per_contact").get<double>()
        );
    }
    if (what == "flow") {
        const nlohmann::json& seconds = r.at("seconds");
        return fmt::format(
            "{} grains on {}: a flow in {:.3g} s, of which {:.3g} s make the pores and {:.3g} s solve for their "
            "pressures; the permeability is {:.4g} m2",
            grains, plural(r.at("threads"), "thread"), seconds.at("total").get<double>(),
            seconds.at("triangulate").get<double>(), seconds.at("solve").get<double>(),
            r.at("permeability").get<double>()
        );
    }
    const auto serial = [&](const char* part) { return 100 * r.at(part).at("all").at("serial_share").get<double>(); };
    return fmt::format(
        "{} grains: {:.2g} % of a step and {:.2g} % of a flow solution would stay on one thread, however many there "
        "are",
        grains, serial("step"), serial("flow")
    );
}

int BenchVerb::act(const CommandLine&, const Console& console) const {
    const plan::BenchPacking grains{packing, cell.matrix().value_or(Mat3{}), replicate};
    nlohmann::json result;
    threads.apply();
    if (what == "step") {
        plan::BenchStepSpec spec;
        spec.packing = grains;
        spec.steps = steps;
        spec.shear.mode = mode == dem::name_of(dem::Mode::Fast) ? dem::Mode::Fast : dem::Mode::Reference;
        if (!time_step.empty()) {
            spec.shear.time_step = quantity_of(time_step, dimension::time, "--time-step", true);
        }
        if (!(spec.shear.time_step > 0)) {
            throw UsageError(fmt::format("--time-step {} is no time", shown(time_step)));
        }
        result = plan::bench_step(spec);
    } else if (what == "scaling") {
        result = plan::bench_scaling({.packing = grains, .steps = scaling_steps});
    } else {
        plan::BenchFlowSpec spec;
        spec.packing = grains;
        spec.gradient = gradient;
        spec.conductance = conductance == "yade" ? flow::Conductance::Yade : flow::Conductance::Bounded;
        result = plan::bench_flow(spec);
    }
    console.result(lines_of(result) + "\n" + sentence_of(what, result) + "\n");
    console.document(json_text(result));
    return Done;
}

} // namespace

MadeVerb make_bench_verb() {
    return std::make_unique<BenchVerb>();
}

} // namespace suffuse::apps
