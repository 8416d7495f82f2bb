#include "suffuse/plan/bench_step.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/resident.hpp"
#include "suffuse/base/stopwatch.hpp"
#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/record/result_json.hpp"

#include <fmt/format.h>

namespace suffuse::plan {
namespace {

void describe_end(const dem::World& world, const Mat3& stress, BenchStepResult& result) {
    const dem::Equilibrium end = dem::measure_equilibrium(world);
    const auto grains = static_cast<double>(result.grains), contacts = static_cast<double>(end.contacts);
    result.contacts = end.contacts;
    result.steps_per_second = static_cast<double>(result.steps) / result.seconds;
    result.particle_steps_per_second = result.steps_per_second * grains;
    result.contact_steps_per_second = result.steps_per_second * contacts;
    result.ns_per_contact = 1e9 / result.contact_steps_per_second;
    result.candidates_per_contact = static_cast<double>(world.contacts.size()) / contacts;
    result.state_hash = dem::state_hash(world);
    result.void_ratio = dem::void_ratio(world);
    result.coordination = 2 * contacts / grains;
    result.stress = stress;
    result.mean_stress = dem::mean_stress(stress);
    result.unbalanced_force = end.unbalanced_force;
    result.unbalanced_force_yade = end.unbalanced_force_all;
    result.max_overlap_ratio = end.max_overlap_ratio;
}

} // namespace

BenchStepResult bench_step(const BenchStepSpec& spec) {
    expects(spec.steps > 0, "a benchmark needs steps");
    const std::int64_t bytes_before = resident_bytes();
    auto [world, caches, plan, settle_steps, settle_seconds] = settle_for_shear(spec.packing, spec.shear);
    BenchStepResult result;
    result.mode = spec.shear.mode;
    result.threads = thread_count();
    result.grains = static_cast<std::int64_t>(world.grains.size());
    result.steps = spec.steps;
    result.settle_steps = settle_steps;
    result.settle_seconds = settle_seconds;
    result.contacts_before = dem::measure_equilibrium(world).contacts;

    const std::int64_t searches = caches.neighborhood.searches(), tables = caches.neighborhood.prunings();
    forget_peak();
    const Stopwatch watch;
    const Mat3 stress = dem::advance(world, caches, plan, spec.steps).stress;
    result.seconds = watch.seconds();
    result.rebuilds = caches.neighborhood.searches() - searches;
    result.contact_tables = caches.neighborhood.prunings() - tables;
    const auto per_grain = [&](std::int64_t bytes) {
        return static_cast<double>(bytes - bytes_before) / static_cast<double>(result.grains);
    };
    result.bytes_per_grain = per_grain(resident_bytes());
    result.peak_bytes_per_grain = per_grain(peak_resident_bytes());
    describe_end(world, stress, result);
    return result;
}

void to_json(nlohmann::json& json, const BenchStepResult& r) {
    json = {
        {"mode", dem::name_of(r.mode)},
        {"threads", r.threads},
        {"grains", r.grains},
        {"contacts_before", r.contacts_before},
        {"contacts", r.contacts},
        {"steps", r.steps},
        {"seconds", r.seconds},
        {"steps_per_second", r.steps_per_second},
        {"particle_steps_per_second", r.particle_steps_per_second},
        {"contact_steps_per_second", r.contact_steps_per_second},
        {"ns_per_contact", r.ns_per_contact},
        {"rebuilds", r.rebuilds},
        {"contact_tables", r.contact_tables},
        {"candidates_per_contact", r.candidates_per_contact},
        {"state_hash", fmt::format("{:016x}", r.state_hash)},
        {"void_ratio", r.void_ratio},
        {"coordination", r.coordination},
        {"stress", r.stress},
        {"mean_stress", r.mean_stress},
        {"unbalanced_force", r.unbalanced_force},
        {"unbalanced_force_yade", r.unbalanced_force_yade},
        {"max_overlap_ratio", r.max_overlap_ratio},
        {"bytes_per_grain", r.bytes_per_grain},
        {"peak_bytes_per_grain", r.peak_bytes_per_grain},
        {"settle_steps", r.settle_steps},
        {"settle_seconds", r.settle_seconds},
    };
}

} // namespace suffuse::plan
