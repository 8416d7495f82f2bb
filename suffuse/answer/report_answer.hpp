#pragma once
// What a run found, in sentences with its numbers: the head of the report.

#include "suffuse/study/run_results.hpp"

#include <string>
#include <vector>

namespace suffuse::answer {

/// Of an erosion, and of tests outside sweeps: about five sentences, from the numbers of the stages.
std::vector<std::string> answer_of_erosion(const study::RunResults& results);

} // namespace suffuse::answer
