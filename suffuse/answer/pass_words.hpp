#pragma once
// Passes of an erosion in sentences.

#include "suffuse/erosion/result.hpp"

#include <cstdint>
#include <string>

namespace suffuse::answer {

/// "1 fine grain", "1,261 fines".
std::string fines_text(std::int64_t count);

/// A sentence a pass, or one for all but the first; empty without a pass.
std::string answer_to_erosion(const erosion::ErosionResult& erosion);

/// What it means where almost no grain that left carried load: another gradient would have taken the same.
std::string describe_idle(const erosion::ErosionResult& erosion);

} // namespace suffuse::answer
