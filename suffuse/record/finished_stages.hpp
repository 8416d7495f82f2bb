#pragma once
// Whether the stages that a run has finished are as they ended: nothing goes on from a damaged one, and nothing is
// reported from it.

#include "suffuse/casefile/case.hpp"
#include "suffuse/record/sums.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::record {

struct StagesCheck {
    int stages = 0;
    std::vector<std::string> without;             ///< stages that an earlier version left without checksums
    std::vector<std::string> unchecked;           ///< those of them that the run's do not cover either
    std::vector<std::string> unverified;          ///< stages without a key of this form: perhaps of another case
    bool is_of_other_case = false;                ///< some are whole, and not of the case
    std::vector<Damage> damages;                  ///< of files below the run folder
    std::vector<std::filesystem::path> to_remove; ///< folders of damaged stages
};

/// Every file of every finished stage against the checksums of its stage; of a stage that has none, against those that
/// the run got when it ended, if it has. Then the key of each stage against that of the case.
/// @param what the case of the run, with what was refined; null where it cannot be read: no key is compared
/// @param sample the folder below studies/ of the one to look at; empty: all
StagesCheck check_stages(
    const std::filesystem::path& run, const casefile::Case* what, const std::string& sample = {},
    const ChecksumOf& now = checksum_of
);

/// That the finished stages are whole, and of the run's case.
/// @return what could not be checked, because an earlier version left it, in words; empty where all was
/// @throws IoError that names what is damaged or of another case, and what to do
std::string require_whole_stages(const std::filesystem::path& run, const std::string& sample = {});

/// The same of a whole run folder: also of the files that say what to compute.
std::string require_whole_run(const std::filesystem::path& run, const std::string& sample = {});

/// That the packings which the finished stages read are as they were then. @throws CaseError that names one that is not
void require_same_imports(const casefile::Case& what, const std::filesystem::path& run, const std::string& sample = {});

} // namespace suffuse::record
