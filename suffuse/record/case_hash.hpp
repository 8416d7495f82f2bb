#pragma once
// What a run's provenance and its states name a case by.

#include "suffuse/casefile/case.hpp"

#include <string>

namespace suffuse::record {

/// Of the resolved case, as 16 hexadecimal digits.
std::string case_hash(const casefile::Case& what);

} // namespace suffuse::record
