// bench: the speed on a packing brought from elsewhere.

#include "suffuse/base/spelling.hpp"
#include "suffuse/plan/bench_flow.hpp"
#include "suffuse/plan/bench_step.hpp"

#include <fmt/format.h>

#include "apps/exit_code.hpp"
#include "apps/verbs.hpp"

namespace suffuse::apps {
namespace {

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

} // namespace

int bench_verb(const CommandLine& line, const Console& console) {
    const plan::BenchPacking packing{line.packing, line.cell.empty() ? Mat3{} : cell_of(line.cell), line.replicate};
    nlohmann::json result;
    set_threads(line.threads);
    if (line.bench == "step") {
        plan::BenchStepSpec spec;
        spec.packing = packing;
        spec.steps = line.steps;
        spec.mode = line.mode == dem::name_of(dem::Mode::Fast) ? dem::Mode::Fast : dem::Mode::Reference;
        if (!line.time_step.empty()) {
            spec.time_step = quantity_of(line.time_step, dimension::time, "--time-step", true);
        }
        if (!(spec.time_step > 0)) {
            throw UsageError(fmt::format("--time-step {} is no time", shown(line.time_step)));
        }
        result = plan::bench_step(spec);
    } else {
        plan::BenchFlowSpec spec;
        spec.packing = packing;
        spec.gradient = line.gradient;
        result = plan::bench_flow(spec);
    }
    console.result(lines_of(result));
    console.document(json_text(result));
    return Done;
}

} // namespace suffuse::apps
