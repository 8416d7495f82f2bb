#pragma once
// What the report tells of an erosion: the first stage that eroded a sample with fines, with the probes of its study,
// and the other erosions of that sample.

#include "suffuse/run/finished_stage.hpp"

#include <functional>
#include <vector>

namespace suffuse::run {

struct ErosionStory {
    const FinishedStage* eroded = nullptr; ///< null where nothing was eroded
    std::vector<erosion::ProbeResult> probes;
    erosion::DetachSpec probed_by; ///< the rule that their stage asks for
    erosion::ErosionResult erosion;
    std::vector<const FinishedStage*> others; ///< from other states of the same sample
};

using Belongs = std::function<bool(const FinishedStage&)>;

/// The first erosion, of those that belong, of a sample that has fines, or else the first; null where there is none.
const FinishedStage* find_eroded(const std::vector<FinishedStage>& stages, const Belongs& belongs);

/// The first stage, of those that belong, that probed a sample with fines; null where there is none.
const FinishedStage* find_probed(const std::vector<FinishedStage>& stages, const Belongs& belongs);

ErosionStory find_story(const std::vector<FinishedStage>& stages);

} // namespace suffuse::run
