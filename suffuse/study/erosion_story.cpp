#include "suffuse/study/erosion_story.hpp"

#include <algorithm>

namespace suffuse::study {
namespace {

/// An erosion of which something can be told: of a sample that has fines, or that lost some by force.
bool has_fines(const record::FinishedStage& stage) {
    return std::ranges::any_of(stage.findings.erosion->passes, [](const erosion::PassResult& pass) {
        return !pass.probe.id.empty() || pass.removed > 0;
    });
}

bool probes_fines(const record::FinishedStage& stage) {
    return !stage.findings.probes.empty() && !stage.findings.probes.front().id.empty();
}

} // namespace

const record::FinishedStage* find_eroded(const std::vector<record::FinishedStage>& stages, const Belongs& belongs) {
    const record::FinishedStage* first = nullptr;
    for (const record::FinishedStage& stage : stages) {
        if (!stage.findings.erosion || !belongs(stage)) {
            continue;
        }
        if (has_fines(stage)) {
            return &stage;
        }
        first = first == nullptr ? &stage : first;
    }
    return first;
}

const record::FinishedStage* find_probed(const std::vector<record::FinishedStage>& stages, const Belongs& belongs) {
    const auto probed = std::ranges::find_if(stages, [&](const record::FinishedStage& stage) {
        return probes_fines(stage) && belongs(stage);
    });
    return probed == stages.end() ? nullptr : &*probed;
}

ErosionStory find_story(const std::vector<record::FinishedStage>& stages) {
    ErosionStory story;
    story.eroded = find_eroded(stages, [](const record::FinishedStage&) { return true; });
    if (story.eroded != nullptr) {
        story.erosion = *story.eroded->findings.erosion;
    }
    for (const record::FinishedStage& stage : stages) {
        if (story.eroded != nullptr && &stage != story.eroded && stage.findings.erosion &&
            stage.variant == story.eroded->variant) {
            story.others.push_back(&stage);
        }
    }
    const record::FinishedStage* const probed = find_probed(stages, [&](const record::FinishedStage& stage) {
        return story.eroded == nullptr || stage.study == story.eroded->study;
    });
    if (probed != nullptr) {
        story.probes = probed->findings.probes;
        const auto* spec = std::get_if<erosion::DetachStageSpec>(&probed->stage->spec);
        story.probed_by = spec == nullptr ? erosion::DetachSpec{} : spec->detached;
    }
    return story;
}

} // namespace suffuse::study
