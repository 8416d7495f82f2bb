// What a plan need not compute: what the run folder holds, and what the cache holds.

#include "suffuse/plan/plan.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/refine.hpp"
#include "suffuse/record/samples.hpp"
#include "suffuse/record/stored.hpp"

namespace suffuse::plan {
namespace {

/// State at the end of a stage that the folder or the cache holds; nothing where the stage is still to be computed.
std::optional<std::string> known_end(
    StageEstimate& estimate, const casefile::Case& what, const casefile::Variant& variant, const casefile::Stage& stage,
    const std::optional<std::string>& start, const std::filesystem::path& folder, const record::StageCache& cache
) {
    const std::filesystem::path numbers = record::stage_folder(folder, variant, stage) / "stage.json";
    if (!folder.empty() && std::filesystem::exists(numbers)) {
        estimate.is_done = true;
        estimate.disk = 0;
        const nlohmann::json stored = record::read_json(numbers);
        return record::take_from(numbers, [&] {
            return stored.value("end_state", "");
        }); // none: made before there was a cache
    }
    if (start && record::StageCache::keeps(stage)) {
        if (const auto entry = cache.find(record::StageCache::key_of(what, variant, stage, *start))) {
            estimate.is_cached = true;
            return entry->end_state;
        }
    }
    return std::nullopt;
}

} // namespace

void leave_out_done(
    RunPlan& plan, const casefile::Case& what, const std::filesystem::path& folder, const record::StageCache& cache
) {
    for (const record::Sample& sample : record::list_samples(what)) {
        const casefile::Variant& variant = *sample.variant;
        std::vector<std::optional<std::string>> ends(variant.stages.size());
        for (std::size_t k = 0; k < variant.stages.size(); ++k) {
            const casefile::Stage& stage = variant.stages[k];
            const auto start = stage.parent >= 0 ? ends[static_cast<std::size_t>(stage.parent)] : std::optional("");
            StageEstimate& estimate = plan.stages.at(static_cast<std::size_t>(sample.first_stage) - 1 + k);
            ends[k] = known_end(estimate, what, variant, stage, start, folder, cache);
            if (estimate.is_done || estimate.is_cached) {
                estimate.steps = estimate.seconds = {};
                estimate.memory = 0;
            }
        }
    }
    if (record::is_refined(folder)) {
        plan.refined = {}; // those samples stand among the others
    }
    sum_up(plan);
}

} // namespace suffuse::plan
