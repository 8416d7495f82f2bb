#pragma once
// What the report tells of an erosion: the first sample that was eroded, with the probes of its study.

#include "suffuse/run/finished_stage.hpp"

#include <vector>

namespace suffuse::run {

struct ErosionStory {
    const FinishedStage* eroded = nullptr; ///< null where nothing was eroded
    std::vector<erosion::ProbeResult> probes;
    erosion::ErosionResult erosion;
};

ErosionStory find_story(const std::vector<FinishedStage>& stages);

} // namespace suffuse::run
