#include "suffuse/run/erosion_story.hpp"

#include <algorithm>

namespace suffuse::run {
namespace {

/// An erosion of which something can be told: of a sample that has fines, or that lost some by force.
bool has_fines(const FinishedStage& stage) {
    return std::ranges::any_of(stage.findings.erosion->passes, [](const erosion::PassResult& pass) {
        return !pass.probe.id.empty() || pass.removed > 0;
    });
}

/// The first erosion that has fines, or else the first.
const FinishedStage* find_eroded(const std::vector<FinishedStage>& stages) {
    const FinishedStage* first = nullptr;
    for (const FinishedStage& stage : stages) {
        if (stage.findings.erosion && has_fines(stage)) {
            return &stage;
        }
        if (stage.findings.erosion && first == nullptr) {
            first = &stage;
        }
    }
    return first;
}

bool probes_fines(const FinishedStage& stage) {
    return !stage.findings.probes.empty() && !stage.findings.probes.front().id.empty();
}

} // namespace

ErosionStory find_story(const std::vector<FinishedStage>& stages) {
    ErosionStory story;
    story.eroded = find_eroded(stages);
    if (story.eroded != nullptr) {
        story.erosion = *story.eroded->findings.erosion;
    }
    for (const FinishedStage& stage : stages) {
        if (story.eroded != nullptr && &stage != story.eroded && stage.findings.erosion &&
            stage.variant == story.eroded->variant) {
            story.others.push_back(&stage);
        }
    }
    const auto probed = std::ranges::find_if(stages, [&](const FinishedStage& stage) {
        return probes_fines(stage) && (story.eroded == nullptr || stage.study == story.eroded->study);
    });
    if (probed != stages.end()) {
        story.probes = probed->findings.probes;
        const auto* spec = std::get_if<erosion::DetachStageSpec>(&probed->stage->spec);
        story.probed_by = spec == nullptr ? erosion::DetachSpec{} : spec->detached;
    }
    return story;
}

} // namespace suffuse::run
