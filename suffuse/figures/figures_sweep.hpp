#pragma once
// Ours: the result of a study over the swept key: the mean, one deviation to both sides, every sample a dot.

#include "suffuse/figures/figure.hpp"
#include "suffuse/study/study_outcome.hpp"

#include <optional>
#include <vector>

namespace suffuse::figures {

/// The main result over the first swept key, a line for each value of the others; nothing without a sweep or a result.
std::optional<Figure> sweep_result(const study::StudyOutcome& outcome);

/// The other results that the sweep changes, small, side by side over one axis; nothing where there is none.
std::optional<Figure> sweep_multiples(const study::StudyOutcome& outcome);

} // namespace suffuse::figures
