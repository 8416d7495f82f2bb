#include "suffuse/job/run_case.hpp"

#include "suffuse/base/read_text.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/folders.hpp"
#include "suffuse/job/ended_run.hpp"
#include "suffuse/job/summary.hpp"
#include "suffuse/record/checksums.hpp"
#include "suffuse/record/finished_stages.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/missing_stages.hpp"
#include "suffuse/record/refine.hpp"
#include "suffuse/record/stage_cache.hpp"
#include "suffuse/record/stored.hpp"
#include "suffuse/run/own_rules.hpp"
#include "suffuse/run/runner.hpp"

#include <algorithm>
#include <optional>

namespace suffuse::job {
namespace {

record::Outcome outcome_of(const RunReport& report, bool has_ended, const run::Overview& overview) {
    if (!has_ended) {
        return overview.out_of_time() ? record::Outcome::TimeLimit : record::Outcome::Stopped;
    }
    if (!report.failures.empty()) {
        return record::Outcome::SomeFailed;
    }
    return report.flaws.empty() ? record::Outcome::Done : record::Outcome::DoneWithFlaws;
}

void report_end(const char* event, record::Outcome outcome, const run::Overview& overview) {
    overview.log({{"event", event}, {"outcome", record::word_of(outcome)}, {"wall_seconds", overview.run_seconds()}});
}

RunReport report_of(Summary summary) {
    RunReport report;
    report.report = std::move(summary.report);
    report.warnings = std::move(summary.warnings);
    report.flaws = std::move(summary.flaws);
    report.findings = std::move(summary.findings);
    report.failures = std::move(summary.failures);
    return report;
}

RunReport run_all(const casefile::Case& what, const run::RunOptions& options, run::Overview& overview) {
    overview.log(
        {{"event", "run begins"},
         {"command", options.command},
         {"case_sha256", record::checksum_of(options.folder / record::resolved_case_file)}}
    );
    const bool has_ended = run::run_samples(what, options, overview);
    if (has_ended) { // a stop is not kept waiting, and signs nothing
        record::require_whole_stages(options.folder);
    }
    const casefile::Case refined = record::with_refinements(what, options.folder);
    const record::Sums earlier = record::read_run_sums(options.folder);
    io::remove_file(options.folder / record::checksums_file); // true no more
    record::keep_provenance(options.folder, refined, options.command, overview.run_seconds(), options.until);
    Summary summary = summarize_run(refined, options.folder, options.page_folder);
    const std::vector<std::string> figures = std::move(summary.figures);
    RunReport report = report_of(std::move(summary));
    report.outcome = outcome_of(report, has_ended, overview);
    report.remarks = overview.remarks();
    if (!record::is_resumable(report.outcome)) {
        record::write_run_sums(options.folder, figures, earlier);
    }
    report_end("run ends", report.outcome, overview);
    return report;
}

/// One sample, at the same time as other programs that run the others: what concerns the whole run is left to the
/// caller that gathers.
RunReport run_one(const casefile::Case& what, const run::RunOptions& options, run::Overview& overview) {
    const casefile::Case refined = record::with_refinements(what, options.folder);
    const std::vector<record::Sample> samples = record::list_samples(refined, options.until, options.sample);
    const bool has_all = std::ranges::all_of(samples, [&](const record::Sample& sample) {
        return record::is_complete(sample, options.folder);
    });
    const std::filesystem::path folder = options.folder / "studies" / options.sample;
    io::make_folders(folder);
    if (has_all && std::filesystem::exists(folder / record::provenance_file)) {
        return {}; // done before
    }
    overview.log({{"event", "sample begins"}, {"command", options.command}});
    const bool has_ended = run::run_samples(what, options, overview);
    record::keep_provenance(folder, refined, options.command, overview.run_seconds());
    RunReport report;
    report.remarks = overview.remarks();
    for (record::FailedSample& failure : record::read_failures(options.folder, refined)) {
        if (failure.sample == options.sample) {
            report.failures.push_back(std::move(failure));
        }
    }
    report.outcome = outcome_of(report, has_ended, overview);
    report_end("sample ends", report.outcome, overview);
    return report;
}

/// Takes the checksums of a run away while its report is written, for they are true no more; a report that fails leaves
/// them as they were.
class ChecksumsAside {
public:
    explicit ChecksumsAside(const std::filesystem::path& run) : file_(run / record::checksums_file) {
        if (std::filesystem::exists(file_)) {
            text_ = read_whole_file(file_);
            io::remove_file(file_);
        }
    }

    ~ChecksumsAside() {
        if (!text_.empty()) {
            io::show_file(file_, text_);
        }
    }

    ChecksumsAside(const ChecksumsAside&) = delete;
    ChecksumsAside& operator=(const ChecksumsAside&) = delete;

    void let_go() { text_.clear(); }

private:
    std::filesystem::path file_;
    std::string text_;
};

/// Of samples that were run one by one, side by side: the wall time of the one that took longest [s].
double longest_sample(const casefile::Case& what, const std::filesystem::path& folder) {
    double longest = 0;
    for (const record::Sample& sample : record::list_samples(what)) {
        const std::filesystem::path own = folder / "studies" / sample.variant->folder / "provenance.json";
        if (std::filesystem::exists(own)) {
            const nlohmann::json provenance = record::read_json(own);
            longest =
                std::max(longest, record::take_from(own, [&] { return provenance.at("wall_seconds").get<double>(); }));
        }
    }
    return longest;
}

} // namespace

RunReport run_case(const casefile::Case& what, const run::RunOptions& options) {
    record::StageCache(options.cache).require_one();
    record::open_folder(options.folder, what, options.case_text);
    run::take_own_rules(what, options);
    run::Overview overview(options);
    if (!options.is_checked) {
        const std::string doubts = record::require_whole_run(options.folder, options.sample);
        record::require_same_imports(what, options.folder, options.sample);
        if (std::optional<RunReport> ended = find_ended(what, options)) {
            return std::move(*ended);
        }
        if (!doubts.empty()) {
            overview.remark(doubts);
        }
    }
    return options.sample.empty() ? run_all(what, options, overview) : run_one(what, options, overview);
}

bool run_without_report(const casefile::Case& what, const run::RunOptions& options) {
    record::StageCache(options.cache).require_one();
    record::open_folder(options.folder, what, options.case_text);
    run::Overview overview(options);
    overview.log({{"event", "run begins"}, {"command", options.command}});
    const bool has_ended = run::run_samples(what, options, overview);
    record::keep_provenance(options.folder, what, options.command, overview.run_seconds());
    if (has_ended) {
        record::write_run_sums(options.folder, {}, record::read_run_sums(options.folder));
    }
    report_end("run ends", has_ended ? record::Outcome::Done : record::Outcome::Stopped, overview);
    return has_ended;
}

RunReport rebuild_report(
    const std::filesystem::path& folder, const std::filesystem::path& page_folder, const std::string& command
) {
    const casefile::Case what = record::load_run(folder);
    const record::Sums earlier = record::read_run_sums(folder);
    ChecksumsAside aside(folder);
    if (!std::filesystem::exists(folder / record::provenance_file)) {
        record::keep_provenance(folder, what, command, longest_sample(what, folder));
    }
    Summary summary = summarize_run(what, folder, page_folder);
    record::write_run_sums(folder, summary.figures, earlier);
    aside.let_go();
    RunReport report = report_of(std::move(summary));
    report.outcome = !report.failures.empty() ? record::Outcome::SomeFailed
                     : report.flaws.empty()   ? record::Outcome::Done
                                              : record::Outcome::DoneWithFlaws;
    return report;
}

} // namespace suffuse::job
