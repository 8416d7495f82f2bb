#pragma once
// Why an erosion stops, as files, warnings and the report tell it, and read back from there.

#include "suffuse/erosion/ending.hpp"

#include <string>

namespace suffuse::record {

/// "nothing leaves any more"; empty where the procedure goes on.
std::string words_of(const erosion::Ending& ending);

/// The ending that these words describe: the inverse of words_of.
erosion::Ending ending_told(const std::string& words);

} // namespace suffuse::record
