#pragma once
// What triaxial tests found, in sentences, where the comparison of strength before and after does not contain it.

#include "suffuse/record/finished_stage.hpp"
#include "suffuse/study/strength_change.hpp"

#include <string>
#include <vector>

namespace suffuse::answer {

/// Of tests, over their seeds: those of strength in one sentence, each that holds the deviator stress in one of its
/// own. Tests among `changes` have their sentence there; of a sweep, where they are few.
std::vector<std::string>
describe_tests(const std::vector<record::FinishedStage>& stages, const std::vector<study::StrengthChange>& changes);

} // namespace suffuse::answer
