#include "suffuse/record/stored_findings.hpp"

#include "suffuse/record/check_findings.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/result_json.hpp"
#include "suffuse/record/stage_start.hpp"
#include "suffuse/record/stored.hpp"

namespace suffuse::record {

void save_findings(const std::filesystem::path& folder, const StageFindings& findings) {
    nlohmann::json results = nlohmann::json::object();
    if (!findings.probes.empty()) {
        results["probes"] = findings.probes;
    }
    if (findings.mobility) {
        results["mobility"] = *findings.mobility;
    }
    if (findings.erosion) {
        results["erosion"] = *findings.erosion;
    }
    if (findings.migration) {
        results["migration"] = *findings.migration;
    }
    if (!findings.curve.empty()) {
        results["curve"] = findings.curve;
    }
    if (findings.throat_flux) {
        results["throat_flux"] = *findings.throat_flux;
    }
    if (!results.empty()) {
        write_cbor(folder / "results.cbor", results);
    }
}

StageFindings read_findings(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / "results.cbor";
    if (!std::filesystem::exists(file)) {
        return {};
    }
    const nlohmann::json results = read_cbor(file);
    const auto take = [&] {
        StageFindings findings;
        if (results.contains("probes")) {
            results.at("probes").get_to(findings.probes);
        }
        if (results.contains("mobility")) {
            findings.mobility = results.at("mobility").get<erosion::MobilityResult>();
        }
        if (results.contains("erosion")) {
            findings.erosion = results.at("erosion").get<erosion::ErosionResult>();
        }
        if (results.contains("migration")) {
            findings.migration = results.at("migration").get<erosion::MigrationResult>();
        }
        if (results.contains("curve")) {
            results.at("curve").get_to(findings.curve);
        }
        if (results.contains("throat_flux")) {
            findings.throat_flux = results.at("throat_flux").get<flow::ThroatFlux>();
        }
        return findings;
    };
    StageFindings findings = take_from(file, take);
    if (const std::string missing = what_is_missing(findings); !missing.empty()) {
        throw not_as_stored(file, missing);
    }
    return findings;
}

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

} // namespace suffuse::record
