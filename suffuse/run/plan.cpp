#include "suffuse/run/plan.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/io/packing_file.hpp"
#include "suffuse/run/imported_cell.hpp"
#include "suffuse/run/samples.hpp"
#include "suffuse/stats/gradation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace suffuse::run {
namespace {

using casefile::StageSpec;

// Steps seen on samples of 500 to 10,000 grains; `patience` comes on top where a balance is waited for.
constexpr Range settling{500, 15'000};
constexpr Range compaction_share{1.8, 4.5};   // of the steps that the strain takes at the largest rate
constexpr Range swift_steps{350, 2'500};      // of one start
constexpr Range geometry_seconds{1e-5, 6e-5}; // a grain: pushing a cloud together
constexpr Range relaxation{800, 6'000};
constexpr Range constant_volume{100, 8'000};
constexpr Range servo{100, 15'000};
constexpr Range strain_to_stress{0.002, 0.02}; // axial strain until a deviator stress is reached [-]

// The time step of a settled packing over that of one pair of its smallest grains.
constexpr double settled_time_step = 0.38, loose_time_step = 0.6;
constexpr Range time_step_error{0.85, 1.2}; // factor on the steps

// What the made-up packing of measure_speed leaves out: searches while grains fly, recording, other work of the
// machine.
constexpr Range price_error{0.9, 1.8};
constexpr Range cloud_seconds{5e-6, 1e-4};  // a grain
constexpr Range flow_seconds{2e-5, 1.5e-4}; // a grain, one direction

constexpr double settled_porosity = 0.4;
constexpr double process_memory = 40e6, grain_memory = 1000, flow_memory = 5000;          // [B], a grain
constexpr double state_disk = 350, table_disk = 900, picture_disk = 200, page_disk = 2e6; // [B], a grain; [B]

/// What is known of a sample at the end of a stage.
struct Sample {
    std::int64_t grains = 0;
    double smallest = 0; ///< radius [m]
    double median = 0;   ///< diameter by mass [m]
    double pressure = 100e3;
    double porosity = settled_porosity;
    double density = 2600;
    double pair_time_step = 0; ///< stable for one pair of the smallest grains [s]
    std::int64_t coarse = 0;
    std::optional<double> fines_content; ///< of a sample that was drawn [-]
};

struct Work {
    Range steps;
    Range seconds; ///< beside the steps [s]
    double memory_a_grain = grain_memory;
    std::string basis;
};

Range operator*(double factor, const Range& r) {
    return {factor * r.least, factor * r.most};
}

Range operator*(const Range& a, const Range& b) {
    return {a.least * b.least, a.most * b.most};
}

Range operator+(Range a, const Range& b) {
    return a += b;
}

Sample describe(const grains::Grains& grains, const grains::Material& material) {
    Sample sample;
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
    Pricer(const casefile::Case& what, const casefile::Variant& variant, Sample& sample)
        : case_(what), variant_(variant), sample_(sample) {}

    Work operator()(const casefile::ImportSpec& spec) {
        sample_ = describe(io::read_packing(spec.path, case_.material.density).grains, case_.material);
        return {{}, {0, 0.1}, grain_memory, "read from a file"};
    }

    Work operator()(const packing::PackSpec& spec) {
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

    Work operator()(const packing::CompactSpec& spec) {
        const double dt = spec.time_step > 0 ? spec.time_step : loose_time_step * sample_.pair_time_step;
        const bool asks = spec.void_ratio || spec.intergranular_void_ratio;
        const double end = spec.void_ratio ? *spec.void_ratio / (1 + *spec.void_ratio) : settled_porosity;
        const double start = std::min(sample_.porosity, spec.start_porosity.value_or(1));
        const double strain = std::max(0.02, std::log((1 - end) / (1 - start)) / 3);
        sample_.porosity = end;
        sample_.pressure = spec.pressure;
        if (spec.protocol == packing::Protocol::Swift) {
            const Range trials = asks ? Range{1, 3} : Range{1, 1};
            return {
                trials * swift_steps + waited({}), trials * (static_cast<double>(sample_.grains) * geometry_seconds),
                grain_memory, "swift: pushed together, then pressed; contacts per grain some 0.6 above faithful's"};
        }
        const double trials = asks ? 4 : 1; // the search for a void ratio repeats the compaction
        return {
            trials * (strain / spec.max_rate / dt * compaction_share + 2 * waited({})),
            {},
            grain_memory,
            fmt::format(
                "{}: strain {:.2g} an axis at {:.3g} 1/s and slower, then settling", packing::name_of(spec.protocol),
                strain, spec.max_rate
            )};
    }

    Work operator()(const dem::SettleSpec& spec) {
        for (const cell::AxisControl& axis : spec.loading.axis) {
            if (axis.control == cell::Control::Stress && axis.value > 0) {
                sample_.pressure = axis.value;
            }
        }
        return {waited(settling), {}, grain_memory, "until balanced"};
    }

    Work operator()(const dem::AdvanceSpec& spec) {
        const auto steps = static_cast<double>(spec.steps);
        return {{steps, steps}, {}, grain_memory, "as asked"};
    }

    Work operator()(const triaxial::TriaxialSpec& spec) {
        const double rate = spec.inertial_number * std::sqrt(sample_.pressure / sample_.density) / sample_.median;
        const double dt = spec.time_step > 0 ? spec.time_step : settled_dt();
        const double a_strain = 1 / (rate * dt); // steps
        const std::string pace = fmt::format("at {:.3g} 1/s (inertial number {:.1e})", rate, spec.inertial_number);
        if (spec.deviator_stress || spec.stress_ratio) {
            const Range strain{
                std::min(strain_to_stress.least, spec.strain), std::min(strain_to_stress.most, spec.strain)};
            return {
                a_strain * strain + waited(settling),
                {},
                grain_memory,
                fmt::format("until a stress, at most {:.3g} % {}, then settling", 100 * spec.strain, pace)};
        }
        const Range error = spec.time_step > 0 ? Range{1, 1} : time_step_error;
        return {a_strain * spec.strain * error, {}, grain_memory, fmt::format("{:.3g} % {}", 100 * spec.strain, pace)};
    }

    Work operator()(const flow::FlowSpec& spec) {
        return {{}, (spec.tensor ? 2.0 : 1.0) * one_flow(), grain_memory + flow_memory, "no steps"};
    }

    Work operator()(const erosion::DetachStageSpec& spec) {
        const auto probes = static_cast<double>(spec.gradients.size());
        return {
            relaxation + probes * probe(spec.probe), one_flow(), 3 * grain_memory + flow_memory,
            fmt::format("relaxation, {} gradients with their twins", spec.gradients.size())};
    }

    Work operator()(const erosion::ErodeSpec& spec) {
        const Range a_pass = relaxation + probe(spec.probe) + waited(constant_volume) + waited(servo);
        const Range passes{1, static_cast<double>(spec.passes)}; // it ends early when nothing leaves
        return {
            {a_pass.least * std::min(passes.most, 2.0), a_pass.most * passes.most},
            3 * passes.most * one_flow(),
            4 * grain_memory + flow_memory,
            fmt::format("{} passes: relaxation, probe with its twin, two new equilibria", spec.passes)};
    }

    Work operator()(const erosion::RemoveSpec&) const {
        return {waited(constant_volume) + waited(servo), {}, 2 * grain_memory, "two new equilibria"};
    }

private:
    [[nodiscard]] double settled_dt() const { return settled_time_step * sample_.pair_time_step; }

    /// Steps until balanced: at least the patience.
    [[nodiscard]] Range waited(const Range& steps) const {
        const auto patience = static_cast<double>(case_.balance.patience);
        return {steps.least + patience, steps.most + 2 * patience};
    }

    [[nodiscard]] static Range probe(const erosion::ProbeSpec& spec) {
        const auto steps = 2 * static_cast<double>(spec.ramp + spec.watch); // with the twin
        return {steps, steps};
    }

    [[nodiscard]] Range one_flow() const { return static_cast<double>(sample_.grains) * flow_seconds; }

    const casefile::Case& case_;
    const casefile::Variant& variant_;
    Sample& sample_;
};

double disk_of(const casefile::OutputSpec& output, const casefile::Stage& stage, bool is_last, std::int64_t grains) {
    double a_grain = state_disk;
    for (const std::string& format : output.formats) {
        a_grain += format == "csv" ? table_disk : picture_disk;
    }
    if (is_last || std::holds_alternative<casefile::ImportSpec>(stage.spec)) {
        a_grain += table_disk;
    }
    return a_grain * static_cast<double>(grains);
}

void plan_variant(const casefile::Case& what, const casefile::Variant& variant, RunPlan& plan) {
    std::vector<Sample> ends(variant.stages.size());
    for (std::size_t k = 0; k < variant.stages.size(); ++k) {
        const casefile::Stage& stage = variant.stages[k];
        if (stage.parent >= 0) {
            ends[k] = ends[static_cast<std::size_t>(stage.parent)];
        }
        const Work work = std::visit(Pricer(what, variant, ends[k]), stage.spec);
        StageEstimate estimate;
        estimate.study = variant.folder;
        estimate.stage = stage.name;
        estimate.verb = casefile::verb_of(stage.spec);
        estimate.grains = ends[k].grains;
        estimate.steps = work.steps;
        estimate.seconds =
            static_cast<double>(ends[k].grains) / plan.speed.particle_steps_per_second * work.steps * price_error +
            work.seconds;
        estimate.memory = work.memory_a_grain * static_cast<double>(ends[k].grains);
        estimate.disk = disk_of(what.output, stage, k + 1 == variant.stages.size(), ends[k].grains);
        estimate.basis = work.basis;
        if (std::holds_alternative<packing::PackSpec>(stage.spec)) {
            estimate.coarse = ends[k].coarse;
            estimate.fines_content = ends[k].fines_content;
            estimate.sized_by = variant.sized_by ? grains::name_of(*variant.sized_by) : "";
        }
        plan.stages.push_back(std::move(estimate));
    }
}

/// The greediest stages of as many samples as run at once.
double memory_of(const RunPlan& plan) {
    std::map<std::string, double> of_sample;
    for (const StageEstimate& stage : plan.stages) {
        double& most = of_sample[stage.study];
        most = std::max(most, stage.memory);
    }
    std::vector<double> samples;
    for (const auto& [name, memory] : of_sample) {
        samples.push_back(memory);
    }
    std::sort(samples.rbegin(), samples.rend());
    samples.resize(std::min(samples.size(), static_cast<std::size_t>(plan.speed.at_once)));
    return std::accumulate(samples.begin(), samples.end(), process_memory);
}

} // namespace

int samples_at_once(const casefile::Case& what) {
    return std::clamp(static_cast<int>(list_samples(what).size()), 1, thread_count());
}

Range side_by_side(const std::vector<StageEstimate>& stages, int at_once) {
    Range sum, longest;
    std::map<std::string, Range> of_sample;
    for (const StageEstimate& stage : stages) {
        sum += stage.seconds;
        of_sample[stage.study] += stage.seconds;
    }
    for (const auto& [name, seconds] : of_sample) {
        longest = {std::max(longest.least, seconds.least), std::max(longest.most, seconds.most)};
    }
    return {std::max(sum.least / at_once, longest.least), std::max(sum.most / at_once, longest.most)};
}

std::int64_t largest_sample(const casefile::Case& what) {
    std::int64_t most = 0;
    for (const casefile::Study& study : what.studies) {
        for (const casefile::Variant& variant : study.variants) {
            most = std::max(most, variant.particles);
            for (const casefile::Stage& stage : variant.stages) {
                const auto* import = std::get_if<casefile::ImportSpec>(&stage.spec);
                if (import == nullptr) {
                    continue;
                }
                const auto read = io::read_packing(import->path, what.material.density);
                imported_cell(*import, read); // a missing one is told before anything runs
                most = std::max(most, static_cast<std::int64_t>(read.grains.size()));
            }
        }
    }
    return most;
}

RunPlan plan_run(const casefile::Case& what, const MachineSpeed& speed) {
    expects(speed.particle_steps_per_second > 0, "a plan needs the speed of the machine");
    RunPlan plan;
    plan.speed = speed;
    plan.studies = static_cast<int>(what.studies.size());
    for (const casefile::Study& study : what.studies) {
        for (const casefile::Variant& variant : study.variants) {
            plan_variant(what, variant, plan);
        }
    }
    sum_up(plan);
    return plan;
}

void sum_up(RunPlan& plan) {
    plan.steps = {};
    plan.disk = page_disk;
    for (const StageEstimate& stage : plan.stages) {
        plan.steps += stage.steps;
        plan.disk += stage.disk;
    }
    plan.seconds = side_by_side(plan.stages, plan.speed.at_once);
    plan.memory = memory_of(plan);
}

} // namespace suffuse::run
