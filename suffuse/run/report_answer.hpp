#pragma once
// What a run found, in sentences with its numbers: the head of the report.

#include "suffuse/run/erosion_story.hpp"
#include "suffuse/run/fines_sweep.hpp"
#include "suffuse/run/strength_change.hpp"

#include <string>
#include <vector>

namespace suffuse::run {

/// Of an erosion, and of tests outside sweeps: about five sentences, from the numbers of the stages.
std::vector<std::string> answer_of_erosion(
    const ErosionStory& story, const std::vector<FinishedStage>& stages, const std::vector<StrengthChange>& strength
);

/// Of a study over the fines content: about five.
std::vector<std::string> answer_of_fines(const FinesSweep& sweep);

} // namespace suffuse::run
