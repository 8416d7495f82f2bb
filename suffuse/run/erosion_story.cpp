#include "suffuse/run/erosion_story.hpp"

namespace suffuse::run {

ErosionStory find_story(const std::vector<FinishedStage>& stages) {
    ErosionStory story;
    for (const FinishedStage& stage : stages) {
        if (story.eroded == nullptr && stage.findings.erosion) {
            story.eroded = &stage;
            story.erosion = *stage.findings.erosion;
        } else if (stage.findings.erosion && stage.variant == story.eroded->variant) {
            story.others.push_back(&stage);
        }
    }
    for (const FinishedStage& stage : stages) {
        if (story.eroded != nullptr && stage.study != story.eroded->study) {
            continue;
        }
        if (story.probes.empty() && !stage.findings.probes.empty()) {
            story.probes = stage.findings.probes;
            const auto* spec = std::get_if<erosion::DetachStageSpec>(&stage.stage->spec);
            story.probed_by = spec == nullptr ? erosion::DetachSpec{} : spec->detached;
        }
    }
    return story;
}

} // namespace suffuse::run
