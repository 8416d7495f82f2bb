#include "apps/sweep_tasks.hpp"

#include "suffuse/record/missing_stages.hpp"
#include "suffuse/record/samples.hpp"

#include <map>

namespace suffuse::apps {
namespace {

/// Of each sample, beyond its steps: start, checks, files, report of its end [s].
constexpr Range sample_overhead{0.2, 2};

} // namespace

std::vector<Task> list_tasks(const casefile::Case& what, const std::filesystem::path& folder) {
    std::vector<Task> tasks;
    for (const record::Sample& sample : record::list_samples(what)) {
        if (!record::is_complete(sample, folder)) {
            tasks.push_back({{sample.variant->folder}, {}});
        }
    }
    return tasks;
}

void price_tasks(std::vector<Task>& tasks, const plan::RunPlan& plan) {
    std::map<std::string, Range> of_sample;
    for (const plan::StageEstimate& stage : plan.stages) {
        of_sample[stage.study] += stage.seconds;
    }
    for (Task& task : tasks) {
        task.seconds = {};
        for (const std::string& sample : task.samples) {
            task.seconds += of_sample[sample] + sample_overhead;
        }
    }
}

std::vector<Task> pack_tasks(const std::vector<Task>& tasks, double seconds) {
    std::vector<Task> packed;
    for (const Task& task : tasks) {
        const bool has_room = !packed.empty() && middle(packed.back().seconds + task.seconds) <= seconds;
        if (!has_room) {
            packed.push_back(task);
            continue;
        }
        packed.back().samples.insert(packed.back().samples.end(), task.samples.begin(), task.samples.end());
        packed.back().seconds += task.seconds;
    }
    return packed;
}

} // namespace suffuse::apps
