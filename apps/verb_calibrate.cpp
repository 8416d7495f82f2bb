// calibrate: parameters whose samples reproduce the tests of a laboratory.

#include "suffuse/casefile/calibration_case.hpp"
#include "suffuse/job/calibrate.hpp"
#include "suffuse/job/calibration_folder.hpp"
#include "suffuse/job/run_folder.hpp"

#include "apps/conduct_calibration.hpp"
#include "apps/shared_options.hpp"
#include "apps/stop_signal.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

struct CalibrateVerb final : Verb {
    CalibrateVerb()
        : Verb(
              "calibrate", "find the parameters that reproduce a laboratory's tests, with their intervals",
              "suffuse calibrate sand/case.toml --set calibrate.samples=32 -o runs/sand"
          ) {}

    std::string given; ///< a case, or the folder that holds one
    std::string output;
    std::string time_limit;
    bool is_plan = false; ///< only the price
    ThreadOption threads;
    std::vector<std::string> overrides;
    CacheOptions cache;
    MemoryOption memory;

    void add_to(Options& options) override {
        options.argument("CASE", given, case_text).required();
        threads.add_to(options);
        options
            .value(
                "-o,--output", output,
                "folder of the calibration; runs/NAME-0001 and so on unless given; one that "
                "was stopped continues"
            )
            .type("DIR");
        options.values("--set", overrides, "change a value of the case, as in calibrate.samples=32").type("KEY=VALUE");
        options.flag("--plan", is_plan, "only show what its samples cost");
        options.value("--time-limit", time_limit, "wall time after which it saves and stops, as in 2h").type("TIME");
        cache.add_to(options);
        memory.add_to(options);
    }

    [[nodiscard]] int act(const CommandLine& line, const Console& console) const override;
};

int CalibrateVerb::act(const CommandLine& line, const Console& console) const {
    CalibrationJob job{
        .case_file = case_in(given),
        .overrides = overrides,
        .folder = output,
        .cache = cache.folder_or(job::cache_next_to(output.empty() ? "runs/new" : output)),
        .cache_owners = cache.owners(),
        .time_limit = time_limit_of(time_limit),
        .memory = memory.bytes(),
        .command = line.typed};
    handle_signals();
    threads.apply();
    record::StageCache(job.cache).require_one();
    if (is_plan) {
        return price_calibration(job, console);
    }
    const casefile::CalibrationCase what = casefile::load_calibration(job.case_file, {{}, overrides, {}});
    job::first_round(what); // errors leave no folder
    if (output.empty()) {
        job.folder = job::make_run_folder(job.case_file);
    } else {
        job::take_run_folder(job.folder);
    }
    const job::FolderLock lock(job.folder, console.warner());
    job::keep_calibration_case(job.case_file, what, job.folder); // before a request of other settings is saved
    job::save_request(
        job.folder, {fs::absolute(job.case_file).string(),
                     "",
                     overrides,
                     {},
                     cache.is_requested() ? std::optional(job.cache.string()) : std::nullopt}
    );
    console.talk("into  " + job.folder.string());
    return conduct_calibration(job, console);
}

} // namespace

MadeVerb make_calibrate_verb() {
    return std::make_unique<CalibrateVerb>();
}

} // namespace suffuse::apps
