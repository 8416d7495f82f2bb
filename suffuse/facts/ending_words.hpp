#pragma once
// Why an erosion stops, as warnings, the report and the sentence in files state it.

#include "suffuse/erosion/ending.hpp"

#include <string>

namespace suffuse::facts {

/// "nothing leaves any more"; empty where the procedure goes on.
std::string words_of(const erosion::Ending& ending);

} // namespace suffuse::facts
