#include "suffuse/run/runner.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/run/checksums.hpp"
#include "suffuse/run/ended_run.hpp"
#include "suffuse/run/finished_stages.hpp"
#include "suffuse/run/folder.hpp"
#include "suffuse/run/refine.hpp"
#include "suffuse/run/sample_run.hpp"
#include "suffuse/run/summary.hpp"

#include <algorithm>
#include <functional>
#include <new>
#include <set>

namespace suffuse::run {
namespace {

/// The samples of a run side by side; what is finished lies in the folder.
class Runner {
public:
    Runner(const casefile::Case& what, const RunOptions& options, const std::vector<std::string>& unchecked)
        : listed_(what), what_(with_refinements(what, options.folder)), options_(options),
          samples_(asked_samples(what_, options)),
          overview_(options, stages_of(samples_), static_cast<int>(samples_.size())) {
        if (!unchecked.empty()) {
            overview_.remark(tell_unchecked(unchecked));
        }
    }

    RunReport run() {
        if (!options_.sample.empty()) {
            return run_one();
        }
        overview_.tell({{"event", "run begins"}, {"command", options_.command}});
        run_samples();
        refine();
        RunReport report;
        if (!interrupted_) { // a stop is not kept waiting, and signs nothing
            require_whole_stages(options_.folder);
        }
        const Sums earlier = read_run_sums(options_.folder);
        std::filesystem::remove(options_.folder / checksums_file); // true no more
        keep_provenance(options_.folder, what_, options_, overview_.run_seconds());
        const Summary summary = summarize_run(what_, options_.folder, options_.page_folder);
        report.report = summary.report;
        report.warnings = summary.warnings;
        report.flaws = summary.flaws;
        report.findings = summary.findings;
        report.failures = summary.failures;
        report.outcome = outcome(report);
        report.remarks = overview_.remarks();
        if (!is_resumable(report.outcome)) {
            write_run_sums(options_.folder, summary.figures, earlier);
        }
        overview_.tell(
            {{"event", "run ends"}, {"outcome", word_of(report.outcome)}, {"wall_seconds", overview_.run_seconds()}}
        );
        return report;
    }

private:
    static std::vector<Sample> asked_samples(const casefile::Case& what, const RunOptions& options) {
        std::vector<Sample> samples = list_samples(what, options.until);
        if (!options.sample.empty()) {
            std::erase_if(samples, [&](const Sample& s) { return s.variant->folder != options.sample; });
        }
        return samples;
    }

    /// One sample, beside other programs that run the others: what concerns the whole run is left to who gathers.
    RunReport run_one() {
        const std::filesystem::path folder = options_.folder / "studies" / options_.sample;
        std::filesystem::create_directories(folder);
        if (std::filesystem::exists(folder / provenance_file) && has_all()) {
            return {}; // done before
        }
        overview_.tell({{"event", "sample begins"}, {"command", options_.command}});
        run_samples();
        keep_provenance(folder, what_, options_, overview_.run_seconds());
        RunReport report;
        report.remarks = overview_.remarks();
        for (FailedSample& failure : read_failures(options_.folder, what_)) {
            if (failure.sample == options_.sample) {
                report.failures.push_back(std::move(failure));
            }
        }
        report.outcome = outcome(report);
        overview_.tell(
            {{"event", "sample ends"}, {"outcome", word_of(report.outcome)}, {"wall_seconds", overview_.run_seconds()}}
        );
        return report;
    }

    [[nodiscard]] bool has_all() const {
        return std::ranges::all_of(samples_, [&](const Sample& sample) {
            return is_complete(sample, options_.folder);
        });
    }

    /// Runs what the results so far ask for.
    void refine() {
        const std::vector<Refinement> found =
            interrupted_ ? std::vector<Refinement>{} : find_refinements(what_, options_.folder);
        if (found.empty()) {
            return;
        }
        keep_refinements(options_.folder, found);
        for (const Refinement& one : found) {
            overview_.tell({{"event", "refined"}, {"study", one.study}, {"reason", one.reason}});
        }
        std::set<std::string> known;
        for (const Sample& sample : samples_) {
            known.insert(sample.variant->folder);
        }
        what_ = with_refinements(listed_, options_.folder);
        samples_ = list_samples(what_, options_.until);
        std::erase_if(samples_, [&](const Sample& sample) { return known.contains(sample.variant->folder); });
        overview_.add(stages_of(samples_), static_cast<int>(samples_.size()));
        run_samples();
    }

    static int stages_of(const std::vector<Sample>& samples) {
        int stages = 0;
        for (const Sample& sample : samples) {
            stages += sample.stages;
        }
        return stages;
    }

    /// Those that are complete take no time, and no thread from the others.
    void run_samples() {
        std::vector<Sample> left;
        for (const Sample& sample : samples_) {
            if (is_complete(sample, options_.folder)) {
                run_sample(sample);
            } else {
                left.push_back(sample);
            }
        }
        // The longest first: the last to end keeps fewest threads waiting.
        std::ranges::stable_sort(left, std::greater{}, [](const Sample& s) { return s.stages * s.variant->particles; });
        run_side_by_side(left.size(), thread_count(), [&](std::size_t k) { run_sample(left[k]); });
    }

    void run_sample(const Sample& sample) {
        if (overview_.should_stop()) {
            interrupted_ = true;
            return;
        }
        SampleRun run(what_, options_, sample, overview_);
        try {
            run.run();
            overview_.end_sample(run.place());
        } catch (const Interrupted&) {
            interrupted_ = true;
        } catch (const CaseError& error) {
            fail(run, "case", error.what());
        } catch (const IoError& error) {
            fail(run, "io", error.what());
        } catch (const std::filesystem::filesystem_error& error) {
            fail(run, "io", error.what());
        } catch (const Error& error) {
            fail(run, "run", error.what());
        } catch (const std::bad_alloc&) {
            fail(run, "memory", "out of memory; suffuse plan CASE tells how much a case needs");
        } catch (...) {
            overview_.break_off();
            throw;
        }
    }

    void fail(const SampleRun& run, const std::string& kind, const std::string& message) {
        Progress last = run.place();
        if (std::filesystem::exists(options_.folder / "studies" / last.study / last.stage / "stage.json")) {
            overview_.break_off(); // the stage is complete: it is who listens to the run that failed
            throw;
        }
        try {
            keep_failure(options_.folder, {last.study, last.stage, kind, message});
        } catch (...) { // no place for any sample's results
            overview_.break_off();
            throw;
        }
        last.failure = message;
        overview_.end_sample(std::move(last));
    }

    [[nodiscard]] Outcome outcome(const RunReport& report) const {
        if (interrupted_) {
            return overview_.out_of_time() ? Outcome::TimeLimit : Outcome::Stopped;
        }
        if (!report.failures.empty()) {
            return Outcome::SomeFailed;
        }
        return report.flaws.empty() ? Outcome::Done : Outcome::DoneWithFlaws;
    }

    const casefile::Case& listed_; ///< as asked
    casefile::Case what_;          ///< with what was refined
    const RunOptions& options_;
    std::vector<Sample> samples_;
    Overview overview_;
    std::atomic<bool> interrupted_{false};
};

} // namespace

RunReport run_case(const casefile::Case& what, const RunOptions& options) {
    open_folder(options.folder, what, options.case_text);
    std::vector<std::string> unchecked;
    if (!options.is_checked) {
        unchecked = require_whole_run(options.folder, options.sample);
        if (std::optional<RunReport> ended = find_ended(what, options)) {
            return std::move(*ended);
        }
    }
    return Runner(what, options, unchecked).run();
}

} // namespace suffuse::run
