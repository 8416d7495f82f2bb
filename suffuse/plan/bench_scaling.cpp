#include "suffuse/plan/bench_scaling.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/loop_meter.hpp"
#include "suffuse/flow/seepage.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::plan {
namespace {

using Phases = std::vector<LoopMeter::Phase>;

/// With their sum as the last.
Phases summed(Phases phases) {
    LoopMeter::Phase all{"all", 0, 0, 0, 0};
    for (const LoopMeter::Phase& phase : phases) {
        all.serial += phase.serial;
        all.parallel += phase.parallel;
        all.shared += phase.shared;
        all.loops += phase.loops;
    }
    phases.push_back(all);
    return phases;
}

/// Work measured as for one thread, and as for each number of them: it may be cut otherwise then.
template <class Work>
ScalingWork measure(const std::vector<int>& threads, Work&& work) {
    const auto phases_for = [&](int count) {
        LoopMeter meter(count);
        work();
        return summed(meter.phases());
    };
    ScalingWork result;
    for (const LoopMeter::Phase& phase : phases_for(1)) {
        const double seconds = phase.serial + phase.parallel;
        result.phases.push_back({phase.name, seconds, seconds > 0 ? phase.serial / seconds : 0, phase.loops, {}});
    }
    for (const int count : threads) {
        for (const LoopMeter::Phase& phase : phases_for(count)) {
            for (ScalingPhase& alone : result.phases) {
                if (alone.name == phase.name) {
                    alone.speed_up[count] = alone.seconds / std::max(phase.serial + phase.shared, 1e-12);
                }
            }
        }
    }
    result.all = result.phases.back();
    result.phases.pop_back();
    return result;
}

ScalingWork measure_steps(BenchShear& shear, const BenchScalingSpec& spec) {
    return measure(spec.threads, [&] {
        const MeteredPhase phase("step");
        dem::advance(shear.world, shear.caches, shear.plan, spec.steps);
    });
}

ScalingWork measure_flow(const dem::World& world, const BenchScalingSpec& spec) {
    return measure(spec.threads, [&] {
        flow::solve_seepage(world.cell, world.grains.position, world.grains.radius, {.gradient = 1}, {});
    });
}

nlohmann::json json_of(const ScalingPhase& phase) {
    nlohmann::json speed_up = nlohmann::json::object();
    for (const auto& [threads, factor] : phase.speed_up) {
        speed_up[fmt::format("{}", threads)] = factor;
    }
    return {
        {"seconds", phase.seconds},
        {"serial_share", phase.serial_share},
        {"loops", phase.loops},
        {"speed_up", speed_up}};
}

nlohmann::json json_of(const ScalingWork& work) {
    nlohmann::json json = nlohmann::json::object();
    for (const ScalingPhase& phase : work.phases) {
        json[phase.name] = json_of(phase);
    }
    json[work.all.name] = json_of(work.all);
    return json;
}

} // namespace

BenchScalingResult bench_scaling(const BenchScalingSpec& spec) {
    expects(spec.steps > 0, "a benchmark needs steps");
    BenchShear shear = settle_for_shear(spec.packing, spec.shear);
    BenchScalingResult result;
    result.grains = static_cast<std::int64_t>(shear.world.grains.size());
    result.steps = spec.steps;
    result.step = measure_steps(shear, spec);
    result.flow = measure_flow(shear.world, spec);
    return result;
}

void to_json(nlohmann::json& json, const BenchScalingResult& result) {
    json = {
        {"grains", result.grains},
        {"steps", result.steps},
        {"step", json_of(result.step)},
        {"flow", json_of(result.flow)}};
}

} // namespace suffuse::plan
