#pragma once
// Finished stages, kept by all that they depend on: the program, the stage with its settings, the seed, and the state
// that it starts from. A folder that people can look at, limit and delete: each entry is the folder of a stage and
// `entry.json`, which says in words what it depends on, with checksums of both. Several programs may use one cache at a
// time.

#include "suffuse/casefile/case.hpp"
#include "suffuse/dem/world.hpp"
#include "suffuse/record/cache_entry.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace suffuse::record {

/// Hash of everything that a later stage can take from a state: beyond the next step also the grains' class and mass,
/// the clock, and the order of the rows.
std::string describe_state(const dem::World& world);

/// Whose entries a cache takes. Checksums show accidents, not intent.
enum class Owners { Self, Anybody };

/// Whether the cache had a stage.
struct CacheAnswer {
    bool is_taken = false;
    std::string damage; ///< of the entry, which was dropped for it, in words; empty: there was none
};

class StageCache {
public:
    static constexpr std::int64_t usual_limit = 10'000'000'000; ///< [B]
    static constexpr const char* prices_file = "prices.txt";    ///< what past stages took, next to the entries

    /// An empty path is a cache that holds nothing and keeps nothing.
    /// @param owners Self: entries that another user made count as not there
    explicit StageCache(std::filesystem::path folder, Owners owners = Owners::Self)
        : folder_(std::move(folder)), owners_(owners) {}

    /// What the stage depends on, in words.
    /// @param start_state describe_state of the state that it starts from; empty where it makes its own
    [[nodiscard]] static std::string key_of(
        const casefile::Case& what, const casefile::Variant& variant, const casefile::Stage& stage,
        const std::string& start_state
    );

    /// Whether results of this stage are kept; reading a packing again costs no more than copying it.
    [[nodiscard]] static bool keeps(const casefile::Stage& stage);

    [[nodiscard]] std::optional<CacheEntry> find(const std::string& key) const;

    /// Completes a stage, under its own name, with the files of the entry. A damaged one is dropped, and nothing of it
    /// taken.
    /// @param stage_key key_of_stage: another case may have requested the same in other words
    [[nodiscard]] CacheAnswer take(
        const std::string& key, const casefile::Variant& variant, const casefile::Stage& stage,
        const std::filesystem::path& stage_folder, const std::string& stage_key
    ) const;

    /// Keeps a finished stage, then drops entries that were not used for the longest time until the limit is met.
    /// @throws IoError where the cache cannot be written; it is as before then.
    void keep(const std::string& key, const std::filesystem::path& stage_folder);

    /// All entries, those used last first.
    [[nodiscard]] std::vector<CacheEntry> entries() const;

    /// [B]
    [[nodiscard]] std::int64_t limit() const;
    void set_limit(std::int64_t bytes) const;

    /// Drops entries until the rest takes at most so many bytes, and what cannot be read; returns how many went.
    int shrink(std::int64_t bytes);

    /// Drops all entries and what programs that were killed have left; returns how many entries went. Whatever else
    /// lies in the folder stays.
    int clear();

    /// Whether the folder is a cache, for its cache.json says so, or may become one: it is empty.
    [[nodiscard]] bool is_one() const;

    /// @throws UsageError for a folder that holds something and is no cache
    void require_one() const;

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

private:
    [[nodiscard]] std::filesystem::path place_of(const std::string& key) const;
    [[nodiscard]] std::filesystem::path place_to_work() const;
    void drop(const std::filesystem::path& entry) const;
    int drop_leftovers(std::chrono::hours age);

    [[nodiscard]] bool may_take(const std::filesystem::path& entry) const;

    std::filesystem::path folder_;
    Owners owners_ = Owners::Self;
};

} // namespace suffuse::record
