#include "suffuse/run/overview.hpp"

#include "suffuse/record/folder.hpp"

#include <fmt/format.h>

#include <utility>

namespace suffuse::run {

void Overview::show(Progress progress) {
    if (!options_.on_progress) {
        return;
    }
    const std::lock_guard lock(mutex_);
    progress.stages = stages_;
    progress.samples = samples_;
    progress.stages_done = stages_done_;
    progress.samples_done = samples_done_;
    progress.samples_failed = samples_failed_;
    progress.run_seconds = run_seconds();
    options_.on_progress(progress);
}

void Overview::log(nlohmann::json event) const {
    record::log_event(
        options_.sample.empty() ? options_.folder : options_.folder / "studies" / options_.sample, std::move(event)
    );
}

void Overview::remark(std::string text) {
    const std::lock_guard lock(mutex_);
    remarks_.push_back(std::move(text));
}

void Overview::remark_not_cached(const std::string& why) {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(has_reported_cache_, true)) {
        remarks_.push_back(fmt::format(
            "stages are not stored in the cache, so another run will compute them again: {}; this run is not affected",
            why
        ));
    }
}

void Overview::end_sample(Progress last) {
    ++(last.failure.empty() ? samples_done_ : samples_failed_);
    last.sample_ended = true;
    show(std::move(last));
}

} // namespace suffuse::run
