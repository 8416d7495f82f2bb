#pragma once
// Where a run is, for people: a few lines redrawn at most ten times a second on a terminal, one of them for each sample
// that runs; elsewhere one line at each stage's end and every half minute; nothing when quiet.

#include "apps/time_left.hpp"
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace suffuse::apps {

struct Screen {
    bool redraws = false; ///< lines can be redrawn
    bool utf8 = false;    ///< block characters may be used
    bool quiet = false;
    std::function<std::size_t()> width;            ///< [columns]
    std::function<void(const std::string&)> write; ///< to standard error
};

/// Where each sample that runs was seen last, by its number.
using Running = std::map<int, run::Progress>;

/// The lines of a redrawn screen, none wider than `width`.
/// @param latest whose counts are of the whole run
/// @param hint how to stop and go on
std::vector<std::string> progress_lines(
    const run::Progress& latest, const Running& running, const Range& left, const std::string& hint, std::size_t width,
    bool utf8
);

/// The one line of a piped run at the end of a stage, or of a sample that failed.
std::string progress_line(const run::Progress& progress, const Range& left);

/// The one line of a piped run between the ends of stages.
std::string progress_line(const run::Progress& latest, const Running& running, const Range& left);

/// "e 0.671  p 99.8 kPa": the numbers of a state that are worth showing.
std::string state_text(const nlohmann::json& state);

class ProgressView {
public:
    ProgressView(Screen screen, plan::RunPlan plan, std::string hint)
        : screen_(std::move(screen)), left_(std::move(plan)), hint_(std::move(hint)) {}

    void show(const run::Progress& progress);

    /// Something else was written to the terminal: what stands there is not redrawn.
    void begin_anew() { drawn_ = 0; }

    /// Takes the lines off the terminal.
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    void redraw(const run::Progress& latest);
    void report(const run::Progress& latest);

    Screen screen_;
    TimeLeft left_;
    Running running_;
    std::string hint_;
    Clock::time_point shown_{};
    std::size_t drawn_ = 0; ///< lines on the terminal
};

} // namespace suffuse::apps
