#pragma once
// What the report tells of an erosion: the first stage that eroded a sample with fines, with the probes of its study,
// and the other erosions of that sample.

#include "suffuse/record/finished_stage.hpp"

#include <functional>
#include <vector>

namespace suffuse::study {

struct ErosionStory {
    const record::FinishedStage* eroded = nullptr; ///< null where nothing was eroded
    std::vector<erosion::ProbeResult> probes;
    erosion::DetachSpec probed_by; ///< the rule that their stage asks for
    erosion::ErosionResult erosion;
    std::vector<const record::FinishedStage*> others; ///< from other states of the same sample
};

using Belongs = std::function<bool(const record::FinishedStage&)>;

/// The first erosion, of those that belong, of a sample that has fines, or else the first; null where there is none.
const record::FinishedStage* find_eroded(const std::vector<record::FinishedStage>& stages, const Belongs& belongs);

/// The first stage, of those that belong, that probed a sample with fines; null where there is none.
const record::FinishedStage* find_probed(const std::vector<record::FinishedStage>& stages, const Belongs& belongs);

ErosionStory find_story(const std::vector<record::FinishedStage>& stages);

} // namespace suffuse::study
