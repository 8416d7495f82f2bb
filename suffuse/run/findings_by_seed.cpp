#include "suffuse/run/findings_by_seed.hpp"

#include <algorithm>

namespace suffuse::run {
namespace {

/// The sample that tells the story: the first that was eroded, or else the first that was probed.
const FinishedStage* find_first(const std::vector<FinishedStage>& stages) {
    const auto eroded =
        std::find_if(stages.begin(), stages.end(), [](const auto& s) { return s.findings.erosion.has_value(); });
    if (eroded != stages.end()) {
        return &*eroded;
    }
    const auto probed =
        std::find_if(stages.begin(), stages.end(), [](const auto& s) { return !s.findings.probes.empty(); });
    return probed == stages.end() ? nullptr : &*probed;
}

/// The first probes and the first erosion of the stages that `belongs` picks.
template <class Belongs>
std::vector<report::Finding> judge(const std::vector<FinishedStage>& stages, Belongs belongs) {
    std::vector<erosion::ProbeResult> probes;
    std::optional<erosion::ErosionResult> eroded;
    for (const FinishedStage& stage : stages) {
        if (!belongs(stage)) {
            continue;
        }
        if (probes.empty()) {
            probes = stage.findings.probes;
        }
        if (!eroded) {
            eroded = stage.findings.erosion;
        }
    }
    return report::judge_erosion(probes, eroded.value_or(erosion::ErosionResult{}));
}

} // namespace

std::vector<report::Finding> judge_erosion_by_seed(const std::vector<FinishedStage>& stages) {
    const FinishedStage* const first = find_first(stages);
    if (first == nullptr) {
        return {};
    }
    if (first->study->replicates == 1) { // probes may stand in another sample of the sweep
        return judge(stages, [&](const FinishedStage& stage) { return stage.study == first->study; });
    }
    std::vector<std::vector<report::Finding>> by_seed;
    for (const casefile::Variant& variant : first->study->variants) {
        const bool is_there = std::any_of(stages.begin(), stages.end(), [&](const FinishedStage& stage) {
            return stage.variant == &variant && (stage.findings.erosion || !stage.findings.probes.empty());
        });
        if (is_there && variant.values == first->variant->values) {
            by_seed.push_back(judge(stages, [&](const FinishedStage& stage) { return stage.variant == &variant; }));
        }
    }
    return report::combine_seeds(by_seed);
}

} // namespace suffuse::run
