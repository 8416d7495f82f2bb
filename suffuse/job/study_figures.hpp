#pragma once
// The figures of a sweep and of triaxial tests: Figures 1 to 6 of the paper, where a study sweeps the fines content of
// its soil, and our own.

#include "suffuse/figures/figure.hpp"
#include "suffuse/study/run_results.hpp"

#include <filesystem>
#include <vector>

namespace suffuse::job {

/// @param folder of the run
std::vector<figures::Figure> draw_study(const study::RunResults& results, const std::filesystem::path& folder);

} // namespace suffuse::job
