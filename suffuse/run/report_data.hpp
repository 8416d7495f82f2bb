#pragma once
// From finished stages to what the report shows.

#include "suffuse/casefile/case.hpp"
#include "suffuse/report/page.hpp"
#include "suffuse/run/stage_work.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <vector>

namespace suffuse::run {

struct FinishedStage {
    const casefile::Study* study = nullptr;
    const casefile::Variant* variant = nullptr;
    const casefile::Stage* stage = nullptr;
    nlohmann::json numbers; ///< stage.json
    StageFindings findings;
};

report::ReportData describe_run(
    const casefile::Case& what, const std::filesystem::path& folder, const std::vector<FinishedStage>& stages,
    const nlohmann::json& provenance, const std::vector<std::string>& warnings, const std::vector<std::string>& flaws
);

} // namespace suffuse::run
