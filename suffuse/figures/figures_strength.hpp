#pragma once
// Ours: the same test before fines went and after, laid over each other.

#include "suffuse/figures/figure.hpp"
#include "suffuse/study/strength_change.hpp"

#include <optional>
#include <vector>

namespace suffuse::figures {

/// The first change that a number can express; nothing where there is none, or where their curves were not kept.
std::optional<Figure> strength_before_and_after(
    const std::vector<study::StrengthChange>& changes, const std::vector<record::FinishedStage>& stages
);

} // namespace suffuse::figures
