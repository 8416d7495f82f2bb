#include "suffuse/erosion/loop.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/stopwatch.hpp"
#include "suffuse/dem/carried_stress.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/lent_inertia.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/dem/relax.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/erosion/detachment.hpp"
#include "suffuse/erosion/extraction.hpp"
#include "suffuse/erosion/passage.hpp"
#include "suffuse/erosion/probe.hpp"
#include "suffuse/erosion/reequilibrate.hpp"
#include "suffuse/erosion/transport.hpp"
#include "suffuse/erosion/weighed_probe.hpp"
#include "suffuse/flow/pore_velocity.hpp"
#include "suffuse/flow/reynolds.hpp"
#include "suffuse/flow/throat_flux.hpp"
#include "suffuse/grains/gradation.hpp"
#include "suffuse/stokes/water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

namespace suffuse::erosion {
namespace {

using At = PassUnderWay::At;

/// Step 2: the permeability, how fast the water is and how its ways wind, the throats' fluxes, and the fluid's forces
/// on the grains at each gradient. The pore network, larger than the world, is gone when this returns. Where the flow
/// is resolved on a grid, permeability and forces are of that.
struct Seeping {
    double permeability = 0; ///< [m2]
    flow::FlowSource source;
    double reynolds = 0;            ///< at a hydraulic gradient of 1 [-]
    double tortuosity = 0;          ///< [-]
    flow::ClosedVoids closed_voids; ///< of grains by id
    flow::ThroatFlux throat_flux;
    std::vector<ProbeLoad> loads;
};

Seeping seep(
    const dem::World& world, std::span<const double> gradients, const Vec3& direction, const ProbeSpec& spec,
    const Surroundings& around
) {
    const grains::Grains& grains = world.grains;
    flow::SolverChoice how = spec.flow;
    if (flow::resolves(how)) {
        how.solver = flow::Solver::Resolved; // one flow gives the forces
    }
    const stokes::Water water = stokes::solve_water(
        world.cell, grains.position, grains.radius, grains.fine, {1, direction}, around.fluid, how, around.pulse
    );
    const flow::Seepage& network = water.network;
    const double size = flow::sauter_diameter(grains.radius);
    const std::vector<Vec3> velocity =
        flow::pore_velocities(network.network, grains.position, grains.radius, network.field.flux);
    Seeping seeping{
        .permeability = water.permeability(),
        .source = water.source,
        .reynolds = flow::reynolds_number(water.permeability(), 1, size, around.fluid),
        .tortuosity = flow::tortuosity(network.network, velocity),
        .closed_voids = flow::named_by_id(network.closed_voids, grains.id),
        .throat_flux = flow::describe_fluxes(network.network, network.field.flux, 1),
        .loads = {}};
    for (const double gradient : gradients) {
        seeping.loads.push_back({gradient, water.grain_force()});
        for (Vec3& force : seeping.loads.back().force) {
            force *= gradient;
        }
    }
    return seeping;
}

/// Step 1: the equilibrium relaxed so far that its unbalance does not drown the fluid's force. Grains are lent inertia
/// meanwhile: where they rest does not depend on it, how many steps they take does.
void relax_further(PassUnderWay& now, const ProbeSpec& spec, const Surroundings& around) {
    constexpr dem::Lent all{true, true};
    dem::World& world = now.world;
    const double median = grains::median_diameter(world.grains);
    if (now.at == At::Start) {
        dem::lend_inertia(world, median, {}, all);
        now.relaxation_step = dem::stable_time_step(world, {around.damping});
        now.at = At::Relax;
    }
    dem::StepCaches caches;
    dem::relax(
        world, caches, now.relaxation_step, around.damping, spec.unbalanced_force, spec.relax_limit, now.relaxation,
        around.pulse
    );
    dem::lend_inertia(world, median, all, {});
    now.at = At::Probe;
}

/// Step 3 under the flow's forces at each gradient.
std::vector<ProbeResult> probe(
    const dem::World& world, const Seeping& seeping, double dt, const dem::Relaxation& relaxed, const ProbeSpec& spec,
    const DetachSpec& rule, const Surroundings& around
) {
    std::vector<ProbeResult> results =
        watch_fines(world, seeping.loads, {spec, around.fluid, dt, around.damping}, around.pulse);
    for (ProbeResult& result : results) {
        result.flow = seeping.source;
        result.unbalanced_force = relaxed.unbalanced_force;
        result.relax_steps = relaxed.steps;
        result.reached_floor = relaxed.reached_floor;
        judge_detachment(rule, result);
    }
    return results;
}

/// Step 3 where fines have weight.
void weigh(
    const dem::World& world, const ErodeSpec& spec, const Seeping& seeping, const Surroundings& around, PassResult& pass
) {
    pass.mobility = weigh_fines(
        world,
        {.gradients = gradients_up_to(spec.gradient),
         .direction = spec.direction,
         .specified_gradient = spec.gradient,
         .probe = spec.probe},
        around
    );
    pass.probe.gradient = spec.gradient;
    pass.probe.flow = seeping.source;
    pass.probe.time_step = pass.mobility->time_step;
}

/// The verdict on each fine grain of the rule that counts.
std::vector<std::uint8_t>
judge(const dem::World& world, const ErodeSpec& spec, const ProbeResult& probe, const OwnRule* own) {
    if (own == nullptr) {
        return verdicts(spec.detached, probe);
    }
    std::vector<std::uint8_t> detached = own->judge(world, probe);
    expects(detached.size() == probe.id.size(), "a rule judges each fine grain of the probe");
    return detached;
}

/// The fines that the probe moved, or those that are taken out by force.
std::vector<std::uint32_t> find_detachable(
    const dem::World& world, const ErodeSpec& spec, const PassResult& pass, const std::vector<int>& contacts,
    const OwnRule* own
) {
    if (pass.mobility) {
        return mobile_rows(world, *pass.mobility);
    }
    const std::vector<std::uint8_t> detached =
        spec.forced ? std::vector<std::uint8_t>{} : judge(world, spec, pass.probe, own);
    std::vector<std::uint32_t> rows;
    for (std::uint32_t g = 0, fine = 0; g < world.grains.size(); ++g) {
        if (world.grains.fine[g] == 0) {
            continue;
        }
        if (spec.forced ? contacts[g] <= spec.forced->max_contacts : detached[fine] != 0) {
            rows.push_back(g);
        }
        ++fine;
    }
    return rows;
}

/// Step 5: of the detachable fines those that leave. Those that travel and are held lodge where they are held.
std::vector<std::uint32_t> let_through(
    dem::World& world, const std::vector<int>& contacts, const CoarseSkeleton& skeleton, const ErodeSpec& spec,
    const Surroundings& around, const ErosionResult& so_far, PassResult& pass
) {
    std::vector<std::uint32_t> rows = find_detachable(world, spec, pass, contacts, around.rule);
    pass.detachable = std::ssize(rows);
    if (travels(spec)) {
        rows = transport_fines(world, rows, spec, around.fluid, so_far, pass);
    } else if (!spec.forced) {
        std::erase_if(rows, [&](std::uint32_t g) {
            return !passes(skeleton, spec.passes_constriction, g, 2 * world.grains.radius[g]);
        });
    }
    pass.held_back = pass.detachable - std::ssize(rows);
    return rows;
}

Reason reason_of(const ErodeSpec& spec, const OwnRule* own) {
    if (own != nullptr) {
        return Reason::OwnRule;
    }
    if (spec.forced) {
        return Reason::Forced;
    }
    if (spec.probe.gravity) {
        return Reason::Mobile;
    }
    return spec.detached.by == DetachBy::Velocity ? Reason::Velocity : Reason::Displacement;
}

/// Whether this pass is the last, and why.
void judge_end(
    const dem::World& world, const ErodeSpec& spec, const OwnRule* own, const ErosionResult& so_far, PassResult& pass
) {
    const std::optional<ErodedTarget>& target = spec.until_eroded;
    const double share = target ? eroded_share(world, so_far.initial_mass, target->of) : 0;
    pass.reached_target = target && share >= target->share;
    const std::optional<SkeletonDoubt> doubt = doubt_skeleton(world);
    if (pass.failed) {
        return; // its verdict stands
    }
    if (!spec.forced && own == nullptr && noise_decides(spec.detached, pass.probe)) {
        pass.verdict = {NoiseDecides{}};
    } else if (pass.reached_target) {
        pass.verdict = {TargetReached{share, target->share, target->of, doubt}};
    } else if (is_exhausted(spec, so_far, pass)) {
        pass.verdict = {NothingLeaves{}};
    } else if (doubt) {
        pass.verdict = {*doubt};
    }
}

/// Steps 2 to 5: from the relaxed equilibrium to the world without the grains that leave.
void probe_and_extract(
    PassUnderWay& now, const ErodeSpec& spec, const Surroundings& around, const ErosionResult& result
) {
    dem::World& world = now.world;
    PassResult& pass = now.pass;
    Stopwatch watch;

    // 2 flow
    const Seeping seeping = seep(world, {&spec.gradient, 1}, spec.direction, spec.probe, around);
    pass.permeability_before = seeping.permeability;
    pass.reynolds_before = std::abs(spec.gradient) * seeping.reynolds;
    pass.tortuosity_before = seeping.tortuosity;
    pass.throat_flux_before = seeping.throat_flux;
    pass.wall_seconds["flow"] = watch.lap();

    // 3 probe
    if (spec.probe.gravity && !spec.forced) {
        weigh(world, spec, seeping, around, pass);
    } else {
        const double dt = dem::stable_time_step(world, {around.damping});
        pass.probe = probe(world, seeping, dt, now.relaxation, spec.probe, spec.detached, around).front();
    }
    pass.wall_seconds["probe"] = watch.lap();

    // 4 constrictions
    const bool with_paths = spec.passes_constriction == ConstrictionSize::WidestPath;
    const CoarseSkeleton skeleton = measure_coarse_skeleton(world, spec.direction, with_paths, spec.merge);
    pass.constrictions = skeleton.constrictions;
    pass.merge = spec.merge;
    pass.constrictions_by_merge = skeleton.by_merge;
    if (pass.mobility) {
        mark_leaving(world, skeleton, spec.passes_constriction, *pass.mobility);
    }
    pass.wall_seconds["constrictions"] = watch.lap();

    // 5 extraction
    const std::vector<int> contacts = dem::coordination(world); // before grains that lodge leave theirs
    const std::vector<std::uint32_t> leaving = let_through(world, contacts, skeleton, spec, around, result, pass);
    now.ledger = extract(world, leaving, contacts, reason_of(spec, around.rule), result, pass);
    pass.wall_seconds["extraction"] = watch.lap();
}

} // namespace

void check_own_rule(const ErodeSpec& spec, const OwnRule& rule) {
    if (spec.forced || spec.probe.gravity) {
        throw UsageError(fmt::format(
            "the rule {} judges what a probe without weight measures, and here {}; leave out the rule, or {}",
            rule.name, spec.forced ? "`forced` takes fines out without one" : "[gravity] gives the fines weight",
            spec.forced ? "`forced`" : "[gravity]"
        ));
    }
}

ErosionResult begin_erosion(const dem::World& world) {
    dem::require_pressure(world, dem::mean_stress_tensor(world), "an erosion needs a skeleton");
    ErosionResult result;
    result.initial_mass = total_mass(world.grains);
    return result;
}

bool erode_once(
    dem::World& world, const ErodeSpec& every, const Surroundings& around, ErosionResult& result, PassUnderWay& now
) {
    if (std::ranges::count(world.grains.fine, std::uint8_t{0}) == 0) {
        throw NoSkeleton("all grains are fines, so there is no skeleton");
    }
    const auto number = static_cast<int>(result.passes.size()) + 1;
    const ErodeSpec spec = at_pass(every, number);
    if (around.rule != nullptr) {
        check_own_rule(spec, *around.rule);
    }
    Stopwatch watch;
    dem::World& next = now.world; // the caller's world changes only when the pass is complete
    PassResult& pass = now.pass;
    if (now.at == At::Start) {
        next = world;
        dem::sort_along_curve(next);
        pass.pass = number;
        describe_before(next, pass);
    }
    // 1 equilibrium; fines that have weight come to rest under it
    if (now.at == At::Start || now.at == At::Relax) {
        if (spec.probe.gravity && !spec.forced) {
            now.at = At::Probe;
        } else {
            relax_further(now, spec.probe, around);
        }
        pass.wall_seconds["relax"] = watch.lap();
    }
    // 2 to 5
    if (now.at == At::Probe) {
        probe_and_extract(now, spec, around, result);
        watch.lap();
        now.at = At::Settle;
    }
    // 6 new equilibrium
    if (now.at == At::Settle) {
        reequilibrate(next, spec.resettle, result, around, pass, now.resettlement);
        watch.lap();
        now.at = At::Percolate;
    }
    const Seeping after = seep(next, {}, spec.direction, spec.probe, around);
    pass.permeability_after = after.permeability;
    pass.flow_after = after.source;
    pass.reynolds_after = std::abs(spec.gradient) * after.reynolds;
    pass.tortuosity_after = after.tortuosity;
    pass.closed_voids = after.closed_voids;
    pass.throat_flux_after = after.throat_flux;
    pass.wall_seconds["flow"] += watch.lap();

    judge_end(next, spec, around.rule, result, pass);
    world = std::move(next);
    result.ledger = std::move(now.ledger);
    const std::vector<PathRow>& path = now.resettlement.rows;
    result.path.insert(result.path.end(), path.begin(), path.end());
    result.passes.push_back(std::move(pass));
    now = {};
    return !result.passes.back().verdict;
}

bool is_exhausted(const ErodeSpec& spec, const ErosionResult& so_far, const PassResult& pass) {
    constexpr std::ptrdiff_t passes_in_a_row = 3;
    if (changes_after(spec, pass.pass)) {
        return false;
    }
    if (pass.removed > 0 || !travels(spec) || pass.detachable == 0) {
        return pass.removed == 0;
    }
    const std::vector<PassResult>& before = so_far.passes;
    return std::ssize(before) + 1 >= passes_in_a_row &&
           std::all_of(before.end() - (passes_in_a_row - 1), before.end(), [](const PassResult& each) {
               return each.removed == 0;
           });
}

double eroded_share(const dem::World& world, double initial_mass, ErodedTarget::Of of) {
    const double left = total_mass(world.grains), gone = std::max(0.0, initial_mass - left); // all of it fines
    const double of_mass = of == ErodedTarget::Of::Solids ? initial_mass : gone + fines_content(world.grains) * left;
    return gone > 0 ? gone / of_mass : 0;
}

std::vector<ProbeResult>
probe_gradients(const dem::World& world, const DetachStageSpec& spec, const Surroundings& around) {
    PassUnderWay relaxed;
    relaxed.world = world;
    dem::sort_along_curve(relaxed.world);
    relax_further(relaxed, spec.probe, around);
    const double dt = dem::stable_time_step(relaxed.world, {around.damping});
    const Seeping seeping = seep(relaxed.world, spec.gradients, spec.direction, spec.probe, around);
    return probe(relaxed.world, seeping, dt, relaxed.relaxation, spec.probe, spec.detached, around);
}

} // namespace suffuse::erosion
