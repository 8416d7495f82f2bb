#include "suffuse/run/price_stage.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/io/packing_file.hpp"
#include "suffuse/packing/compact.hpp"
#include "suffuse/packing/pace.hpp"
#include "suffuse/stats/gradation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace suffuse::run {
namespace {

// Steps, beside the `patience` that comes on top where a balance is waited for.
constexpr Range settling{500, 6'000};    // a packing from elsewhere
constexpr Range loaded_share{2.4, 7.5};  // of the steps that the strain takes at the largest rate
constexpr Range ringing_share{3.5, 7.5}; // the same under the servo of `slow`
constexpr Range swift_start{2'500, 9'000}, swift_density{300, 1'500}; // from near touching; from an asked density
constexpr Range first_relaxation{700, 3'000}, next_relaxation{200, 1'200};
constexpr Range rest_at_volume{100, 8'000}, rest_under_stress{100, 15'000}; // after many grains were taken at once
constexpr Range balance_after_removal{0, 150}, balance_at_stress{0, 500};
constexpr double stiffest = 0.25, softest = 0.07; // deviator stress over axial strain, over the contact modulus [-]
constexpr Range trials_for_a_density{2, 6};       // compactions until an asked void ratio is met
constexpr int endless = 5;                        // passes that "until nothing leaves" may add to those asked
constexpr Range left_by_erosion{0.6, 1};          // of the grains

// The time step of a settled packing over that of one pair of its smallest grains; how far off it is, as a factor on
// the steps.
constexpr double settled_time_step = 0.41, loose_time_step = 0.6;
constexpr Range time_step_error{0.78, 1.25};

// What the made-up packing of measure_speed leaves out: searches while grains fly, looks at the balance, recording,
// files, other work of the machine.
constexpr Range price_error{0.75, 1.35};
constexpr Range cloud_seconds{2e-6, 3e-5};    // a grain
constexpr Range geometry_seconds{1e-5, 6e-5}; // a grain: pushing a cloud together
constexpr Range flow_seconds{1e-5, 6e-5};     // a grain, one direction

constexpr double settled_porosity = 0.4;
constexpr double grain_memory = 1000, flow_memory = 5000; // [B], a grain

PricedSample describe(const grains::Grains& grains, const grains::Material& material) {
    PricedSample sample;
    sample.grains = static_cast<std::int64_t>(grains.size());
    sample.smallest = *std::min_element(grains.radius.begin(), grains.radius.end());
    sample.median = stats::size_at(stats::measure_gradation(grains), 0.5);
    sample.density = material.density;
    dem::World smallest; // a world without contacts: the bound is that of a pair of its smallest grains
    smallest.material = material;
    add_grain(smallest.grains, {}, sample.smallest, material.density);
    sample.pair_time_step = dem::stable_time_step(smallest);
    return sample;
}

/// One stage: what it takes, and what it makes of the sample.
class Pricer {
public:
    Pricer(const casefile::Case& what, const casefile::Variant& variant, PricedSample& sample)
        : case_(what), variant_(variant), sample_(sample) {}

    StagePrice operator()(const casefile::ImportSpec& spec) {
        sample_ = describe(io::read_packing(spec.path, case_.material.density).grains, case_.material);
        return {{}, {0, 0.1}, grain_memory, "read from a file"};
    }

    StagePrice operator()(const packing::PackSpec& spec) {
        if (!variant_.soil) {
            throw Bug("a stage that packs without a soil");
        }
        const auto count = static_cast<int>(variant_.particles);
        const grains::SampledGrains drawn = grains::sample_soil(*variant_.soil, count);
        grains::Grains grains;
        for (const double r : drawn.radius) {
            add_grain(grains, {}, r, case_.material.density);
        }
        sample_ = describe(grains, case_.material);
        sample_.porosity = spec.porosity;
        sample_.coarse = std::count(drawn.fine.begin(), drawn.fine.end(), std::uint8_t{0});
        sample_.fines_content = drawn.fines_content;
        return {
            {},
            static_cast<double>(count) * cloud_seconds,
            grain_memory,
            fmt::format(
                "no steps; {} coarse grains, fines content {:.2f} %", sample_.coarse, 100 * drawn.fines_content
            )};
    }

    StagePrice operator()(const packing::CompactSpec& spec) {
        const bool asks = spec.void_ratio || spec.intergranular_void_ratio;
        const double end = spec.void_ratio ? *spec.void_ratio / (1 + *spec.void_ratio) : settled_porosity;
        const double cloud = sample_.porosity;
        const double start =
            std::min(cloud, spec.start_porosity.value_or(leaves_out_gas(spec) ? packing::open_porosity : 1));
        const Range pushing = start < cloud ? static_cast<double>(sample_.grains) * geometry_seconds : Range{};
        sample_.porosity = end;
        sample_.pressure = spec.pressure;
        if (spec.protocol == packing::Protocol::Swift) {
            const Range trials = asks ? Range{1, 3} : Range{1, 1};
            return {
                trials * ((asks ? swift_density : swift_start) + waited({})),
                trials * (static_cast<double>(sample_.grains) * geometry_seconds), grain_memory,
                "swift: pushed together, then pressed; contacts per grain some 0.6 above faithful's"};
        }
        const Range trials = asks ? trials_for_a_density : Range{1, 1};
        const double open = std::min(start, packing::open_porosity); // from here on grains carry load now and then
        const double a_strain = 1 / (spec.max_rate * compaction_time_step(spec));
        const double gas = a_strain * strain_between(start, open), loaded = a_strain * strain_between(open, end);
        const Range share = spec.protocol == packing::Protocol::Slow ? ringing_share : loaded_share;
        return {
            trials * (Range{gas, gas} + loaded * share + waited({})), trials * pushing, grain_memory,
            fmt::format(
                "{}: from a porosity of {:.2f} at {:.3g} 1/s and slower, then settling",
                packing::name_of(spec.protocol), start, spec.max_rate
            )};
    }

    StagePrice operator()(const dem::SettleSpec& spec) {
        for (const cell::AxisControl& axis : spec.loading.axis) {
            if (axis.control == cell::Control::Stress && axis.value > 0) {
                sample_.pressure = axis.value;
            }
        }
        return {waited(settling), {}, grain_memory, "until balanced"};
    }

    StagePrice operator()(const dem::AdvanceSpec& spec) {
        const auto steps = static_cast<double>(spec.steps);
        return {{steps, steps}, {}, grain_memory, "as asked"};
    }

    StagePrice operator()(const triaxial::TriaxialSpec& spec) {
        const double rate = spec.inertial_number * std::sqrt(sample_.pressure / sample_.density) / sample_.median;
        const double dt = spec.time_step > 0 ? spec.time_step : settled_dt();
        const double a_strain = 1 / (rate * dt); // steps
        const std::string pace = fmt::format("at {:.3g} 1/s (inertial number {:.1e})", rate, spec.inertial_number);
        if (spec.deviator_stress || spec.stress_ratio) {
            return {
                a_strain * strain_until(spec) + waited(balance_at_stress),
                {},
                grain_memory,
                fmt::format("until a stress, at most {:.3g} % {}, then settling", 100 * spec.strain, pace)};
        }
        const Range error = spec.time_step > 0 ? Range{1, 1} : time_step_error;
        return {a_strain * spec.strain * error, {}, grain_memory, fmt::format("{:.3g} % {}", 100 * spec.strain, pace)};
    }

    StagePrice operator()(const flow::FlowSpec& spec) {
        return {{}, (spec.tensor ? 2.0 : 1.0) * one_flow(), grain_memory + flow_memory, "no steps"};
    }

    StagePrice operator()(const erosion::DetachStageSpec& spec) {
        const auto gradients = static_cast<double>(spec.gradients.size());
        return {
            first_relaxation + probe(spec.probe, gradients), one_flow(), 3 * grain_memory + flow_memory,
            fmt::format("relaxation, {} gradients and a twin", spec.gradients.size())};
    }

    StagePrice operator()(const erosion::ErodeSpec& spec) {
        const Range a_pass = probe(spec.probe, 1) + 2 * waited(balance_after_removal);
        const Range passes{
            static_cast<double>(spec.passes),
            static_cast<double>(spec.passes + (spec.until_nothing_leaves ? endless : 0))};
        const Range later{passes.least - 1, passes.most - 1};
        sample_.left = sample_.left * left_by_erosion;
        return {
            passes * a_pass + first_relaxation + later * next_relaxation, 2 * passes * one_flow(),
            4 * grain_memory + flow_memory,
            fmt::format(
                "{} passes{}: relaxation, probe with its twin, two new equilibria; more where the skeleton gives way",
                spec.passes, spec.until_nothing_leaves ? " and more, until nothing leaves" : ""
            )};
    }

    StagePrice operator()(const erosion::RemoveSpec&) {
        sample_.left = sample_.left * left_by_erosion;
        return {
            waited(rest_at_volume) + waited(rest_under_stress),
            {},
            2 * grain_memory,
            "two new equilibria, after all asked have gone"};
    }

private:
    [[nodiscard]] double settled_dt() const { return settled_time_step * sample_.pair_time_step; }

    [[nodiscard]] bool leaves_out_gas(const packing::CompactSpec& spec) const {
        const double normal = spec.prepare.adhesion_normal.value_or(case_.material.adhesion_normal);
        const double shear = spec.prepare.adhesion_shear.value_or(case_.material.adhesion_shear);
        return spec.protocol == packing::Protocol::Faithful && normal <= 0 && shear <= 0;
    }

    [[nodiscard]] double compaction_time_step(const packing::CompactSpec& spec) const {
        if (spec.time_step > 0) {
            return spec.time_step;
        }
        return spec.protocol == packing::Protocol::Slow ? packing::slow_time_step(sample_.smallest, case_.material)
                                                        : loose_time_step * sample_.pair_time_step;
    }

    /// Strain of each axis from one porosity to another, at least a little [-].
    [[nodiscard]] static double strain_between(double start, double end) {
        constexpr double least = 0.007;
        return std::max(start > end ? least : 0, std::log((1 - end) / (1 - start)) / 3);
    }

    /// Steps until balanced, and then the patience.
    [[nodiscard]] Range waited(const Range& steps) const {
        const auto patience = static_cast<double>(case_.balance.patience);
        return steps + Range{patience, 1.2 * patience};
    }

    /// Probes, and the one twin that they share.
    [[nodiscard]] static Range probe(const erosion::ProbeSpec& spec, double probes) {
        const double steps = (probes + 1) * static_cast<double>(spec.ramp + spec.watch);
        return {steps, steps};
    }

    /// Axial strain until a deviator stress is reached [-].
    [[nodiscard]] Range strain_until(const triaxial::TriaxialSpec& spec) const {
        double q = spec.deviator_stress.value_or(0);
        if (spec.stress_ratio) { // along the drained path; undrained and constant-mean ones end below
            q = *spec.stress_ratio * sample_.pressure / std::max(1 - *spec.stress_ratio / 3, 0.1);
        }
        const double strain = q / case_.material.modulus;
        return {std::min(strain / stiffest, spec.strain), std::min(strain / softest, spec.strain)};
    }

    [[nodiscard]] Range one_flow() const { return static_cast<double>(sample_.grains) * flow_seconds; }

    const casefile::Case& case_;
    const casefile::Variant& variant_;
    PricedSample& sample_;
};

} // namespace

StagePrice price_stage(
    const casefile::Case& what, const casefile::Variant& variant, const casefile::Stage& stage, PricedSample& sample
) {
    const Range left = sample.left; // erosion begins with all that it finds
    StagePrice price = std::visit(Pricer(what, variant, sample), stage.spec);
    price.left = left;
    return price;
}

Range seconds_of(const StagePrice& price, double grains, const MachineSpeed& speed) {
    return grains / speed.particle_steps_per_second * price.left * price.steps * price_error + price.seconds;
}

} // namespace suffuse::run
