// watch: a run followed from another terminal, through what its folder holds; or, when it is over, how it went.

#include "suffuse/base/error.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/job/calibration_files.hpp"
#include "suffuse/job/calibration_folder.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/record/folder.hpp"

#include <fmt/format.h>

#include "apps/event_log.hpp"
#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/progress_file.hpp"
#include "apps/shared_options.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <thread>
#include <unistd.h>
#include <vector>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds look_interval{250};
constexpr std::chrono::seconds silence{3}; // without news, the lock is looked at: a killed run says no goodbye

struct WatchVerb final : Verb {
    WatchVerb()
        : Verb("watch", "follow a run from another terminal, or show how it ended", "suffuse watch runs/dyke-0001") {}

    std::string run;

    void add_to(Options& options) override { options.argument("DIR", run, folder_text).required(); }

    [[nodiscard]] int act(const CommandLine&, const Console& console) const override;
};

/// The lines below the events, where they can be redrawn.
class Footer {
public:
    explicit Footer(bool redraws) : redraws_(redraws) {}

    void draw(const Published& published) {
        if (!redraws_) {
            return;
        }
        clear();
        for (const std::string& line : progress_lines(
                 published.latest, published.running, published.left, "Ctrl-C ends the watch, not the run",
                 terminal_width(), supports_utf8()
             )) {
            write(line + "\n");
            ++lines_;
        }
    }

    void clear() {
        if (lines_ > 0) {
            write(fmt::format("\x1b[{}A\r\x1b[J", lines_));
        }
        lines_ = 0;
    }

private:
    static void write(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stderr); }

    bool redraws_;
    std::size_t lines_ = 0;
};

class Watch {
public:
    /// @param locked the folder whose lock shows that it is at work: its own, or that of a calibration
    Watch(fs::path folder, fs::path locked, const Console& console)
        : folder_(std::move(folder)), locked_(std::move(locked)), console_(console), events_(folder_),
          footer_(can_redraw() && !console.is_quiet() && !console.wants_json()) {}

    /// @return the events, all of them, once the run is over or nobody works on it.
    nlohmann::json follow() {
        for (;;) {
            const bool news = print_events() || print_progress();
            if (is_over_ || has_lost_reader(STDOUT_FILENO)) {
                break;
            }
            if (news) {
                last_news_ = Clock::now();
            } else if (is_first_ || Clock::now() - last_news_ > silence) {
                if (!job::is_at_work(locked_)) {
                    print_events(); // what it said between the look and its end
                    break;
                }
                last_news_ = Clock::now();
            }
            is_first_ = false;
            std::this_thread::sleep_for(look_interval);
        }
        footer_.clear();
        return shown_events_;
    }

    [[nodiscard]] bool is_over() const { return is_over_; }

    /// Whether the run saved itself and would go on.
    [[nodiscard]] bool is_resumable() const {
        return outcome_ == record::word_of(record::Outcome::Stopped) ||
               outcome_ == record::word_of(record::Outcome::TimeLimit);
    }

    /// The command that goes on with it.
    [[nodiscard]] std::string resume_command() const {
        return task_.empty() ? "suffuse resume " + shell_word(folder_.string()) : task_;
    }

private:
    bool print_events() {
        const std::vector<nlohmann::json> fresh = events_.read_new();
        for (const nlohmann::json& event : fresh) {
            footer_.clear();
            console_.result(event_line(event));
            const std::string what = event.value("event", "");
            is_over_ = what == "run ends" || what == "sample ends"; // unless it was taken up again
            if (what == "sample begins") {
                task_ = event.value("command", "");
            }
            outcome_ = is_over_ ? event.value("outcome", "") : "";
            shown_events_.push_back(event);
        }
        std::fflush(stdout);
        return !fresh.empty();
    }

    bool print_progress() {
        std::error_code error;
        const auto written = fs::last_write_time(folder_ / progress_file, error);
        if (error || written == seen_) {
            return false;
        }
        seen_ = written;
        if (const auto published = read_progress(folder_)) {
            footer_.draw(*published);
        }
        return true;
    }

    fs::path folder_, locked_;
    const Console& console_;
    EventLog events_;
    Footer footer_;
    nlohmann::json shown_events_ = nlohmann::json::array();
    fs::file_time_type seen_{};
    Clock::time_point last_news_ = Clock::now();
    bool is_over_ = false, is_first_ = true;
    std::string outcome_; ///< of a run that is over
    std::string task_;    ///< command of a sample of a sweep that is a task of its own; empty: a run
};

/// Its rounds, one after the other, as long as somebody works on it.
int watch_calibration(const fs::path& folder, const Console& console) {
    nlohmann::json rounds = nlohmann::json::array();
    bool goes_on = true;
    for (std::size_t k = 0; goes_on && !has_lost_reader(STDOUT_FILENO);) {
        goes_on = job::is_at_work(folder); // before the look: the last round is not missed
        const std::vector<fs::path> begun = job::rounds_of(folder);
        if (k == begun.size()) {
            std::this_thread::sleep_for(look_interval);
            continue;
        }
        console.result(begun[k].filename().string());
        Watch watch(begun[k], folder, console);
        rounds.push_back({{"round", begun[k].filename().string()}, {"events", watch.follow()}});
        goes_on = true;
        ++k;
    }
    const fs::path answer = folder / job::calibration_file;
    const bool is_complete = fs::exists(answer) && record::read_json(answer).value("complete", false);
    const std::string report = is_complete ? (folder / "report.html").string() : "";
    console.result(is_complete ? report : "resume with: suffuse resume " + shell_word(folder.string()));
    console.document(json_text({{"ended", is_complete}, {"report", report}, {"rounds", rounds}}));
    return is_complete ? Done : Failed;
}

int WatchVerb::act(const CommandLine&, const Console& console) const {
    const fs::path folder = run;
    look_at_run(folder, io::Purpose::Read, console);
    if (job::is_calibration(folder)) {
        return watch_calibration(folder, console);
    }
    if (!fs::exists(folder / "events.jsonl") && fs::exists(folder / "tasks.txt")) {
        throw UsageError(fmt::format(
            "{0} holds tasks of a sweep, each a run of its own: suffuse watch {1}, or suffuse sweep --collect {0}",
            shell_word(run), shell_word((folder / "studies" / "STUDY" / "SAMPLE").string())
        ));
    }
    if (!fs::exists(folder / "events.jsonl") && !job::is_at_work(folder)) {
        throw IoError(fmt::format(
            "{} holds no run that has begun; give suffuse watch the folder that suffuse run printed", shown(run)
        ));
    }
    Watch watch(folder, folder, console);
    const nlohmann::json events = watch.follow();
    if (has_lost_reader(STDOUT_FILENO)) {
        return Done; // nobody wants to know more
    }
    const fs::path report = folder / "report.html";
    const bool has_report = watch.is_over() && !watch.is_resumable() && fs::exists(report);
    if (watch.is_resumable()) {
        console.result(fmt::format("resume with: {}", watch.resume_command()));
    } else if (has_report) {
        console.result(report.string());
    } else if (!watch.is_over()) {
        console.result(fmt::format(
            "nobody works on this run and it has not ended: it was killed; go on with {}", watch.resume_command()
        ));
    }
    console.document(
        json_text({{"ended", watch.is_over()}, {"report", has_report ? report.string() : ""}, {"events", events}})
    );
    return watch.is_over() ? Done : Failed;
}

} // namespace

MadeVerb make_watch_verb() {
    return std::make_unique<WatchVerb>();
}

} // namespace suffuse::apps
