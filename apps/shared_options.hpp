#pragma once
// Options that several verbs have, and what they mean.

#include "suffuse/base/vec3.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/io/packing_export.hpp"
#include "suffuse/io/run_tree.hpp"
#include "suffuse/record/stage_cache.hpp"

#include "apps/console.hpp"
#include "apps/options.hpp"
#include <filesystem>
#include <optional>
#include <string>

namespace suffuse::apps {

inline constexpr const char* case_text = "the case file, or the folder of a case.toml";
inline constexpr const char* folder_text = "the folder of a run";
inline constexpr const char* packing_text =
    "grains: a table of Yade, PFC, EDEM or MFIX, CSV, LAMMPS data or dump, XYZ, VTK and others";

/// What is changed of a case.
struct CaseChanges : casefile::LoadOptions {
    void add_to(Options& options);
};

/// The case file that is meant: of a folder its case.toml. @throws UsageError for the folder of a run.
std::string case_in(const std::string& given);

/// The case with its changes made; prints its warnings.
casefile::Case load_given_case(const std::string& file, const CaseChanges& changes, const Console& console);

struct ThreadOption {
    int requested = 0; ///< 0: all cores

    void add_to(Options& options);
    /// Sets the number of threads.
    void apply() const;
};

struct CacheOptions {
    std::string folder;
    bool is_off = false;
    bool is_shared = false;

    void add_to(Options& options);

    [[nodiscard]] record::Owners owners() const { return is_shared ? record::Owners::Anybody : record::Owners::Self; }

    [[nodiscard]] bool is_requested() const { return is_off || !folder.empty(); }

    /// What is requested, or `usual` where nothing is; empty: no cache.
    [[nodiscard]] std::filesystem::path folder_or(const std::filesystem::path& usual) const;
};

/// The cache of a run that goes on: what is requested, else suffuse-cache next to the run. Its folder, which may be
/// from someone else, chooses none unless the user trusts it; what the earlier call had is printed.
std::filesystem::path cache_to_go_on(
    const CacheOptions& requested, const std::filesystem::path& run, bool is_trusted, const Console& console
);

/// Looks at a run folder before any of it is opened (io/run_tree.hpp), and warns of files of other users.
void look_at_run(const std::filesystem::path& run, io::Purpose purpose, const Console& console);

/// [s], without end where the text is empty. @throws UsageError where it is no time to work in
double time_of(const std::string& text, const std::string& flag);

/// The same of --time-limit.
double time_limit_of(const std::string& text);

/// How far a run goes.
struct RunLimits {
    std::string until;      ///< stage
    std::string time_limit; ///< with its unit

    void add_to(Options& options);

    /// [s], without end unless specified. @throws UsageError where it is no time.
    [[nodiscard]] double seconds() const { return time_limit_of(time_limit); }
};

/// How much memory a run may take.
struct MemoryOption {
    std::string requested;

    void add_to(Options& options);
    /// [B], a share of the machine's unless specified. @throws UsageError where it is no amount.
    [[nodiscard]] double bytes() const;
};

void add_until(Options& options, std::string& stage);

/// The cell of a packing.
struct CellOption {
    std::string edges;

    void add_to(Options& options);
    [[nodiscard]] std::optional<Mat3> matrix() const;
};

/// A file that grains are written to.
struct PackingOutput {
    std::string file, format;

    void add_to(Options& options);
    /// As specified, or by the file's ending. @throws UsageError.
    [[nodiscard]] io::PackingFormat chosen_format() const;
};

} // namespace suffuse::apps
