#include "suffuse/plan/plan.hpp"

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/casefile/stage_traits.hpp"
#include "suffuse/erosion/migration_result.hpp"
#include "suffuse/plan/price_stage.hpp"
#include "suffuse/plan/sum_ranges.hpp"
#include "suffuse/record/read_import.hpp"
#include "suffuse/record/samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace suffuse::plan {
namespace {

constexpr double process_memory = 40e6;                                                   // [B]
constexpr double state_disk = 350, table_disk = 900, picture_disk = 240, page_disk = 2e6; // [B], a grain; [B]

double disk_of(
    const casefile::Case& what, const casefile::Variant& variant, const casefile::Stage& stage, std::int64_t grains
) {
    const auto& formats = what.output.formats;
    const auto pictures = static_cast<double>(formats.size()) - static_cast<double>(std::ranges::count(formats, "csv"));
    const double tables = record::leaves_tables(what, variant, stage) ? table_disk : 0;
    const auto* const erosion = std::get_if<erosion::ErodeSpec>(&stage.spec);
    const int passes = erosion != nullptr ? erosion->passes : 0; // each leaves a state, and a picture of before
    const auto* const migration = std::get_if<erosion::MigrateSpec>(&stage.spec);
    const bool is_watched = migration != nullptr && what.output.snapshots.when != casefile::Snapshots::When::Never;
    const auto frames = is_watched ? erosion::frames_kept + static_cast<int>(migration->gradients.size()) + 1 : 0;
    const double states = state_disk * (std::max(passes, 1) + frames) + pictures * picture_disk * (passes + 1);
    return (states + tables) * static_cast<double>(grains);
}

void plan_variant(const casefile::Case& what, const casefile::Variant& variant, RunPlan& plan) {
    std::vector<PricedSample> ends(variant.stages.size());
    for (std::size_t k = 0; k < variant.stages.size(); ++k) {
        const casefile::Stage& stage = variant.stages[k];
        if (stage.parent >= 0) {
            ends[k] = ends[static_cast<std::size_t>(stage.parent)];
        }
        const StagePrice price = price_stage(what, variant, stage, ends[k]);
        StageEstimate estimate;
        estimate.study = variant.folder;
        estimate.stage = stage.name;
        estimate.verb = casefile::verb_of(stage.spec);
        estimate.grains = std::llround(count(ends[k]));
        estimate.steps = price.steps + price.reference_steps;
        estimate.seconds = seconds_of(price, plan.speed);
        estimate.memory = price.memory_a_grain * count(ends[k]);
        estimate.disk = disk_of(what, variant, stage, estimate.grains);
        estimate.basis = price.basis;
        estimate.kind = estimate.verb + (price.kind.empty() ? "" : ": " + price.kind);
        estimate.tables_steps = middle(estimate.steps);
        estimate.tables_seconds = middle(estimate.seconds);
        if (casefile::traits_of(stage).origin == casefile::Origin::Soil) {
            estimate.coarse = std::llround(ends[k].coarse.grains);
            estimate.fines_content = fines_content(ends[k]);
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
    return std::clamp(static_cast<int>(record::list_samples(what).size()), 1, thread_count());
}

Range side_by_side(const std::vector<StageEstimate>& stages, int at_once) {
    Range longest;
    std::vector<Range> all;
    std::map<std::string, std::vector<Range>> of_sample;
    for (const StageEstimate& stage : stages) {
        all.push_back(stage.seconds);
        of_sample[stage.study].push_back(stage.seconds);
    }
    for (const auto& [name, parts] : of_sample) {
        const Range seconds = sum_ranges(parts);
        longest = {std::max(longest.least, seconds.least), std::max(longest.most, seconds.most)};
    }
    const Range sum = sum_ranges(all);
    return {std::max(sum.least / at_once, longest.least), std::max(sum.most / at_once, longest.most)};
}

std::int64_t largest_sample(const casefile::Case& what) {
    std::int64_t most = record::check_imports(what).largest; // errors of a packing are reported before anything runs
    for (const casefile::Study& study : what.studies) {
        for (const casefile::Variant& variant : study.variants) {
            most = std::max(most, variant.particles);
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
    plan.refined = price_refined(plan, what);
    sum_up(plan);
    return plan;
}

void sum_up(RunPlan& plan) {
    plan.disk = page_disk;
    std::vector<Range> steps;
    for (const StageEstimate& stage : plan.stages) {
        steps.push_back(stage.steps);
        plan.disk += stage.disk;
    }
    plan.steps = sum_ranges(steps);
    plan.seconds = side_by_side(plan.stages, plan.speed.at_once) + seconds_of_refined(plan.refined, plan.speed.at_once);
    plan.memory = memory_of(plan);
}

RunPlan plan_case(const casefile::Case& what, int at_once) {
    constexpr double window = 0.3; // [s]
    const std::int64_t grains = largest_sample(what);
    MachineSpeed speed = measure_speed(grains, what.mode, window, at_once);
    if (what.mode != dem::Mode::Reference) { // relaxations and probes keep to it
        const MachineSpeed reference = measure_speed(grains, dem::Mode::Reference, window, at_once);
        speed.in_reference_mode = reference.particle_steps_per_second;
    }
    return plan_run(what, speed);
}

std::string plan_sentence(const RunPlan& plan) {
    return fmt::format(
        "{}, {}, {} steps: {}, up to {} memory, {} disk", plan.studies == 1 ? "1 study" : plural(plan.studies, "study"),
        plural(std::ssize(plan.stages), "stage"), steps_text(plan.steps), duration_range_text(plan.seconds),
        size_text(plan.memory), size_text(plan.disk)
    );
}

} // namespace suffuse::plan
