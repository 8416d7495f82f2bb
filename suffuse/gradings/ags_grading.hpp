#pragma once
// Gradings out of an AGS 4 file, the format in which site investigations are exchanged in Britain: the group GRAT has a
// row for each sieve, of as many samples as there are.

#include "suffuse/gradings/grading_rows.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace suffuse::gradings {

/// Whether the text begins as an AGS file does, of version 4 or older.
bool looks_like_ags(std::string_view text);

/// The soils of the group GRAT, named by location and depth. Empty where something is wrong, all of which is reported.
std::optional<std::vector<SievedSoil>> read_ags(const std::shared_ptr<const Source>& source, Problems& problems);

} // namespace suffuse::gradings
