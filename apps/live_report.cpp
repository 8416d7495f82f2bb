#include "apps/live_report.hpp"

#include "suffuse/base/amounts.hpp"
#include "suffuse/io/atomic_file.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "apps/wording.hpp"
#include <algorithm>
#include <ctime>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_rows = 60; ///< beyond, of those done the last and of those waiting the first

std::string now_text() {
    return fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(std::time(nullptr)));
}

} // namespace

LiveReport::LiveReport(
    fs::path folder, std::string title, std::string command, const plan::RunPlan& plan,
    std::chrono::milliseconds interval
)
    : folder_(std::move(folder)), title_(title.empty() ? "A run without a title" : std::move(title)),
      command_(std::move(command)), left_(plan), interval_(interval) {
    for (const plan::StageEstimate& stage : plan.stages) {
        if (stage.is_cached) {
            stages_.push_back({stage.study, stage.stage, stage.verb, "done", "earlier", ""});
        } else if (stage.seconds.most > 0) { // the others are not requested
            stages_.push_back(
                {stage.study, stage.stage, stage.verb, "waits", duration_range_text(stage.seconds) + " by the plan", ""}
            );
        }
    }
    all_ = static_cast<int>(stages_.size());
    write("");
}

LiveReport::Stage& LiveReport::stage_of(const run::Progress& progress) {
    const auto found = std::find_if(stages_.begin(), stages_.end(), [&](const Stage& stage) {
        return stage.study == progress.study && stage.stage == progress.stage;
    });
    if (found != stages_.end()) {
        return *found;
    }
    return stages_.emplace_back(Stage{progress.study, progress.stage, progress.verb, "", "", ""}
    ); // requested by results
}

void LiveReport::learn(const run::Progress& progress) {
    left_.see(progress);
    done_ = progress.stages_done;
    all_ = progress.stages;
    const bool has_no_stage = progress.sample_ended && progress.failure.empty(); // they have reported themselves
    if (progress.stage.empty() || has_no_stage) {
        return;
    }
    Stage& stage = stage_of(progress);
    stage.status = !progress.failure.empty() ? "failed" : progress.stage_finished ? "done" : "running";
    stage.is_done = progress.failure.empty() && progress.stage_finished;
    stage.time = progress.from_cache ? "from the cache" : duration_text(progress.stage_seconds);
    stage.state = progress.failure.empty() ? state_text(progress.state) : progress.failure;
}

void LiveReport::show(const run::Progress& progress) {
    learn(progress);
    const auto now = std::chrono::steady_clock::now();
    if (now - written_ >= interval_) {
        written_ = now;
        write("");
    }
}

void LiveReport::close(const std::string& ending) {
    write(ending);
}

void LiveReport::write(const std::string& ending) const {
    report::LivePage page;
    page.title = title_;
    page.run = folder_.filename().string();
    page.at = now_text();
    page.share = all_ > 0 ? static_cast<double>(done_) / all_ : 0;
    page.progress = fmt::format("{} of {}", done_, plural(all_, "stage"));
    page.left = duration_range_text(left_.left());
    page.ending = ending;
    page.command = command_;
    std::ptrdiff_t spare = std::ssize(stages_) - static_cast<std::ptrdiff_t>(most_rows);
    for (const Stage& stage : stages_) {
        if (spare > 0 && stage.is_done) {
            --spare;
        } else if (page.rows.size() < most_rows) {
            page.rows.push_back({stage.study + "/" + stage.stage, stage.verb, stage.status, stage.time, stage.state});
        }
    }
    io::show_file(folder_ / "report.html", report::render_live_page(page)); // what cannot be shown stops no run
}

} // namespace suffuse::apps
