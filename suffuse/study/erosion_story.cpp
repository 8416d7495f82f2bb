#include "suffuse/study/erosion_story.hpp"

#include "suffuse/study/joined_passes.hpp"

#include <algorithm>

namespace suffuse::study {
namespace {

/// An erosion with something to report: of a sample that has fines, or that lost some by force.
bool has_fines(const record::FinishedStage& stage) {
    return std::ranges::any_of(stage.findings.erosion->passes, [](const erosion::PassResult& pass) {
        return !pass.probe.id.empty() || pass.mobility || pass.removed > 0;
    });
}

bool probes_fines(const record::FinishedStage& stage) {
    return !stage.findings.probes.empty() && !stage.findings.probes.front().id.empty();
}

/// The nearest erosion that the stage's sample comes from, over stages of other verbs; null where there is none.
const casefile::Stage* erosion_before(const record::FinishedStage& stage) {
    const std::vector<casefile::Stage>& all = stage.variant->stages;
    for (int row = stage.stage->parent; row >= 0; row = all[static_cast<std::size_t>(row)].parent) {
        const casefile::Stage& earlier = all[static_cast<std::size_t>(row)];
        if (std::holds_alternative<erosion::ErodeSpec>(earlier.spec)) {
            return &earlier;
        }
    }
    return nullptr;
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

Erosions find_chain(const std::vector<record::FinishedStage>& stages, const record::FinishedStage* eroded) {
    Erosions chain;
    while (eroded != nullptr) {
        chain.push_back(eroded);
        const auto next = std::ranges::find_if(stages, [&](const record::FinishedStage& stage) {
            return stage.findings.erosion && erosion_before(stage) == eroded->stage;
        });
        eroded = next == stages.end() ? nullptr : &*next;
    }
    return chain;
}

Erosions chain_to(const std::vector<record::FinishedStage>& stages, const record::FinishedStage& last) {
    Erosions chain{&last};
    while (const casefile::Stage* const before = erosion_before(*chain.front())) {
        const auto found = std::ranges::find_if(stages, [&](const record::FinishedStage& stage) {
            return stage.stage == before && stage.findings.erosion;
        });
        if (found == stages.end()) {
            break;
        }
        chain.insert(chain.begin(), &*found);
    }
    return chain;
}

erosion::ErosionResult passes_of(const Erosions& chain) {
    std::vector<const erosion::ErosionResult*> parts;
    for (const record::FinishedStage* stage : chain) {
        parts.push_back(&*stage->findings.erosion);
    }
    return join_passes(parts);
}

ErosionStory find_story(const std::vector<record::FinishedStage>& stages) {
    ErosionStory story;
    story.eroded = find_eroded(stages, [](const record::FinishedStage&) { return true; });
    story.chain = find_chain(stages, story.eroded);
    story.erosion = passes_of(story.chain);
    for (const record::FinishedStage* part : story.chain) {
        const auto passes = static_cast<int>(part->findings.erosion->passes.size());
        for (int pass = 1; pass <= passes; ++pass) {
            story.made_in.push_back({part, pass, pass == passes});
        }
    }
    for (const record::FinishedStage& stage : stages) {
        if (story.eroded != nullptr && stage.findings.erosion && stage.variant == story.eroded->variant &&
            std::ranges::find(story.chain, &stage) == story.chain.end()) {
            story.others.push_back(&stage);
        }
    }
    const record::FinishedStage* const probed = find_probed(stages, [&](const record::FinishedStage& stage) {
        return story.eroded == nullptr || stage.study == story.eroded->study;
    });
    story.probed = probed;
    if (probed != nullptr) {
        story.probes = probed->findings.probes;
        const auto* spec = std::get_if<erosion::DetachStageSpec>(&probed->stage->spec);
        story.probed_by = spec == nullptr ? erosion::DetachSpec{} : spec->detached;
    }
    return story;
}

} // namespace suffuse::study
