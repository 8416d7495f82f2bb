#pragma once
// Why an erosion stops, in files: null where it goes on, else `why` by name, with its numbers.

#include "suffuse/erosion/ending.hpp"

#include <nlohmann/json_fwd.hpp>

namespace suffuse::erosion {

void to_json(nlohmann::json& json, const Ending& ending);

/// A `why` that this version does not know is OtherWording, without its words.
void from_json(const nlohmann::json& json, Ending& ending);

} // namespace suffuse::erosion
