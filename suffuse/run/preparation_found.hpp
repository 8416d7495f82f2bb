#pragma once
// The preparation that the search of another sample has found, for a stage that is `prepared_as` it.

#include "suffuse/record/samples.hpp"
#include "suffuse/run/run_options.hpp"

namespace suffuse::run {

/// Whether a stage of this sample is prepared as one that the folder does not hold yet.
bool waits_for_another(const record::Sample& sample, const std::filesystem::path& folder);

/// The stage with what was found in place of what is specified; the same stage where it searches itself. A sample that
/// is run alone, before the one that it depends on, makes that one's stages for itself, through the cache.
/// @throws StateError where the other sample has failed
casefile::Stage with_preparation_found(
    const casefile::Case& what, const RunOptions& options, const record::Sample& sample, const casefile::Stage& stage
);

} // namespace suffuse::run
