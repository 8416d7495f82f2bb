#include "suffuse/plan/price_stage.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/casefile/stage_traits.hpp"
#include "suffuse/dem/inertial_number.hpp"
#include "suffuse/erosion/ramp.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/packing/stack.hpp"
#include "suffuse/plan/price_preparation.hpp"
#include "suffuse/plan/price_test.hpp"
#include "suffuse/plan/weight_price.hpp"
#include "suffuse/record/read_import.hpp"
#include "suffuse/stokes/grid.hpp"
#include "suffuse/triaxial/run_path.hpp"
#include "suffuse/triaxial/stiffness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

namespace suffuse::plan {
namespace {

// Steps, without the `patience` that is added where a balance is waited for.
constexpr Range settling{250, 6'000}; // a packing from elsewhere
constexpr Range first_relaxation{600, 4'500}, next_relaxation{50, 1'200};
constexpr Range rest_under_load{150, 4'500};      // after the ramp of a stress probe
constexpr Range rest_under_strain{150, 500};      // of a stiffness
constexpr Range rest_after_removal{1'500, 8'000}; // after many grains were taken at once
constexpr Range balance_after_removal{0, 150};
constexpr int endless = 5;                // passes that "until nothing leaves" may add to those specified ...
constexpr int endless_travel = 30;        // ... where fines travel: 19 to 26 seen
constexpr Range slow_collapse{0.55, 1.1}; // of the steps in which the largest rate would close what removal opened
constexpr double swept_rattlers = 0.65;   // of the fines without load, at least this share leaves with an erosion

// What the made-up packing of measure_speed leaves out: recording, files, other work of the machine.
constexpr Range price_error{0.75, 1.35};
constexpr Range cloud_seconds{1e-6, 1e-4}; // a grain; the most of a million, which fit no cache of a processor
constexpr Range layer_seconds{1e-5, 2e-4}; // likewise of layers, pushed apart in steps of porosity
constexpr Range flow_seconds{1e-5, 6e-5};  // a grain, one direction

// Fines that migrate: steps of their rest; of equal ones, while one falls half its diameter; flows in a second.
constexpr Range steps_of_a_fall{400, 3200}, flows_a_second{20, 250};

// Grains that a plan draws of a sample: more of the same curve say no more of their shares.
constexpr std::int64_t most_drawn = 300'000;

constexpr double flow_memory = 5000; // [B], a grain

constexpr Range resolved_seconds{5e-6, 2e-5}; // a box, one direction
constexpr double box_memory = 150;            // [B], one direction
constexpr double kept_memory = 8;             // [B], a box, each further direction: the forces on its held faces

/// Boxes of a grid with so many across the Sauter diameter, over a cell as wide as it is high.
double resolving_boxes(const PricedSample& sample, const grains::Material& material, double across) {
    double inverse_diameter = 0; // of Sauter's
    for (const packing::SizeClass& size : sample.classes) {
        inverse_diameter += size.volume / size.diameter;
    }
    const double solid = (sample.coarse.mass + sample.fines.mass) / material.density;
    const double spacings = std::cbrt(solid / sample.solid_fraction) * across * inverse_diameter;
    return std::pow(static_cast<double>(stokes::boxes_along(spacings)), 3);
}

/// Makes of a sample of some grains of `soil` one of so many. Of two curves the coarse grains may be very few of those
/// drawn: their share follows from the soil.
void scale_up(PricedSample& sample, const grains::Soil& soil, double particles) {
    double coarse = sample.coarse.grains, fines = sample.fines.grains;
    if (soil.coarse && soil.fines && coarse > 0 && fines > 0) {
        coarse = (1 - soil.fines_content) * grains::grains_per_volume(*soil.coarse);
        fines = soil.fines_content * grains::grains_per_volume(*soil.fines);
    }
    const auto make = [&](PricedFraction& fraction, double share) {
        const double more = fraction.grains > 0 ? particles * share / (coarse + fines) / fraction.grains : 1;
        fraction.grains *= more;
        fraction.mass *= more;
    };
    make(sample.coarse, coarse);
    make(sample.fines, fines);
}

/// One stage: what it takes, and what it makes of the sample.
class Pricer {
public:
    Pricer(const casefile::Case& what, const casefile::Variant& variant, PricedSample& sample)
        : case_(what), variant_(variant), sample_(sample) {}

    StagePrice operator()(const casefile::ImportSpec& spec) {
        const record::ImportedSample read = record::read_import(spec, variant_, variant_.folder);
        sample_ = describe(read.grains, variant_.damping);
        take_state(sample_, state_at(sample_, grains::solid_volume(read.grains) / std::abs(determinant(read.h))));
        return {.seconds = {0, 0.1}, .memory_a_grain = grain_memory, .basis = "read from a file"};
    }

    StagePrice operator()(const packing::PackSpec& spec) {
        if (!spec.layers.empty()) {
            return price_layers(spec);
        }
        if (!variant_.soil) {
            throw Bug("a stage that packs without a soil");
        }
        const std::int64_t some = std::min(variant_.particles, most_drawn);
        grains::Soil soil = *variant_.soil;
        if (some < variant_.particles) {
            soil.grading_tolerance = 1; // fewer follow the curve less closely; it is the run that must
        }
        const grains::SampledGrains drawn = grains::sample_soil(soil, static_cast<int>(some));
        grains::Grains grains;
        for (std::size_t g = 0; g < drawn.radius.size(); ++g) {
            add_grain(grains, {}, drawn.radius[g], variant_.material.density);
            grains.fine[g] = drawn.fine[g];
        }
        sample_ = describe(grains, variant_.damping);
        if (some < variant_.particles) {
            scale_up(sample_, soil, static_cast<double>(variant_.particles));
        }
        sample_.solid_fraction = 1 - spec.porosity;
        return {
            .seconds = count(sample_) * cloud_seconds,
            .memory_a_grain = grain_memory,
            .basis = fmt::format(
                "no steps; {:.0f} coarse grains, fines content {:.2f} %", sample_.coarse.grains,
                100 * fines_content(sample_)
            )};
    }

    StagePrice operator()(const packing::CompactSpec& spec) { return price_compaction(case_, variant_, spec, sample_); }

    StagePrice operator()(const triaxial::TriaxialSpec& spec) { return price_test(case_, variant_, spec, sample_); }

    StagePrice operator()(const dem::SettleSpec& spec) {
        for (const cell::AxisControl& axis : spec.loading.axis) {
            if (axis.control == cell::Control::Stress && axis.value > 0) {
                sample_.pressure = axis.value;
            }
        }
        return {.steps = waited(case_, settling), .memory_a_grain = grain_memory, .basis = "until balanced"};
    }

    StagePrice operator()(const dem::AdvanceSpec& spec) {
        const auto steps = static_cast<double>(spec.steps);
        return {.steps = {steps, steps}, .memory_a_grain = grain_memory, .basis = "as specified"};
    }

    StagePrice operator()(const triaxial::StressProbeSpec& spec) {
        const double loads = spec.directions + 1;
        const auto ramp = static_cast<double>(spec.ramp);
        return {
            .reference_steps = first_relaxation + loads * rest_under_load + Range{loads * ramp, loads * ramp},
            .memory_a_grain = 2 * grain_memory,
            .basis = fmt::format("relaxation, {} loads and one without", spec.directions)};
    }

    StagePrice operator()(const triaxial::StiffnessSpec& /*spec*/) {
        const double strains = 2 * triaxial::strain_directions; // half of each, then all of it
        return {
            .reference_steps = first_relaxation + strains * rest_under_strain,
            .memory_a_grain = 2 * grain_memory,
            .basis = fmt::format("relaxation, {} strains", strains)};
    }

    StagePrice operator()(const flow::FlowSpec& spec) {
        StagePrice price{
            .seconds = (spec.tensor ? 2.0 : 1.0) * one_flow(),
            .memory_a_grain = grain_memory + flow_memory,
            .basis = "no steps"};
        add_resolving(price, spec.how, 1, spec.tensor ? 3 : 1);
        return price;
    }

    StagePrice operator()(const erosion::DetachStageSpec& spec) {
        const auto gradients = static_cast<double>(spec.gradients.size());
        if (spec.probe.gravity) {
            const double levels = levels_of_ramp(spec.gradients);
            const Range flows = flows_with_weight(levels, spec.probe.weighed);
            StagePrice price{
                .reference_steps =
                    work_of_free_fines * steps_with_weight(levels, spec.probe.weighed, fines_sift(sample_)),
                .seconds = flows * one_flow(),
                .memory_a_grain = 4 * grain_memory + flow_memory,
                .basis = fmt::format("rest under weight, then {} gradients, and those between that are sought", levels),
                .kind = "under weight"};
            add_resolving(price, spec.probe.flow, flows.most);
            return price;
        }
        StagePrice price{
            .reference_steps = first_relaxation + probe(spec.probe, gradients),
            .seconds = one_flow(),
            .memory_a_grain = 3 * grain_memory + flow_memory,
            .basis = fmt::format("relaxation, {} gradients and a twin", spec.gradients.size())};
        add_resolving(price, spec.probe.flow, 1);
        return price;
    }

    StagePrice operator()(const erosion::ErodeSpec& spec) {
        const bool travels = erosion::travels(spec);
        const int more = spec.until_nothing_leaves ? (travels ? endless_travel : endless) : 0;
        const Range passes{static_cast<double>(spec.passes), static_cast<double>(spec.passes + more)};
        const Range later{passes.least - 1, passes.most - 1};
        const double carrying = sample_.fines.carrying;
        const Range swept{carrying, 1 - swept_rattlers * (1 - carrying)};
        sample_.fines_left = {
            std::min(sample_.fines_left.least, swept.least), std::min(sample_.fines_left.most, swept.most)};
        const bool weighs = spec.probe.gravity && !spec.forced;
        const double ramp = weighs ? levels_of_ramps(spec) : 0;
        const Range flows = weighs ? flows_with_weight(ramp, spec.probe.weighed) : Range{};
        StagePrice price{
            .steps = 2 * passes * waited(case_, balance_after_removal),
            .reference_steps = weighs ? work_of_free_fines *
                                            (passes * steps_with_weight(ramp, spec.probe.weighed, fines_sift(sample_)))
                                      : passes * probe(spec.probe, 1) + first_relaxation + later * next_relaxation,
            .seconds = ((travels ? 3.0 : 2.0) * Range{1, 1} + flows) * passes * one_flow(),
            .memory_a_grain = 4 * grain_memory + flow_memory,
            .basis = fmt::format(
                "{}{}: {}, two new equilibria; more where the skeleton gives way",
                spec.passes == 1 ? "1 pass" : fmt::format("{} passes", spec.passes),
                spec.until_nothing_leaves ? " and more, until nothing leaves" : "",
                weighs ? "rest under weight and a ramp of gradients" : "relaxation, probe with its twin"
            ),
            .kind = weighs ? "under weight" : ""};
        add_resolving(price, spec.probe.flow, (2 + flows.most) * passes.most);
        return price;
    }

    StagePrice operator()(const erosion::RemoveSpec& spec) {
        const double before = 1 - sample_.solid_fraction * (1 - fines_content(sample_));
        const bool empties = spec.grains == erosion::RemovedFines::All && spec.share >= 1;
        if (empties && !(sample_.coarse.grains > 0)) {
            return {.memory_a_grain = 2 * grain_memory, .basis = "refused: all grains are fines, and none would stay"};
        }
        if (empties) {
            take_fines(sample_);
        } else {
            const double chosen = spec.grains == erosion::RemovedFines::All        ? 1
                                  : spec.grains == erosion::RemovedFines::Inactive ? 1 - sample_.fines.carrying
                                                                                   : sample_.fines.carrying;
            const double left = 1 - spec.share * chosen;
            sample_.fines_left = {left * sample_.fines_left.least, left * sample_.fines_left.most};
        }
        const double closing = empties ? std::max(0.0, strain_between(before, 1 - sample_.solid_fraction)) : 0;
        const double rate = dem::rate_of_inertial_number(
            dem::loaded_inertial_number, sample_.median, variant_.material.density, sample_.pressure
        );
        const double a_strain = 1 / (rate * settled_time_step(sample_, variant_.material));
        return {
            .steps = closing * a_strain * slow_collapse +
                     static_cast<double>(spec.passes) * (rest_after_removal + 2 * waited(case_, {})),
            .memory_a_grain = 2 * grain_memory,
            .basis = spec.passes == 1 ? "two new equilibria, after all requested grains have been removed"
                                      : fmt::format("two new equilibria after each of {} passes", spec.passes)};
    }

    StagePrice operator()(const erosion::MigrateSpec& spec) {
        const auto holds = static_cast<double>(spec.gradients.size());
        const double most = std::min(holds * spec.hold_at_most, spec.time_at_most.value_or(1e30));
        const Range time{std::min(2 * holds * spec.still_for, most), most};
        const double excess = std::max(1e-3, 1 - case_.fluid.density / variant_.material.density);
        // The largest decides on the stiffness, and the smallest on the step.
        const double fall = sample_.fines.smallest / std::sqrt(sample_.fines.largest * excess * gravity);
        const double slower = std::sqrt(erosion::MigrateSpec{}.softness / spec.softness);
        const double equilibria = spec.skeleton == erosion::Skeleton::Moves ? 2 * holds : 0;
        const double rests = spec.skeleton == erosion::Skeleton::Moves ? 1 + holds : 1;
        return {
            .steps = equilibria * waited(case_, balance_after_removal),
            .reference_steps = work_of_free_fines *
                               (rests * rest_of_fines(fines_sift(sample_)) + slower / fall * steps_of_a_fall * time),
            .seconds = flows_a_second * time * one_flow(),
            .memory_a_grain = 4 * grain_memory + flow_memory,
            .basis = fmt::format(
                "rest under weight, then {} gradients, each until motion ends{}", holds,
                equilibria > 0 ? ", and the skeleton's new equilibrium after it" : ""
            )};
    }

private:
    /// Of layers, as the run draws them.
    [[nodiscard]] StagePrice price_layers(const packing::PackSpec& spec) {
        grains::Grains grains;
        for (std::size_t k = 0; k < spec.layers.size(); ++k) {
            const packing::Layer& layer = spec.layers[k];
            const packing::LayerSample drawn =
                packing::sample_layer(case_.soils.at(layer.soil), packing::solid_of(layer, spec.width.value_or(0)));
            for (const double radius : drawn.grains.radius) {
                grains.fine[add_grain(grains, {}, radius, variant_.material.density)] = k == 0 ? 1 : 0;
            }
        }
        sample_ = describe(grains, variant_.damping);
        sample_.solid_fraction = 1 - spec.porosity;
        return {
            .seconds = count(sample_) * layer_seconds,
            .memory_a_grain = grain_memory,
            .basis = fmt::format(
                "no steps; {} layers of {:.0f} grains, {:.0f} of them of the base", spec.layers.size(), count(sample_),
                sample_.fines.grains
            )};
    }

    /// Of the ramp of a pass, in the mean.
    [[nodiscard]] static double levels_of_ramps(const erosion::ErodeSpec& spec) {
        const int passes = 1 + static_cast<int>(spec.later_passes.size());
        double levels = 0;
        for (int pass = 1; pass <= passes; ++pass) {
            levels += levels_of_ramp(erosion::gradients_up_to(erosion::at_pass(spec, pass).gradient));
        }
        return levels / passes;
    }

    /// Probes, and the one twin that they share.
    [[nodiscard]] static Range probe(const erosion::ProbeSpec& spec, double probes) {
        const double steps = (probes + 1) * static_cast<double>(spec.ramp + spec.watch);
        return {steps, steps};
    }

    /// Whether `auto` resolves is known when it has the network's answer: up to as many as that.
    /// @param at_once directions that one solution has
    void add_resolving(StagePrice& price, const flow::SolverChoice& how, double solutions, double at_once = 1) const {
        const bool may_be = how.solver == flow::Solver::Auto;
        if (flow::resolves(how) || may_be) {
            const auto across = static_cast<double>(how.resolve.value_or(flow::usual_boxes_across));
            const double boxes = resolving_boxes(sample_, variant_.material, across);
            price.seconds +=
                solutions * at_once * boxes * Range{may_be ? 0 : resolved_seconds.least, resolved_seconds.most};
            price.memory_a_grain += boxes * (box_memory + (at_once - 1) * kept_memory) / count(sample_);
            price.basis += fmt::format("; {}a grid of {:.2g} boxes", may_be ? "perhaps " : "", boxes);
        }
    }

    [[nodiscard]] Range one_flow() const { return count(sample_) * flow_seconds; }

    const casefile::Case& case_;
    const casefile::Variant& variant_;
    PricedSample& sample_;
};

} // namespace

Range waited(const casefile::Case& what, const Range& steps) {
    const auto patience = static_cast<double>(what.balance.patience);
    return steps + Range{patience, 1.2 * patience};
}

double strain_between(double start, double end) {
    constexpr double least = 0.007;
    return std::max(start > end ? least : 0, std::log((1 - end) / (1 - start)) / 3);
}

StagePrice price_stage(
    const casefile::Case& what, const casefile::Variant& variant, const casefile::Stage& stage, PricedSample& sample
) {
    const bool erodes = casefile::traits_of(stage).erodes();
    const Range before = work_of_step(sample); // erosion begins with all that it finds
    StagePrice price = std::visit(Pricer(what, variant, sample), stage.spec);
    if (std::ranges::count(stage.measure, "permeability") > 0) {
        price.seconds += 2 * count(sample) * flow_seconds;
    }
    price.work = (erodes ? before : work_of_step(sample, price.only_pushes)) + price.more_work;
    return price;
}

Range seconds_of(const StagePrice& price, const MachineSpeed& speed) {
    const Range stepping =
        1 / speed.particle_steps_per_second * price.steps + 1 / speed.reference_speed() * price.reference_steps;
    return price.work * stepping * price_error + price.seconds;
}

} // namespace suffuse::plan
