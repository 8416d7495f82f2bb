#pragma once
// The figures of a sweep and of triaxial tests: Figures 1 to 6 of the paper, where a study sweeps the fines content of
// its soil, and our own.

#include "suffuse/report/page.hpp"
#include "suffuse/run/fines_sweep.hpp"

#include <filesystem>
#include <vector>

namespace suffuse::run {

/// @param sweep null where no study sweeps the fines content
std::vector<report::Figure> draw_study(
    const casefile::Case& what, const std::filesystem::path& folder, const std::vector<FinishedStage>& stages,
    const FinesSweep* sweep
);

} // namespace suffuse::run
