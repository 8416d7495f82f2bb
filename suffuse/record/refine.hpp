#pragma once
// The samples that `refine` adds to a study when the values of its sweep have been run. They are worked out from the
// results that lie in the run folder and kept in refinement.json, so that every reader of the folder knows them.

#include "suffuse/casefile/case.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace suffuse::record {

/// One set of sweep values that is added.
struct Refinement {
    std::string study;
    std::map<std::string, casefile::Scalar> values; ///< of every swept key
    std::string reason;                             ///< "void_ratio of loose is lowest at fines_content = 30 %"
};

/// What `refine` requires; nothing for a study some of whose samples are not there.
std::vector<Refinement> find_refinements(const casefile::Case& what, const std::filesystem::path& run);

/// Whether they require samples that the case has not.
bool add_samples(const casefile::Case& what, const std::vector<Refinement>& refinements);

void keep_refinements(const std::filesystem::path& run, const std::vector<Refinement>& refinements);

/// Whether samples were added to the run.
bool is_refined(const std::filesystem::path& run);

/// The case with the samples that refinement.json of the run adds; as it is where there is none.
casefile::Case with_refinements(casefile::Case what, const std::filesystem::path& run);

/// The case of a run folder, with what was refined. @throws IoError where there is no run.
casefile::Case load_run(const std::filesystem::path& run);

} // namespace suffuse::record
