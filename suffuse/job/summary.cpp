#include "suffuse/job/summary.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/version.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/job/draw_figures.hpp"
#include "suffuse/job/report_data.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/missing_stages.hpp"
#include "suffuse/record/or_null.hpp"
#include "suffuse/record/stored.hpp"
#include "suffuse/record/stored_findings.hpp"
#include "suffuse/report/page.hpp"
#include "suffuse/study/run_results.hpp"
#include "suffuse/study/trace_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

namespace suffuse::job {
namespace {

using nlohmann::json;

/// What the page's reader must know first: what is missing.
std::vector<std::string>
with_failures(std::vector<std::string> flaws, const std::vector<record::FailedSample>& failures) {
    for (const record::FailedSample& failure : failures) {
        flaws.push_back(fmt::format("{} failed in stage {}: {}", failure.sample, failure.stage, failure.message));
    }
    return flaws;
}

/// How many samples there are, and how many of them reached their end, or the stage that they were to end with.
json count_samples(
    const casefile::Case& what, const std::string& until, const std::filesystem::path& folder, std::size_t failed
) {
    const std::vector<record::Sample> samples = record::list_samples(what, until);
    const auto done = std::count_if(samples.begin(), samples.end(), [&](const record::Sample& s) {
        return record::is_complete(s, folder);
    });
    return {{"total", samples.size()}, {"done", done}, {"failed", failed}};
}

json findings_json(const std::vector<study::Finding>& findings) {
    json list = json::array();
    for (const study::Finding& finding : findings) {
        list.push_back(
            {{"id", finding.id},
             {"claim", finding.claim},
             {"paper", finding.paper},
             {"ours", finding.ours},
             {"met", or_null(study::agreement_of(finding))},
             {"verdict", study::name_of(study::standing_of(finding))},
             {"our_numbers", finding.our_numbers},
             {"why", finding.why}}
        );
    }
    return list;
}

json readings_json(const std::vector<study::Reading>& readings) {
    json list = json::array();
    for (const study::Reading& reading : readings) {
        list.push_back({{"reading", reading.name}, {"findings", findings_json(reading.findings)}});
    }
    return list;
}

json cards_json(const std::vector<answer::Headline>& cards) {
    json list = json::array();
    for (const answer::Headline& card : cards) {
        list.push_back(
            {{"label", card.label},
             {"value", (card.lead.empty() ? "" : card.lead + " ") + card.value},
             {"spread", card.spread},
             {"detail", card.detail},
             {"caution", card.caution}}
        );
    }
    return list;
}

/// What the check of the case says of its physics, as it did on the terminal before the run.
std::vector<Diagnostic> check_again(const std::filesystem::path& folder) {
    std::vector<Diagnostic> found;
    try {
        found = casefile::load_case((folder / record::resolved_case_file).string()).warnings;
    } catch (const CaseError&) { // a packing has gone meanwhile: no reason to lose the report
    }
    std::erase_if(found, [](const Diagnostic& d) { return !d.code.starts_with("W6"); });
    return found;
}

std::vector<std::string> in_lines(const std::vector<Diagnostic>& diagnostics) {
    std::vector<std::string> lines;
    for (const Diagnostic& d : diagnostics) {
        lines.push_back(fmt::format("{}: {}; {}", d.code, d.message, d.help));
    }
    return lines;
}

json diagnostics_json(const std::vector<Diagnostic>& diagnostics) {
    json list = json::array();
    for (const Diagnostic& d : diagnostics) {
        list.push_back({{"code", d.code}, {"message", d.message}, {"help", d.help}});
    }
    return list;
}

/// "own-paths" of "own-paths.vl.json".
std::string figure_id(const std::string& file) {
    return file.substr(0, file.find('.'));
}

/// Figures that an earlier report had and this one has not, with what was drawn of them: of a run that had fewer
/// stages. Every figure has a table, and pictures of the view in 3D have a number: what else lies there is the user's
/// own.
void remove_old_figures(const std::filesystem::path& folder, const std::vector<std::string>& now) {
    static const std::regex of_report("(fig[0-9]{2}|own-[^.]*)[.](csv|vl[.]json|svg|png|pdf)");
    std::set<std::string> ids;
    for (const std::string& file : now) {
        ids.insert(figure_id(file));
    }
    static const std::regex of_view("own-grains-[0-9]+");
    std::vector<std::filesystem::path> old;
    for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename(), id = figure_id(name);
        const bool is_ours = std::filesystem::exists(folder / (id + ".csv")) || std::regex_match(id, of_view);
        if (std::regex_match(name, of_report) && is_ours && !ids.contains(id)) {
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

/// @throws IoError where it lacks what page and summary take from it
json read_provenance(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / record::provenance_file;
    json provenance = record::read_json(file);
    record::take_from(file, [&] {
        for (const char* const key : {"version", "commit", "threads", "wall_seconds", "mode", "preparation"}) {
            static_cast<void>(provenance.at(key));
        }
        static_cast<void>(provenance.value("until", ""));
    });
    return provenance;
}

Summary
summarize(const casefile::Case& what, const std::filesystem::path& folder, const std::filesystem::path& page_folder) {
    const study::RunResults results = study::find_results(what, record::read_stages(what, folder));
    const json provenance = read_provenance(folder);
    Summary summary;
    json by_name = json::object();
    for (const record::FinishedStage& stage : results.stages) {
        by_name[stage.name()] = stage.numbers;
        record::take_from(record::stage_folder(folder, *stage.variant, *stage.stage) / "stage.json", [&] {
            append(stage.numbers.at("warnings"), summary.warnings);
            append(stage.numbers.at("flaws"), summary.flaws);
        });
    }
    summary.failures = record::read_failures(folder, what);
    const record::MissingStages missing = record::find_missing_stages(what, folder);
    const std::string until = provenance.value("until", ""), resume = "suffuse resume " + shell_word(folder.string());
    const json samples = count_samples(what, until, folder, summary.failures.size());
    const bool ended_early = !until.empty() && !missing.names.empty() && samples.at("done") == samples.at("total");
    const std::vector<Diagnostic> of_case = check_again(folder);
    report::ReportData data = describe_run(
        results, folder, provenance,
        {summary.warnings,
         with_failures(summary.flaws, summary.failures),
         in_lines(of_case),
         {ended_early ? "" : record::describe_missing(missing), resume}}
    );
    if (ended_early) {
        data.opening.about_confidence +=
            fmt::format(" The run ended with stage {}, as requested; `{}` continues it.", until, resume);
    }
    summary.findings = findings_json(data.findings); // what the page shows
    record::write_json(
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
                                  {"answer",
                                   {{"verdict", data.opening.verdict},
                                    {"confidence", data.opening.confidence},
                                    {"estimates", data.opening.estimates},
                                    {"doubts", data.opening.doubts},
                                    {"cards", cards_json(data.opening.cards)}}},
                                  {"warnings", summary.warnings},
                                  {"flaws", summary.flaws},
                                  {"findings", findings_json(results.findings)},
                                  {"readings", readings_json(results.readings)},
                                  {"thresholds", study::thresholds_json(results.fines)},
                                  {"strength", study::strength_json(results.strength)},
                                  {"samples", samples},
                                  {"until", ended_early ? json(until) : json()},
                                  {"failures", summary.failures},
                                  {"stages", by_name},
                                  {"studies", study::curves_json(results.curves)}}
    );
    summary.figures = report::write_figures(folder, data);
    draw_in_page(data.figures, folder, page_folder);
    summary.report = report::write_page(folder, data, page_folder).file;
    remove_old_figures(folder / "figures", summary.figures);
    return summary;
}

} // namespace

Summary summarize_run(
    const casefile::Case& what, const std::filesystem::path& folder, const std::filesystem::path& page_folder
) {
    return record::take_from(folder, [&] { return summarize(what, folder, page_folder); });
}

} // namespace suffuse::job
