#pragma once
// The key `measure` of a stage: what was requested, gathered in one place of stage.json. Most groups pick from what the
// stage shows anyway; permeability, constrictions and grading are measured on its end state only on request.

#include "suffuse/run/stage_work.hpp"

namespace suffuse::run {

/// Group -> numbers, for the groups requested of the stage; null for what this sample has not. What could not be
/// measured is null too, and the stage is warned. @param numbers of stage.json
nlohmann::json requested_measures(StageWork& work, const nlohmann::json& numbers);

} // namespace suffuse::run
