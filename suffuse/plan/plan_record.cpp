#include "suffuse/plan/plan_record.hpp"

#include "suffuse/base/quantile.hpp"
#include "suffuse/plan/sum_ranges.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/stored.hpp"

#include <cmath>

namespace suffuse::plan {
namespace {

using nlohmann::json;

const std::filesystem::path plan_file = "plan.json";

Range range_of(const json& pair) {
    return {pair.at(0), pair.at(1)};
}

bool is_priced(const json& stage) {
    return range_of(stage.at("seconds")).most > 0;
}

/// What an earlier plan has priced stays as it was.
void keep_priced(json& plan, const json& earlier) {
    for (json& stage : plan.at("stages")) {
        for (const json& known : earlier.at("stages")) {
            if (known.at("study") == stage.at("study") && known.at("stage") == stage.at("stage") && is_priced(known)) {
                stage = known;
            }
        }
    }
}

double error_of(const Range& planned, double truth) {
    return std::abs(middle(planned) / truth - 1);
}

/// Adds to each priced stage of a plan what it took.
std::vector<StageOutcome> record_stages(const std::filesystem::path& run, json& plan) {
    std::vector<StageOutcome> outcomes;
    for (json& stage : plan.at("stages")) {
        const std::filesystem::path numbers = run / "studies" / stage.at("study").get<std::string>() /
                                              stage.at("stage").get<std::string>() / "stage.json";
        if (!is_priced(stage) || !std::filesystem::exists(numbers)) {
            continue;
        }
        const json taken = record::read_json(numbers);
        record::take_from(numbers, [&] {
            stage["steps_taken"] = taken.value("steps_of_trials", taken.at("steps").get<std::int64_t>());
            stage["seconds_taken"] = taken.at("wall_seconds").get<double>();
        });
        outcomes.push_back(
            {range_of(stage.at("steps")), range_of(stage.at("seconds")), stage.at("steps_taken"),
             stage.at("seconds_taken")}
        );
    }
    return outcomes;
}

} // namespace

void keep_plan(const std::filesystem::path& run, const RunPlan& plan) {
    json kept = plan;
    if (std::filesystem::exists(run / plan_file)) {
        const json earlier = record::read_json(run / plan_file);
        record::take_from(run / plan_file, [&] { keep_priced(kept, earlier); });
    }
    record::write_json(run / plan_file, kept);
}

std::optional<PlanError> measure_plan_error(const std::vector<StageOutcome>& outcomes) {
    PlanError found;
    std::vector<double> steps, seconds;
    std::vector<Range> planned;
    for (const StageOutcome& stage : outcomes) {
        if (stage.steps > 0) {
            steps.push_back(error_of(stage.planned_steps, stage.steps));
        }
        if (stage.seconds < least_timed) {
            continue;
        }
        seconds.push_back(error_of(stage.planned_seconds, stage.seconds));
        planned.push_back(stage.planned_seconds);
        found.seconds += stage.seconds;
    }
    if (seconds.empty()) {
        return std::nullopt;
    }
    found.stages = static_cast<int>(seconds.size());
    found.of_steps = steps.empty() ? 0 : quantile(std::move(steps), 0.5); // a flow makes none
    found.of_seconds = quantile(std::move(seconds), 0.5);
    found.planned_seconds = sum_ranges(planned); // as the plan itself sums them
    found.of_all_seconds = error_of(found.planned_seconds, found.seconds);
    return found;
}

std::optional<PlanError> record_outcome(const std::filesystem::path& run) {
    if (!std::filesystem::exists(run / plan_file)) {
        return std::nullopt;
    }
    json plan = record::read_json(run / plan_file);
    const std::vector<StageOutcome> outcomes =
        record::take_from(run / plan_file, [&] { return record_stages(run, plan); });
    const std::optional<PlanError> error = measure_plan_error(outcomes);
    if (error) {
        plan["error"] = {
            {"stages", error->stages},
            {"median_of_steps", error->of_steps},
            {"median_of_seconds", error->of_seconds},
            {"seconds_planned", {error->planned_seconds.least, error->planned_seconds.most}},
            {"seconds_taken", error->seconds},
            {"of_all_seconds", error->of_all_seconds}};
    }
    record::write_json(run / plan_file, plan);
    return error;
}

} // namespace suffuse::plan
