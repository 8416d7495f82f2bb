#include "suffuse/plan/bench_flow.hpp"

#include "suffuse/base/parallel.hpp"
#include "suffuse/base/resident.hpp"
#include "suffuse/base/stopwatch.hpp"
#include "suffuse/flow/seepage.hpp"
#include "suffuse/record/result_json.hpp"

namespace suffuse::plan {

BenchFlowResult bench_flow(const BenchFlowSpec& spec) {
    const dem::World world = load_bench_packing(spec.packing);
    trim_heap(); // what making the packing left free would hide a part of what the flow takes
    const std::int64_t bytes_before = resident_bytes();
    forget_peak();
    const Stopwatch watch;
    const flow::Seepage seepage = flow::solve_seepage(
        world.cell, world.grains.position, world.grains.radius, {spec.gradient, spec.direction},
        {.conductance = spec.conductance}
    );
    BenchFlowResult result;
    result.total = watch.seconds();
    result.threads = thread_count();
    result.grains = world.grains.size();
    result.pores = seepage.network.pores.size();
    result.throats = seepage.network.throats.size();
    result.triangulate = seepage.seconds.triangulate;
    result.conductance = seepage.seconds.conductance;
    result.set_up = seepage.seconds.set_up;
    result.solve = seepage.seconds.solve;
    result.iterations = seepage.field.iterations;
    result.forces = seepage.seconds.forces;
    result.peak_bytes_per_grain =
        static_cast<double>(peak_resident_bytes() - bytes_before) / static_cast<double>(result.grains);
    result.permeability = seepage.permeability;
    result.mean_velocity = seepage.mean_velocity;
    result.residual = seepage.field.residual;
    result.force_sum_error = seepage.force_sum_error;
    return result;
}

void to_json(nlohmann::json& json, const BenchFlowResult& r) {
    const nlohmann::json seconds = {{"triangulate", r.triangulate}, {"conductance", r.conductance},
                                    {"set_up", r.set_up},           {"solve", r.solve},
                                    {"forces", r.forces},           {"total", r.total}};
    json = {
        {"threads", r.threads},
        {"grains", r.grains},
        {"pores", r.pores},
        {"throats", r.throats},
        {"seconds", seconds},
        {"peak_bytes_per_grain", r.peak_bytes_per_grain},
        {"permeability", r.permeability},
        {"mean_velocity", r.mean_velocity},
        {"iterations", r.iterations},
        {"residual", r.residual},
        {"force_sum_error", r.force_sum_error},
    };
}

} // namespace suffuse::plan
