#pragma once
// An entry of the cache: the folder of a finished stage, entry.json, which says in words what it depends on, and
// SHA256SUMS of both, so that nothing is taken from a damaged one.

#include "suffuse/base/error.hpp"
#include "suffuse/record/sums.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace suffuse::record {

struct CacheEntry {
    std::filesystem::path folder;
    std::string made_as;   ///< "STUDY/STAGE" of the run that made it
    std::string end_state; ///< of describe_state
    std::int64_t bytes = 0;
    double wall_seconds = 0; ///< that it took
};

struct WholeEntry {
    CacheEntry entry;
    std::string depends_on;
};

/// An entry that is not as it was kept.
struct DamagedEntry : IoError {
    using IoError::IoError;
};

/// Nothing where there is no entry, where its file is damaged, or where another program drops it just now.
std::optional<WholeEntry> read_entry(const std::filesystem::path& folder);

/// Checksums of the stage in an entry, once the entry's own file and stage.json are known to be as they were kept.
/// @throws DamagedEntry
Sums checked_sums(const std::filesystem::path& entry);

/// Copies files with these checksums, to the disk. @throws DamagedEntry where one is not what it was
void copy_checked(const std::filesystem::path& from, const std::filesystem::path& to, const Sums& sums);

/// Fills the folder of a new entry with a finished stage that has these checksums.
void fill_entry(
    const std::filesystem::path& entry, const std::filesystem::path& stage_folder, Sums sums, const std::string& key
);

} // namespace suffuse::record
