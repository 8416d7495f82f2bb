#pragma once
// Factors of safety of several samples.

#include "suffuse/base/factor_of_safety.hpp"
#include "suffuse/study/study_curves.hpp"

#include <string>

namespace suffuse::study {

/// "1.5 ± 0.2"; "–" where no seed has it.
std::string factor_text(const Scatter& factor);

} // namespace suffuse::study
