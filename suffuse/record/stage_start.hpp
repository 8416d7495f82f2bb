#pragma once
// Whether a finished stage goes on from what the stage before it ended with. Where that one was removed and computed
// anew, perhaps by another version of the program, it may not.

#include "suffuse/casefile/case.hpp"

#include <filesystem>

namespace suffuse::record {

/// Nothing where one of the two is not finished, or an earlier version did not record it.
/// @throws IoError where they do not fit
void check_start(const casefile::Variant& variant, const casefile::Stage& stage, const std::filesystem::path& run);

} // namespace suffuse::record
