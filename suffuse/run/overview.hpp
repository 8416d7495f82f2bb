#pragma once
// What the samples of a run share while they run side by side: when the run began, whether it should stop, how many
// stages are done, and the one line that shows progress. Every function may be called by any thread.

#include "suffuse/base/stopwatch.hpp"
#include "suffuse/run/run_options.hpp"

#include <atomic>
#include <mutex>

namespace suffuse::run {

class Overview {
public:
    explicit Overview(const RunOptions& options) : options_(options) {}

    /// Hands `progress` on with the counts of the whole run; one call at a time.
    void show(Progress progress);

    /// Whether progress of a stage is due, so long after the last report [s].
    [[nodiscard]] bool is_interested(double seconds) const {
        return options_.on_progress && seconds > options_.progress_interval;
    }

    /// Appends to the events of the run; a sample that is run alone has its own.
    void log(nlohmann::json event) const;

    /// A remark for the user at the end of the run.
    void remark(std::string text);

    /// Stages whose results the cache did not take: one remark for all of them, in the words of the first.
    void remark_not_cached(const std::string& why);

    [[nodiscard]] const std::vector<std::string>& remarks() const { return remarks_; }

    /// What is to be run; later, what `refine` adds to it.
    void add(int stages, int samples) {
        stages_ += stages;
        samples_ += samples;
    }

    void count_stage() { ++stages_done_; }

    void end_sample(Progress last);

    /// Every sample saves and stops at its next burst: something is broken that is no sample's own failure.
    void break_off() { broken_ = true; }

    [[nodiscard]] bool should_stop() const {
        return broken_ || (options_.stop != nullptr && options_.stop->load()) || out_of_time();
    }

    [[nodiscard]] bool out_of_time() const { return run_seconds() > options_.time_limit; }

    [[nodiscard]] double run_seconds() const { return since_start_.seconds(); }

private:
    const RunOptions& options_;
    std::atomic<int> stages_{0}, samples_{0};
    Stopwatch since_start_;
    std::atomic<int> stages_done_{0}, samples_done_{0}, samples_failed_{0};
    std::atomic<bool> broken_{false};
    std::vector<std::string> remarks_;
    bool has_reported_cache_ = false;
    std::mutex mutex_;
};

} // namespace suffuse::run
