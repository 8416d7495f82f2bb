#include "suffuse/run/summary.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/version.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/report/page.hpp"
#include "suffuse/run/folder.hpp"
#include "suffuse/run/report_data.hpp"
#include "suffuse/run/result_json.hpp"
#include "suffuse/run/runner.hpp"

#include <filesystem>

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
                FinishedStage done{&study, &variant, &stage, read_json(place / "stage.json"), {}};
                if (std::filesystem::exists(place / "results.cbor")) {
                    const json results = read_cbor(place / "results.cbor");
                    if (results.contains("probes")) {
                        results.at("probes").get_to(done.findings.probes);
                    }
                    if (results.contains("erosion")) {
                        done.findings.erosion = results.at("erosion").get<erosion::ErosionResult>();
                    }
                    if (results.contains("curve")) {
                        results.at("curve").get_to(done.findings.curve);
                    }
                }
                stages.push_back(std::move(done));
            }
        }
    }
    return stages;
}

json findings_json(const std::vector<report::Finding>& findings) {
    json list = json::array();
    for (const report::Finding& finding : findings) {
        const json met = finding.met ? json(*finding.met) : json(nullptr);
        list.push_back(
            {{"id", finding.id},
             {"claim", finding.claim},
             {"paper", finding.paper},
             {"ours", finding.ours},
             {"met", met}}
        );
    }
    return list;
}

void append(const json& texts, std::vector<std::string>& to) {
    for (const json& text : texts) {
        to.push_back(text);
    }
}

} // namespace

Summary summarize_run(
    const casefile::Case& what, const std::filesystem::path& folder, const std::filesystem::path& page_folder
) {
    const std::vector<FinishedStage> stages = read_stages(what, folder);
    const json provenance = read_json(folder / "provenance.json");
    Summary summary;
    json by_name = json::object();
    for (const FinishedStage& stage : stages) {
        by_name[stage.variant->folder + "/" + stage.stage->name] = stage.numbers;
        append(stage.numbers.at("warnings"), summary.warnings);
        append(stage.numbers.at("flaws"), summary.flaws);
    }
    const report::ReportData data = describe_run(what, folder, stages, provenance, summary.warnings, summary.flaws);
    summary.findings = findings_json(data.findings);
    write_json(
        folder / "summary.json", {{"schema", 1},
                                  {"version", version()},
                                  {"title", what.title},
                                  {"seed", what.seed},
                                  {"threads", provenance.at("threads")},
                                  {"wall_seconds", provenance.at("wall_seconds")},
                                  {"mode", provenance.at("mode")},
                                  {"preparation", provenance.at("preparation")},
                                  {"warnings", summary.warnings},
                                  {"flaws", summary.flaws},
                                  {"findings", summary.findings},
                                  {"stages", by_name}}
    );
    summary.report = report::write_report(folder, data, page_folder).file;
    return summary;
}

RunReport rebuild_report(const std::filesystem::path& folder, const std::filesystem::path& page_folder) {
    const casefile::LoadedCase loaded = casefile::load_case((folder / "case.resolved.toml").string());
    const Summary summary = summarize_run(loaded.value, folder, page_folder);
    return {
        summary.flaws.empty() ? Outcome::Done : Outcome::DoneWithFlaws, summary.report, summary.warnings, summary.flaws,
        summary.findings};
}

} // namespace suffuse::run
