#include "suffuse/plan/requested_stages.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/record/samples.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

namespace suffuse::plan {
namespace {

using Names = std::set<std::pair<std::string, std::string>>; // sample and stage

Names requested_names(const casefile::Case& what, const std::string& until, const std::string& only) {
    Names requested;
    for (const record::Sample& sample : record::list_samples(what, until)) {
        const bool is_requested = only.empty() || sample.variant->folder == only;
        for (int row = 0; is_requested && row < sample.stages; ++row) {
            requested.emplace(sample.variant->folder, sample.variant->stages[static_cast<std::size_t>(row)].name);
        }
    }
    return requested;
}

} // namespace

void check_until(const casefile::Case& what, const std::string& until) {
    if (until.empty()) {
        return;
    }
    std::vector<std::string> names;
    for (const casefile::Study& study : what.studies) {
        for (const casefile::Stage& stage : study.stages) {
            names.push_back(stage.name);
        }
    }
    if (std::find(names.begin(), names.end(), until) == names.end()) {
        throw UsageError(fmt::format(
            "--until {}: the case has no such stage{}; there are {}", shown(until), near_hint(until, names),
            fmt::join(names, ", ")
        ));
    }
}

void price_requested_alone(
    RunPlan& plan, const casefile::Case& what, const std::string& until, const std::string& only
) {
    const Names requested = requested_names(what, until, only);
    for (StageEstimate& stage : plan.stages) {
        if (!requested.contains({stage.study, stage.stage})) {
            stage.steps = stage.seconds = {};
            stage.memory = stage.disk = 0;
        }
    }
    plan.refined = only.empty() ? price_refined(plan, what) : RefinedEstimate{}; // the run that gathers refines
}

void keep_requested_alone(
    RunPlan& plan, const casefile::Case& what, const std::string& until, const std::string& only
) {
    const Names requested = requested_names(what, until, only);
    std::erase_if(plan.stages, [&](const StageEstimate& stage) {
        return !requested.contains({stage.study, stage.stage});
    });
}

} // namespace suffuse::plan
