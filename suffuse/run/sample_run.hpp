#pragma once
// One sample from its first stage to its last, on the thread that calls: what is finished lies in the run folder.

#include "suffuse/record/samples.hpp"
#include "suffuse/record/stage_cache.hpp"
#include "suffuse/run/control.hpp"
#include "suffuse/run/stage_work.hpp"

#include <filesystem>
#include <string>

namespace suffuse::run {

class SampleRun {
public:
    SampleRun(const casefile::Case& what, const RunOptions& options, const record::Sample& sample, Overview& overview)
        : what_(what), options_(options), sample_(sample), overview_(overview),
          control_(overview, what.output.checkpoint), cache_(options.cache, options.cache_owners) {}

    /// Runs the stages that the folder does not hold yet. @throws Interrupted on request; the errors of the
    /// stage that failed, which `stage()` then names.
    void run();

    /// Name of the stage that runs, or ran last.
    [[nodiscard]] std::string stage() const { return stage_ == nullptr ? "" : stage_->name; }

    /// What to show of this sample, before its numbers are known.
    [[nodiscard]] Progress place() const;

private:
    void run_stage(const casefile::Stage& next_stage);
    /// With which a stage was requested; null: none.
    [[nodiscard]] const erosion::OwnRule* own_rule_of(const casefile::Stage& stage) const;
    bool take_from_cache(
        const casefile::Stage& stage, const std::filesystem::path& folder, const std::string& key,
        const std::string& stage_key
    );
    void keep_in_cache(const casefile::Stage& stage, const std::filesystem::path& folder, const std::string& key);
    [[nodiscard]] StageWork begin_work(
        const casefile::Stage& stage, const std::filesystem::path& folder, dem::World start, std::string start_state,
        std::string key
    );
    [[nodiscard]] dem::World start_of(const casefile::Stage& stage) const;
    void finish(StageWork& work);
    void log(const std::string& event, const casefile::Stage& stage, nlohmann::json more = {}) const;

    const casefile::Case& what_;
    const RunOptions& options_;
    const record::Sample& sample_;
    Overview& overview_;
    Control control_;
    record::StageCache cache_;
    const casefile::Stage* stage_ = nullptr;
};

} // namespace suffuse::run
