#pragma once
// From finished stages to what the report shows.

#include "suffuse/casefile/case.hpp"
#include "suffuse/report/page.hpp"
#include "suffuse/run/finished_stage.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <vector>

namespace suffuse::run {

report::ReportData describe_run(
    const casefile::Case& what, const std::filesystem::path& folder, const std::vector<FinishedStage>& stages,
    const nlohmann::json& provenance, const std::vector<std::string>& warnings, const std::vector<std::string>& flaws
);

} // namespace suffuse::run
