#pragma once
// A stage that a run has finished, read back from its folder.

#include "suffuse/casefile/case.hpp"
#include "suffuse/run/stage_work.hpp"

#include <nlohmann/json.hpp>

namespace suffuse::run {

struct FinishedStage {
    const casefile::Study* study = nullptr;
    const casefile::Variant* variant = nullptr;
    const casefile::Stage* stage = nullptr;
    nlohmann::json numbers; ///< stage.json
    StageFindings findings;

    /// "STUDY/SAMPLE/STAGE".
    [[nodiscard]] std::string name() const { return stage_name(*variant, *stage); }
};

} // namespace suffuse::run
