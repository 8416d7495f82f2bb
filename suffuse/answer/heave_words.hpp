#pragma once
// Gradients beyond the one at which seepage lifts the soil as a whole.

#include "suffuse/study/run_results.hpp"

#include <optional>
#include <string>

namespace suffuse::answer {

/// "Flow at i = 1.2 is above the gradient that lifts the soil as a whole, 0.95 ...": of the one that exceeds heave
/// most. Without weight a flow has no upward, and the sentence has a condition. Nothing where none exceeds it.
std::optional<std::string> doubt_of_heave(const study::RunResults& results);

} // namespace suffuse::answer
