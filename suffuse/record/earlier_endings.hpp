#pragma once
// Files of earlier versions, without `ended`, state why an erosion stopped in a sentence alone.

#include "suffuse/erosion/ending.hpp"

#include <string>

namespace suffuse::record {

/// The ending that the sentence of such a file shows, with its rounded numbers; else OtherWording.
erosion::Ending ending_of_sentence(const std::string& sentence);

} // namespace suffuse::record
