#pragma once
// What the report tells of an erosion: the first stage that eroded a sample with fines, with the probes of its study,
// and the other erosions of that sample.

#include "suffuse/run/finished_stage.hpp"

#include <vector>

namespace suffuse::run {

struct ErosionStory {
    const FinishedStage* eroded = nullptr; ///< null where nothing was eroded
    std::vector<erosion::ProbeResult> probes;
    erosion::DetachSpec probed_by; ///< the rule that their stage asks for
    erosion::ErosionResult erosion;
    std::vector<const FinishedStage*> others; ///< from other states of the same sample
};

ErosionStory find_story(const std::vector<FinishedStage>& stages);

} // namespace suffuse::run
