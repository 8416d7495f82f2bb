#pragma once
// Problems of the samples that a calibration makes, at the lines of the case that asks for them.

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/casefile/calibration_case.hpp"

#include <string>
#include <vector>

namespace suffuse::casefile {

/// @param problems of the case of some samples @param text that case @param what the case that calibrates
/// @return each of them once: at its key where the user wrote that key, else at the unknown or the target it comes from
std::vector<Diagnostic>
at_users_places(const std::vector<Diagnostic>& problems, const std::string& text, const CalibrationCase& what);

} // namespace suffuse::casefile
