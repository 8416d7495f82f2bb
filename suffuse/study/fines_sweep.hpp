#pragma once
// Which study of a case is one over the fines content of its soil, and what its loose and densest states are.

#include "suffuse/record/finished_stage.hpp"
#include "suffuse/study/fines_study.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::study {

struct FinesSweep {
    const casefile::Study* study = nullptr;
    std::string loose, dense;              ///< names of stages; `dense` may be empty
    std::vector<std::string> loose_stages; ///< `loose`, and those that make its state at other fines contents
    std::size_t key = 0;                   ///< which of the swept keys is the fines content
    StudyCurves traced;                    ///< all of the study
    FinesStudy curves;                     ///< of the loose and the densest state
};

/// Of the studies that sweep the fines content, the one with the most points. Loose is its first compaction with
/// adhesion, or else its first without a lowered friction; densest is the compaction at the lowest friction. A loose
/// state that is made `only` at some fines contents goes on with the other compactions that are, too. Where
/// other keys are swept too, their first values count. Nothing where there is no such study. @param traced of each
/// study of the case
std::optional<FinesSweep> find_fines_sweep(const casefile::Case& what, const std::vector<StudyCurves>& traced);

/// "friction 30 deg": the first values of the other keys, at which its curves are; empty where none is swept.
std::string other_values(const FinesSweep& sweep);

/// The points of a stage over the fines content alone.
StageCurve sweep_points(const FinesSweep& sweep, const std::string& stage);

/// Those of the loose state, whichever stages make it.
StageCurve loose_points(const FinesSweep& sweep);

/// The first drained test that starts from the loose state: Figure 2. Null where there is none.
const casefile::Stage* loose_test(const FinesSweep& sweep);

} // namespace suffuse::study
