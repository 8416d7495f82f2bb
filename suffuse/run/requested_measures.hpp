#pragma once
// The key `measure` of a stage: what was asked for, gathered in one place of stage.json. Most groups pick from what the
// stage tells anyway; permeability, constrictions and grading are measured on its end state for the asking.

#include "suffuse/run/stage_work.hpp"

namespace suffuse::run {

/// Group -> numbers, for the groups that the stage was asked for; null for what this sample has not. What could not be
/// measured is null too, and the stage is warned. @param numbers of stage.json
nlohmann::json requested_measures(StageWork& work, const nlohmann::json& numbers);

} // namespace suffuse::run
