#include "suffuse/run/runner.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/missing_stages.hpp"
#include "suffuse/record/refine.hpp"
#include "suffuse/run/preparation_found.hpp"
#include "suffuse/run/sample_run.hpp"

#include <algorithm>
#include <functional>
#include <new>
#include <set>
#include <span>

namespace suffuse::run {
namespace {

/// The samples of a run side by side; what is finished lies in the folder.
class Runner {
public:
    Runner(const casefile::Case& what, const RunOptions& options, Overview& overview)
        : listed_(what), what_(record::with_refinements(what, options.folder)), options_(options),
          samples_(record::list_samples(what_, options.until, options.sample)), overview_(overview) {
        overview_.add(stages_of(samples_), static_cast<int>(samples_.size()));
    }

    bool run() {
        run_samples();
        if (options_.sample.empty()) {
            refine();
        }
        return !interrupted_;
    }

private:
    /// Runs what the results so far require.
    void refine() {
        const std::vector<record::Refinement> found =
            interrupted_ ? std::vector<record::Refinement>{} : record::find_refinements(what_, options_.folder);
        if (found.empty()) {
            return;
        }
        record::keep_refinements(options_.folder, found);
        for (const record::Refinement& one : found) {
            overview_.log({{"event", "refined"}, {"study", one.study}, {"reason", one.reason}});
        }
        std::set<std::string> known;
        for (const record::Sample& sample : samples_) {
            known.insert(sample.variant->folder);
        }
        what_ = record::with_refinements(listed_, options_.folder);
        samples_ = record::list_samples(what_, options_.until);
        std::erase_if(samples_, [&](const record::Sample& sample) { return known.contains(sample.variant->folder); });
        overview_.add(stages_of(samples_), static_cast<int>(samples_.size()));
        run_samples();
    }

    static int stages_of(const std::vector<record::Sample>& samples) {
        int stages = 0;
        for (const record::Sample& sample : samples) {
            stages += sample.stages;
        }
        return stages;
    }

    /// Those that are complete take no time, and no thread from the others.
    void run_samples() {
        std::vector<record::Sample> left;
        for (const record::Sample& sample : samples_) {
            if (record::is_complete(sample, options_.folder)) {
                run_sample(sample);
            } else {
                left.push_back(sample);
            }
        }
        // The longest first: the last to end keeps fewest threads waiting.
        std::ranges::stable_sort(left, std::greater{}, [](const record::Sample& s) {
            return s.stages * s.variant->particles;
        });
        const bool is_alone = !options_.sample.empty(); // it makes for itself what it would wait for
        const auto first_waiting = std::stable_partition(left.begin(), left.end(), [&](const record::Sample& sample) {
            return is_alone || !waits_for_another(sample, options_.folder);
        });
        run_together({left.begin(), first_waiting});
        run_together({first_waiting, left.end()});
    }

    void run_together(std::span<const record::Sample> samples) {
        const int at_once = options_.at_once > 0 ? options_.at_once : thread_count();
        run_side_by_side(samples.size(), at_once, [&](std::size_t k) { run_sample(samples[k]); });
    }

    void run_sample(const record::Sample& sample) {
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
            fail(
                run, "memory",
                "out of memory; suffuse plan CASE shows how much a case needs, --memory (memory= in Python) limits "
                "what a "
                "run may use"
            );
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
            record::keep_failure(options_.folder, {last.study, last.stage, kind, message});
        } catch (...) { // no place for any sample's results
            overview_.break_off();
            throw;
        }
        last.failure = message;
        overview_.end_sample(std::move(last));
    }

    const casefile::Case& listed_; ///< as specified
    casefile::Case what_;          ///< with what was refined
    const RunOptions& options_;
    std::vector<record::Sample> samples_;
    Overview& overview_;
    std::atomic<bool> interrupted_{false};
};

} // namespace

bool run_samples(const casefile::Case& what, const RunOptions& options, Overview& overview) {
    return Runner(what, options, overview).run();
}

} // namespace suffuse::run
