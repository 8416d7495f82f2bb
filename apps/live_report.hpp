#pragma once
// report.html while the run is under way: a page that loads itself anew, written every few seconds under another name
// and renamed, until the report itself takes its place. A convenience: a full disk does not stop a run for it.

#include "suffuse/report/live_page.hpp"
#include "suffuse/run/run_options.hpp"

#include "apps/terminal.hpp"
#include <chrono>
#include <filesystem>
#include <map>
#include <string>

namespace suffuse::apps {

class LiveReport {
public:
    /// @param command with which the run goes on when it was stopped
    /// @param interval between two pages
    LiveReport(
        std::filesystem::path folder, std::string title, std::string command, const plan::RunPlan& plan,
        std::chrono::milliseconds interval = std::chrono::seconds(2)
    );

    void show(const run::Progress& progress);

    /// The last page, which does not change any more: where there is no report to take its place.
    void close(const std::string& ending);

private:
    struct Stage {
        std::string study, stage, verb, status, time, state;
        bool is_done = false;
    };

    void learn(const run::Progress& progress);
    void write(const std::string& ending) const;
    Stage& stage_of(const run::Progress& progress);

    std::filesystem::path folder_;
    std::string title_, command_;
    std::vector<Stage> stages_;
    TimeLeft left_;
    int done_ = 0, all_ = 0;
    std::chrono::milliseconds interval_;
    std::chrono::steady_clock::time_point written_{};
};

} // namespace suffuse::apps
