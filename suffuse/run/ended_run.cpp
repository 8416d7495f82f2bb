#include "suffuse/run/ended_run.hpp"

#include "suffuse/run/checksums.hpp"
#include "suffuse/run/folder.hpp"
#include "suffuse/run/refine.hpp"
#include "suffuse/run/sample_run.hpp"

#include <algorithm>

namespace suffuse::run {
namespace {

namespace fs = std::filesystem;

/// Of a stage that was completed in the last moment before a kill, or by another call.
bool has_leftovers(const Sample& sample, const fs::path& run) {
    return std::ranges::any_of(sample.variant->stages, [&](const casefile::Stage& stage) {
        const fs::path folder = stage_folder(run, *sample.variant, stage);
        return fs::exists(folder / failure_file) || fs::exists(folder / partial_file);
    });
}

} // namespace

std::optional<RunReport> find_ended(const casefile::Case& what, const RunOptions& options) {
    const fs::path& run = options.folder;
    if (!options.sample.empty() || !fs::exists(run / checksums_file) || !fs::exists(run / "summary.json")) {
        return std::nullopt;
    }
    const std::vector<Sample> samples = list_samples(what, options.until);
    const bool is_whole = std::ranges::all_of(samples, [&](const Sample& sample) {
        return is_complete(sample, run) && !has_leftovers(sample, run);
    });
    if (!is_whole || add_samples(what, find_refinements(what, run)) || !has_same_results(run)) {
        return std::nullopt;
    }
    const nlohmann::json summary = read_json(run / "summary.json");
    RunReport report;
    report.report = run / "report.html";
    report.warnings = summary.value("warnings", report.warnings);
    report.flaws = summary.value("flaws", report.flaws);
    report.findings = what.paper.empty() ? nlohmann::json::array() : summary.value("findings", nlohmann::json::array());
    report.outcome = report.flaws.empty() ? Outcome::Done : Outcome::DoneWithFlaws;
    return report;
}

} // namespace suffuse::run
