// plan: what a case would cost.

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/casefile/calibration_case.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/plan/fit_memory.hpp"
#include "suffuse/plan/past_prices.hpp"
#include "suffuse/plan/plan.hpp"
#include "suffuse/plan/requested_stages.hpp"
#include "suffuse/plan/sum_ranges.hpp"
#include "suffuse/record/samples.hpp"

#include <fmt/format.h>

#include "apps/conduct_calibration.hpp"
#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/shared_options.hpp"
#include "apps/shortages.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include "apps/wording.hpp"
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <vector>

namespace suffuse::apps {
namespace {

struct PlanVerb final : Verb {
    PlanVerb()
        : Verb(
              "plan", "show what a case costs: steps, time, memory, disk",
              "suffuse plan my-dyke/case.toml --preset paper"
          ) {}

    std::string given; ///< a case, or the folder that holds one
    ThreadOption threads;
    CaseChanges changes;
    CacheOptions cache;
    MemoryOption memory;
    std::string until; ///< stage

    void add_to(Options& options) override {
        options.argument("CASE", given, case_text).required();
        threads.add_to(options);
        changes.add_to(options);
        cache.add_to(options);
        memory.add_to(options);
        add_until(options, until);
    }

    [[nodiscard]] int act(const CommandLine&, const Console& console) const override;
};

std::string source_of(const plan::StageEstimate& stage) {
    return stage.is_cached ? "in the cache" : stage.basis;
}

using Row = std::vector<std::string>;

/// Columns as wide as what is in them: the first `words` of them to the left, the others to the right; the last one,
/// which says why, as it comes.
std::string aligned(const std::vector<Row>& rows, std::size_t words) {
    std::vector<std::size_t> width(rows.front().size(), 0);
    for (const Row& row : rows) {
        for (std::size_t k = 0; k + 1 < row.size(); ++k) {
            width[k] = std::max(width[k], columns_of(row[k]));
        }
    }
    std::string text;
    for (const Row& row : rows) {
        for (std::size_t k = 0; k + 1 < row.size(); ++k) {
            text += k < words ? fmt::format("{:{}}  ", row[k], width[k]) : fmt::format("{:>{}}  ", row[k], width[k]);
        }
        text += row.back() + "\n";
    }
    return text;
}

std::string table_of(const plan::RunPlan& plan) {
    std::vector<Row> rows{{"stage", "verb", "grains", "steps", "time", "basis"}};
    for (const plan::StageEstimate& stage : plan.stages) {
        rows.push_back(
            {stage.study + "/" + stage.stage, stage.verb, count_text(stage.grains), steps_text(stage.steps),
             duration_range_text(stage.seconds), source_of(stage)}
        );
    }
    return aligned(rows, 2);
}

/// One row of the matrix: a sample, all its stages together.
struct SampleRow {
    std::string name;
    std::uint64_t seed = 0;
    std::int64_t grains = 0;
    Range steps, seconds;
    double memory = 0, disk = 0;
    int stages = 0, cached = 0;
    std::int64_t coarse = 0;
    std::optional<double> fines_content; ///< that the sample drawn really has [-]
    std::string sized_by;                ///< rule of `sample_size`
};

std::vector<SampleRow> rows_of(const casefile::Case& what, const plan::RunPlan& plan, const std::string& until) {
    std::vector<SampleRow> rows;
    for (const record::Sample& sample : record::list_samples(what, until)) {
        SampleRow row{sample.variant->folder, sample.variant->seed, 0, {}, {}, 0, 0, sample.stages, 0, 0, {}, ""};
        std::vector<Range> steps, seconds;
        for (int k = 0; k < sample.stages; ++k) {
            const plan::StageEstimate& stage = plan.stages.at(static_cast<std::size_t>(sample.first_stage - 1 + k));
            row.grains = std::max(row.grains, stage.grains);
            steps.push_back(stage.steps);
            seconds.push_back(stage.seconds);
            row.memory = std::max(row.memory, stage.memory);
            row.disk += stage.disk;
            row.cached += stage.is_cached ? 1 : 0;
            if (stage.fines_content) {
                row.coarse = stage.coarse;
                row.fines_content = stage.fines_content;
                row.sized_by = stage.sized_by;
            }
        }
        row.steps = plan::sum_ranges(steps);
        row.seconds = plan::sum_ranges(seconds);
        rows.push_back(std::move(row));
    }
    return rows;
}

std::string matrix_of(const std::vector<SampleRow>& rows) {
    std::size_t width = 12;
    for (const SampleRow& row : rows) {
        width = std::max(width, row.name.size() + 2);
    }
    // Only where the grains of a study are counted by rules: what they came to.
    const bool shows_rules =
        std::any_of(rows.begin(), rows.end(), [](const SampleRow& row) { return !row.sized_by.empty(); });
    std::string text = fmt::format(
        "{:{}}{:>8}  {:>16}  {:>12}  {:>8}  {:>8}  {:>10}{}\n", "sample", width, "grains", "steps", "time", "memory",
        "disk", "in cache", shows_rules ? "    coarse  fines by mass  sized by" : ""
    );
    for (const SampleRow& row : rows) {
        text += fmt::format(
            "{:{}}{:>8}  {:>16}  {:>12}  {:>8}  {:>8}  {:>10}", row.name, width, count_text(row.grains),
            steps_text(row.steps), duration_range_text(row.seconds), size_text(row.memory), size_text(row.disk),
            row.cached == 0 ? "" : fmt::format("{}/{}", row.cached, row.stages)
        );
        if (shows_rules && row.fines_content) {
            text +=
                fmt::format("  {:>8}  {:>11.2f} %  {}", count_text(row.coarse), 100 * *row.fines_content, row.sized_by);
        }
        text += "\n";
    }
    return text;
}

nlohmann::json rows_json(const std::vector<SampleRow>& rows) {
    nlohmann::json list = nlohmann::json::array();
    for (const SampleRow& row : rows) {
        list.push_back(
            {{"sample", row.name},
             {"seed", row.seed},
             {"grains", row.grains},
             {"steps", {row.steps.least, row.steps.most}},
             {"seconds", {row.seconds.least, row.seconds.most}},
             {"memory", row.memory},
             {"disk", row.disk},
             {"stages", row.stages},
             {"cached", row.cached}}
        );
        if (row.fines_content) {
            list.back()["coarse_grains"] = row.coarse;
            list.back()["fines_content"] = *row.fines_content;
            list.back()["sized_by"] = row.sized_by.empty() ? "particles" : row.sized_by;
        }
    }
    return list;
}

/// What a plan cannot know yet: samples that the results will require.
void print_refinements(const casefile::Case& what, const plan::RunPlan& plan, const Console& console) {
    for (const casefile::Study& study : what.studies) {
        if (!study.refine) {
            continue;
        }
        const auto sweep = std::find_if(study.sweep.begin(), study.sweep.end(), [&](const casefile::Sweep& s) {
            return s.key == study.refine->key;
        });
        const std::size_t curves = study.refine->at.size() * study.variants.size() / sweep->values.size();
        console.talk(fmt::format(
            "refine adds up to {} to study {}, around the {} of {}; all that is refined takes {} of the time above",
            plural(static_cast<std::ptrdiff_t>(2 * static_cast<std::size_t>(study.refine->add) * curves), "sample"),
            study.name, study.refine->maximum ? "maximum" : "minimum", study.refine->of,
            duration_range_text(plan::seconds_of_refined(plan.refined, plan.speed.at_once))
        ));
    }
}

/// As `run` would plan it. What it would refuse is planned all the same, and reported.
plan::RunPlan plan_within_or_report(
    double bytes, int at_once, std::vector<std::string>& warnings, const std::function<plan::RunPlan(int)>& make
) {
    try {
        return plan::plan_within(bytes, at_once, make);
    } catch (const IoError& error) {
        warnings.push_back(fmt::format("run will refuse this case: {}", error.what()));
        return make(1);
    }
}

int PlanVerb::act(const CommandLine&, const Console& console) const {
    const std::string file = case_in(given);
    if (casefile::calibrates(file)) {
        threads.apply();
        return price_calibration(
            {.case_file = file,
             .overrides = changes.overrides,
             .cache = cache.folder_or(job::cache_next_to("runs/new")),
             .cache_owners = cache.owners(),
             .memory = memory.bytes()},
            console
        );
    }
    const casefile::Case what = load_given_case(file, changes, console);
    plan::check_until(what, until);
    threads.apply();
    const double bytes = memory.bytes();
    const std::filesystem::path folder = cache.folder_or(job::cache_next_to("runs/new"));
    std::vector<std::string> warnings;
    plan::RunPlan plan = plan_within_or_report(bytes, plan::samples_at_once(what), warnings, [&](int at_once) {
        plan::RunPlan made = plan::plan_case(what, at_once);
        plan::PastPrices(folder).correct(made);
        plan::price_requested_alone(made, what, until);
        plan::leave_out_done(made, what, {}, record::StageCache(folder, cache.owners())); // sums up, too
        return made;
    });
    const std::vector<SampleRow> rows = rows_of(what, plan, until);
    plan::keep_requested_alone(plan, what, until);
    std::ranges::copy(shortages(plan, "."), std::back_inserter(warnings));
    for (const std::string& warning : warnings) {
        console.talk("warning: " + warning);
    }
    if (rows.size() > 1) {
        console.result(matrix_of(rows));
        console.detail(table_of(plan));
    } else {
        console.result(table_of(plan));
    }
    console.result(fmt::format("{}\n", plan::plan_sentence(plan)));
    console.talk(fmt::format(
        "priced at {:.2g} grain-steps/s, measured now with {} on {} grains", plan.speed.particle_steps_per_second,
        plural(plan.speed.threads, "thread"), count_text(plan.speed.grains)
    ));
    const auto cached =
        std::count_if(plan.stages.begin(), plan.stages.end(), [](const auto& s) { return s.is_cached; });
    if (plan.speed.at_once > 1) {
        console.talk(fmt::format(
            "{} samples at a time, {} each{}", plan.speed.at_once, plural(plan.speed.threads, "thread"),
            console.is_verbose() ? "" : "; -v lists their stages"
        ));
    }
    print_refinements(what, plan, console);
    if (cached > 0) {
        console.talk(fmt::format("{} are in {} and take no time", plural(cached, "stage"), folder.string()));
    }
    nlohmann::json json = plan;
    json["samples"] = rows_json(rows);
    json["cache"] = folder.string();
    json["memory_limit"] = bytes;
    json["case"] = file;
    json["preset"] = what.preset;
    json["warnings"] = warnings;
    console.document(json_text(json));
    return Done;
}

} // namespace

MadeVerb make_plan_verb() {
    return std::make_unique<PlanVerb>();
}

} // namespace suffuse::apps
