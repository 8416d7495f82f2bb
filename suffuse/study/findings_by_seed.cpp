#include "suffuse/study/findings_by_seed.hpp"

#include "suffuse/study/erosion_story.hpp"

#include <algorithm>

namespace suffuse::study {
namespace {

/// The sample that tells the story: the first that was eroded, or else the first that was probed.
const record::FinishedStage* find_first(const std::vector<record::FinishedStage>& stages) {
    const auto any = [](const record::FinishedStage&) { return true; };
    const record::FinishedStage* const eroded = find_eroded(stages, any);
    return eroded != nullptr ? eroded : find_probed(stages, any);
}

/// The first probes of the stages that belong, and their first erosion with those that follow it.
std::vector<Finding> judge(const std::vector<record::FinishedStage>& stages, const Belongs& belongs) {
    const record::FinishedStage* const probed = find_probed(stages, belongs);
    const record::FinishedStage* const eroded = find_eroded(stages, belongs);
    return judge_erosion(
        probed != nullptr ? probed->findings.probes : std::vector<erosion::ProbeResult>{},
        passes_of(find_chain(stages, eroded))
    );
}

} // namespace

std::vector<Finding> judge_erosion_by_seed(const std::vector<record::FinishedStage>& stages) {
    const record::FinishedStage* const first = find_first(stages);
    if (first == nullptr) {
        return {};
    }
    if (first->study->replicates == 1) { // probes may stand in another sample of the sweep
        return judge(stages, [&](const record::FinishedStage& stage) { return stage.study == first->study; });
    }
    std::vector<std::vector<Finding>> by_seed;
    for (const casefile::Variant& variant : first->study->variants) {
        const bool is_there = std::any_of(stages.begin(), stages.end(), [&](const record::FinishedStage& stage) {
            return stage.variant == &variant && (stage.findings.erosion || !stage.findings.probes.empty());
        });
        if (is_there && variant.values == first->variant->values) {
            by_seed.push_back(judge(stages, [&](const record::FinishedStage& stage) {
                return stage.variant == &variant;
            }));
        }
    }
    return combine_seeds(by_seed);
}

} // namespace suffuse::study
