#include "suffuse/run/stored_findings.hpp"

#include "suffuse/run/folder.hpp"
#include "suffuse/run/result_json.hpp"
#include "suffuse/run/stored.hpp"

namespace suffuse::run {

StageFindings read_findings(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / "results.cbor";
    if (!std::filesystem::exists(file)) {
        return {};
    }
    const nlohmann::json results = read_cbor(file);
    return take_from(file, [&] {
        StageFindings findings;
        if (results.contains("probes")) {
            results.at("probes").get_to(findings.probes);
        }
        if (results.contains("erosion")) {
            findings.erosion = results.at("erosion").get<erosion::ErosionResult>();
        }
        if (results.contains("curve")) {
            results.at("curve").get_to(findings.curve);
        }
        if (results.contains("throat_flux")) {
            findings.throat_flux = results.at("throat_flux").get<flow::ThroatFlux>();
        }
        return findings;
    });
}

} // namespace suffuse::run
