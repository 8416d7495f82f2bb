#pragma once
// Where a run is, published in progress.json of its folder for `watch` and for scripts: written about once a second
// under another name and renamed, so that a reader never sees half of it. A convenience: a full disk does not stop a
// run for it.

#include "suffuse/run/run_options.hpp"

#include "apps/terminal.hpp"
#include <chrono>
#include <filesystem>
#include <optional>

namespace suffuse::apps {

inline constexpr const char* progress_file = "progress.json";

/// What the file says.
struct Published {
    run::Progress latest; ///< whose counts are of the whole run
    Running running;      ///< each sample that runs
    Range left;           ///< [s]
};

class ProgressFile {
public:
    ProgressFile(const std::filesystem::path& folder, plan::RunPlan plan)
        : path_(folder / progress_file), left_(std::move(plan)) {}

    void show(const run::Progress& progress);

private:
    void write(const run::Progress& latest) const;

    std::filesystem::path path_;
    TimeLeft left_;
    Running running_;
    std::chrono::steady_clock::time_point written_{};
};

/// What was published last; nothing where there is none, or it cannot be understood.
std::optional<Published> read_progress(const std::filesystem::path& folder);

} // namespace suffuse::apps
