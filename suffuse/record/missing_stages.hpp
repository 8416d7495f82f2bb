#pragma once
// What a run folder lacks: of a run that was interrupted, that failed in part, that was to end early, or that is under
// way.

#include "suffuse/casefile/case.hpp"
#include "suffuse/record/samples.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::record {

struct MissingStages {
    std::vector<std::string> names; ///< "STUDY/SAMPLE/STAGE", in the order of the case
    std::size_t of = 0;             ///< stages of the whole case
};

MissingStages find_missing_stages(const casefile::Case& what, const std::filesystem::path& run);

/// Whether the folder holds every stage that the sample is to run.
bool is_complete(const Sample& sample, const std::filesystem::path& run);

/// "3 of 7 stages are missing: a/x, a/y, a/z"; of many the first few. Empty where none is.
std::string describe_missing(const MissingStages& missing);

} // namespace suffuse::record
