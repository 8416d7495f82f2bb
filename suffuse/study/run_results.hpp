#pragma once
// What the stages of a run say together, each found once. Texts, tables and figures take it from here.

#include "suffuse/record/finished_stage.hpp"
#include "suffuse/study/erosion_story.hpp"
#include "suffuse/study/findings_by_seed.hpp"
#include "suffuse/study/fines_findings.hpp"
#include "suffuse/study/fines_sweep.hpp"
#include "suffuse/study/mobility_story.hpp"
#include "suffuse/study/probed_states.hpp"
#include "suffuse/study/strength_change.hpp"
#include "suffuse/study/study_curves.hpp"
#include "suffuse/study/study_outcome.hpp"

#include <optional>
#include <vector>

namespace suffuse::study {

/// Points into itself and into the case: handed on by reference, never copied.
struct RunResults {
    RunResults() = default;
    RunResults(const RunResults&) = delete;
    RunResults& operator=(const RunResults&) = delete;
    RunResults(RunResults&&) = default;
    RunResults& operator=(RunResults&&) = default;

    const casefile::Case* what = nullptr;
    std::vector<record::FinishedStage> stages;
    std::vector<StudyCurves> curves;       ///< of each study of the case
    std::optional<FinesSweep> fines_sweep; ///< with its thresholds marked
    std::optional<FinesResults> fines;
    ErosionStory story;
    std::vector<Reading> readings;       ///< of its sample
    std::vector<MobilityStory> mobility; ///< where fines have weight
    std::vector<StrengthChange> strength;
    std::vector<ProbedState> probed_states;
    std::vector<StudyOutcome> outcomes; ///< of each study with a finished stage
    std::vector<Finding> findings;      ///< of the paper, whatever the case follows
};

/// @param stages of the case, as record::read_stages gives them
RunResults find_results(const casefile::Case& what, std::vector<record::FinishedStage> stages);

} // namespace suffuse::study
