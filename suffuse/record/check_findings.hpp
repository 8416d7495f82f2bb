#pragma once
// What figures and tables take for granted of what a stage found, and a file may not hold.

#include "suffuse/record/finished_stage.hpp"

#include <string>

namespace suffuse::record {

/// What is missing, in words; empty: nothing. Columns of a table have a row a grain, throat class or constriction each;
/// those that earlier versions did not write may be empty.
std::string what_is_missing(const StageFindings& findings);

} // namespace suffuse::record
