#pragma once
// What a run found in one look: one to three sentences of at most 20 words, a line each, on its question.

#include "suffuse/study/run_results.hpp"

#include <string>
#include <vector>

namespace suffuse::answer {

/// What the run is about: decides verdict, cards and picture alike.
enum class Question {
    Fines,     ///< a study over the fines content whose thresholds were found
    Filter,    ///< whether a filter holds its base
    Sweep,     ///< a study over something else
    Weight,    ///< which gradient moves fines that have weight
    Erosion,   ///< what an erosion by water does
    Migration, ///< which fines leave that travel with the water
    Probe,     ///< which fines a gradient detaches
    Removal,   ///< what fines taken out without water do
    State      ///< strength, permeability and void ratio of a soil as it is
};

Question question_of(const study::RunResults& results);

/// The study that the answer is about: of an erosion its own, else the one with the most samples; null without stages.
const study::StudyOutcome* reported_outcome(const study::RunResults& results);

/// The samples of that study that the verdict is of; null where there are none.
const study::OutcomePoint* reported_point(const study::RunResults& results);

std::vector<std::string> verdict_of_run(const study::RunResults& results);

} // namespace suffuse::answer
