#include "suffuse/job/ended_run.hpp"

#include "suffuse/record/checksums.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/missing_stages.hpp"
#include "suffuse/record/refine.hpp"
#include "suffuse/record/stored.hpp"

#include <algorithm>

namespace suffuse::job {
namespace {

namespace fs = std::filesystem;

/// Of a stage that was completed in the last moment before a kill, or by another call.
bool has_leftovers(const record::Sample& sample, const fs::path& run) {
    return std::ranges::any_of(sample.variant->stages, [&](const casefile::Stage& stage) {
        const fs::path folder = record::stage_folder(run, *sample.variant, stage);
        return fs::exists(folder / record::failure_file) || fs::exists(folder / record::partial_file);
    });
}

} // namespace

std::optional<RunReport> find_ended(const casefile::Case& what, const run::RunOptions& options) {
    const fs::path& run = options.folder;
    if (!options.sample.empty() || !fs::exists(run / record::checksums_file) || !fs::exists(run / "summary.json")) {
        return std::nullopt;
    }
    const std::vector<record::Sample> samples = record::list_samples(what, options.until);
    const bool is_whole = std::ranges::all_of(samples, [&](const record::Sample& sample) {
        return record::is_complete(sample, run) && !has_leftovers(sample, run);
    });
    if (!is_whole || record::add_samples(what, record::find_refinements(what, run)) || !record::has_same_results(run)) {
        return std::nullopt;
    }
    const nlohmann::json summary = record::read_json(run / "summary.json");
    RunReport report;
    report.report = run / "report.html";
    record::take_from(run / "summary.json", [&] {
        report.warnings = summary.value("warnings", report.warnings);
        report.flaws = summary.value("flaws", report.flaws);
        report.findings =
            what.paper.empty() ? nlohmann::json::array() : summary.value("findings", nlohmann::json::array());
    });
    report.outcome = report.flaws.empty() ? record::Outcome::Done : record::Outcome::DoneWithFlaws;
    return report;
}

} // namespace suffuse::job
