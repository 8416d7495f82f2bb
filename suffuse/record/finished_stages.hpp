#pragma once
// Whether the stages that a run has finished are as they ended: nothing goes on from a damaged one, and nothing is
// reported from it.

#include "suffuse/record/sums.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::record {

struct StagesCheck {
    int stages = 0;
    std::vector<std::string> without;             ///< stages that an earlier version left without checksums
    std::vector<std::string> unchecked;           ///< those of them that the run's do not cover either
    std::vector<Damage> damages;                  ///< of files below the run folder
    std::vector<std::filesystem::path> to_remove; ///< folders of damaged stages
};

/// Every file of every finished stage against the checksums of its stage; of a stage that has none, against those that
/// the run got when it ended, if it has.
/// @param sample the folder below studies/ of the one to look at; empty: all
StagesCheck
check_stages(const std::filesystem::path& run, const std::string& sample = {}, const ChecksumOf& now = checksum_of);

/// Names of the finished stages that no checksums cover, once the others are known to be whole.
/// @throws IoError that names what is damaged, and what to do
std::vector<std::string> require_whole_stages(const std::filesystem::path& run, const std::string& sample = {});

/// The same of a whole run folder: also of the files that say what to compute.
std::vector<std::string> require_whole_run(const std::filesystem::path& run, const std::string& sample = {});

/// Of these stages, in words; empty where there is none.
std::string tell_unchecked(const std::vector<std::string>& stages);

} // namespace suffuse::record
