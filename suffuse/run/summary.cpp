#include "suffuse/run/summary.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/version.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/report/or_null.hpp"
#include "suffuse/report/page.hpp"
#include "suffuse/run/checksums.hpp"
#include "suffuse/run/findings_by_seed.hpp"
#include "suffuse/run/fines_findings.hpp"
#include "suffuse/run/folder.hpp"
#include "suffuse/run/missing_stages.hpp"
#include "suffuse/run/refine.hpp"
#include "suffuse/run/report_data.hpp"
#include "suffuse/run/runner.hpp"
#include "suffuse/run/sample_run.hpp"
#include "suffuse/run/stage_start.hpp"
#include "suffuse/run/stored.hpp"
#include "suffuse/run/stored_findings.hpp"
#include "suffuse/run/strength_change.hpp"
#include "suffuse/run/study_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

namespace suffuse::run {
namespace {

using nlohmann::json;

/// Reads every finished stage of the run.
std::vector<FinishedStage> read_stages(const casefile::Case& what, const std::filesystem::path& folder) {
    std::vector<FinishedStage> stages;
    for (const casefile::Study& study : what.studies) {
        for (const casefile::Variant& variant : study.variants) {
            for (const casefile::Stage& stage : variant.stages) {
                const std::filesystem::path place = stage_folder(folder, variant, stage);
                if (!std::filesystem::exists(place / "stage.json")) {
                    continue;
                }
                check_start(variant, stage, folder);
                stages.push_back({&study, &variant, &stage, read_json(place / "stage.json"), read_findings(place)});
            }
        }
    }
    return stages;
}

/// What the page's reader must know first: what is missing.
std::vector<std::string> with_failures(std::vector<std::string> flaws, const std::vector<FailedSample>& failures) {
    for (const FailedSample& failure : failures) {
        flaws.push_back(fmt::format("{} failed in stage {}: {}", failure.sample, failure.stage, failure.message));
    }
    return flaws;
}

/// How many samples there are, and how many of them reached their end.
json count_samples(const casefile::Case& what, const std::filesystem::path& folder, std::size_t failed) {
    const std::vector<Sample> samples = list_samples(what);
    const auto done =
        std::count_if(samples.begin(), samples.end(), [&](const Sample& s) { return is_complete(s, folder); });
    return {{"total", samples.size()}, {"done", done}, {"failed", failed}};
}

/// Of samples that were run one by one, beside each other: the wall time of the one that took longest [s].
double longest_sample(const casefile::Case& what, const std::filesystem::path& folder) {
    double longest = 0;
    for (const Sample& sample : list_samples(what)) {
        const std::filesystem::path own = folder / "studies" / sample.variant->folder / "provenance.json";
        if (std::filesystem::exists(own)) {
            const json provenance = read_json(own);
            longest = std::max(longest, take_from(own, [&] { return provenance.at("wall_seconds").get<double>(); }));
        }
    }
    return longest;
}

json findings_json(const std::vector<report::Finding>& findings) {
    json list = json::array();
    for (const report::Finding& finding : findings) {
        list.push_back(
            {{"id", finding.id},
             {"claim", finding.claim},
             {"paper", finding.paper},
             {"ours", finding.ours},
             {"met", or_null(finding.met)}}
        );
    }
    return list;
}

std::vector<report::Finding> judge(const std::optional<FinesResults>& fines, const std::vector<FinishedStage>& stages) {
    std::vector<report::Finding> findings = judge_fines_of(fines);
    for (report::Finding& finding : judge_erosion_by_seed(stages)) {
        findings.push_back(std::move(finding));
    }
    return findings;
}

/// What the check of the case says of its physics, as it did on the terminal before the run.
std::vector<casefile::Diagnostic> check_again(const std::filesystem::path& folder) {
    std::vector<casefile::Diagnostic> found;
    try {
        found = casefile::load_case((folder / resolved_case_file).string()).warnings;
    } catch (const CaseError&) { // a packing has gone meanwhile: no reason to lose the report
    }
    std::erase_if(found, [](const casefile::Diagnostic& d) { return !d.code.starts_with("W6"); });
    return found;
}

std::vector<std::string> in_lines(const std::vector<casefile::Diagnostic>& diagnostics) {
    std::vector<std::string> lines;
    for (const casefile::Diagnostic& d : diagnostics) {
        lines.push_back(fmt::format("{}: {}; {}", d.code, d.message, d.help));
    }
    return lines;
}

json diagnostics_json(const std::vector<casefile::Diagnostic>& diagnostics) {
    json list = json::array();
    for (const casefile::Diagnostic& d : diagnostics) {
        list.push_back({{"code", d.code}, {"message", d.message}, {"help", d.help}});
    }
    return list;
}

/// "own-paths" of "own-paths.vl.json".
std::string figure_id(const std::string& file) {
    return file.substr(0, file.find('.'));
}

/// Figures that an earlier report had and this one has not, with what was drawn of them: of a run that had fewer
/// stages.
void remove_old_figures(const std::filesystem::path& folder, const std::vector<std::string>& now) {
    static const std::regex of_report("(fig[0-9]{2}|own-[^.]*)[.](csv|vl[.]json|svg|png|pdf)");
    std::set<std::string> ids;
    for (const std::string& file : now) {
        ids.insert(figure_id(file));
    }
    std::vector<std::filesystem::path> old;
    for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename();
        if (std::regex_match(name, of_report) && !ids.contains(figure_id(name))) {
            old.push_back(entry.path());
        }
    }
    for (const std::filesystem::path& file : old) {
        std::filesystem::remove(file);
    }
}

void append(const json& texts, std::vector<std::string>& to) {
    for (const json& text : texts) {
        to.push_back(text);
    }
}

Summary
summarize(const casefile::Case& what, const std::filesystem::path& folder, const std::filesystem::path& page_folder) {
    const std::vector<FinishedStage> stages = read_stages(what, folder);
    const json provenance = read_json(folder / "provenance.json");
    Summary summary;
    json by_name = json::object();
    for (const FinishedStage& stage : stages) {
        by_name[stage.name()] = stage.numbers;
        take_from(stage_folder(folder, *stage.variant, *stage.stage) / "stage.json", [&] {
            append(stage.numbers.at("warnings"), summary.warnings);
            append(stage.numbers.at("flaws"), summary.flaws);
        });
    }
    summary.failures = read_failures(folder, what);
    const MissingStages missing = find_missing_stages(what, folder);
    const std::vector<casefile::Diagnostic> of_case = check_again(folder);
    const std::optional<FinesResults> fines = gather_fines(what, stages);
    const std::vector<report::Finding> findings = judge(fines, stages);
    const report::ReportData data = describe_run(
        what, folder, stages, provenance,
        {summary.warnings,
         with_failures(summary.flaws, summary.failures),
         in_lines(of_case),
         findings,
         {tell_missing(missing), "suffuse resume " + shell_word(folder.string())}}
    );
    summary.findings = findings_json(data.findings); // what the page shows
    write_json(
        folder / "summary.json", {{"schema", 1},
                                  {"version", version()},
                                  {"title", what.title},
                                  {"seed", what.seed},
                                  {"threads", provenance.at("threads")},
                                  {"wall_seconds", provenance.at("wall_seconds")},
                                  {"mode", provenance.at("mode")},
                                  {"preparation", provenance.at("preparation")},
                                  {"case_warnings", diagnostics_json(of_case)},
                                  {"missing_stages", missing.names},
                                  {"warnings", summary.warnings},
                                  {"flaws", summary.flaws},
                                  {"findings", findings_json(findings)},
                                  {"thresholds", thresholds_json(fines)},
                                  {"strength", strength_json(compare_strength(stages))},
                                  {"samples", count_samples(what, folder, summary.failures.size())},
                                  {"failures", summary.failures},
                                  {"stages", by_name},
                                  {"studies", curves_json(trace_curves(what, stages))}}
    );
    report::WrittenReport written = report::write_report(folder, data, page_folder);
    summary.report = std::move(written.file);
    summary.figures = std::move(written.figures);
    remove_old_figures(folder / "figures", summary.figures);
    return summary;
}

} // namespace

Summary summarize_run(
    const casefile::Case& what, const std::filesystem::path& folder, const std::filesystem::path& page_folder
) {
    return take_from(folder, [&] { return summarize(what, folder, page_folder); });
}

RunReport rebuild_report(
    const std::filesystem::path& folder, const std::filesystem::path& page_folder, const std::string& command
) {
    const casefile::Case what = load_run(folder);
    const Sums earlier = read_run_sums(folder);
    std::filesystem::remove(folder / checksums_file); // true no more
    if (!std::filesystem::exists(folder / provenance_file)) {
        RunOptions options;
        options.command = command;
        keep_provenance(folder, what, options, longest_sample(what, folder));
    }
    const Summary summary = summarize_run(what, folder, page_folder);
    write_run_sums(folder, summary.figures, earlier);
    const Outcome outcome = !summary.failures.empty() ? Outcome::SomeFailed
                            : summary.flaws.empty()   ? Outcome::Done
                                                      : Outcome::DoneWithFlaws;
    return {outcome, summary.failures, summary.report, summary.warnings, summary.flaws, summary.findings, {}};
}

} // namespace suffuse::run
