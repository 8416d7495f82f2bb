#pragma once
// A stage that a run has finished, read back from its folder.

#include "suffuse/casefile/case.hpp"
#include "suffuse/erosion/loop.hpp"
#include "suffuse/erosion/migration_result.hpp"
#include "suffuse/record/samples.hpp"
#include "suffuse/triaxial/run_path.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <vector>

namespace suffuse::record {

/// What the report draws from a stage, beyond its numbers.
struct StageFindings {
    std::vector<erosion::ProbeResult> probes;
    std::optional<erosion::MobilityResult> mobility; ///< of a detach stage with weight
    std::optional<erosion::ErosionResult> erosion;
    std::optional<erosion::MigrationResult> migration;
    std::vector<triaxial::PathRow> curve;
    std::optional<flow::ThroatFlux> throat_flux;
};

struct FinishedStage {
    const casefile::Study* study = nullptr;
    const casefile::Variant* variant = nullptr;
    const casefile::Stage* stage = nullptr;
    nlohmann::json numbers; ///< stage.json
    StageFindings findings;

    /// "STUDY/SAMPLE/STAGE".
    [[nodiscard]] std::string name() const { return stage_name(*variant, *stage); }
};

} // namespace suffuse::record
