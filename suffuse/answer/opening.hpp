#pragma once
// What the report opens with: verdict, how sure it is, at most six numbers, what disagrees, and which pictures decide.

#include "suffuse/answer/headlines.hpp"
#include "suffuse/study/run_results.hpp"

#include <string>
#include <vector>

namespace suffuse::answer {

struct Opening {
    std::vector<std::string> verdict;      ///< one to three sentences of at most 20 words
    std::string confidence;                ///< "One sample", "Three samples each": in a box
    std::string about_confidence;          ///< what is not known, and the call that would measure it
    std::string estimates;                 ///< of a critical gradient: all there are, by name; else empty
    std::vector<std::string> doubts;       ///< the largest about it, at most three, with what would remove each
    std::vector<Headline> cards;           ///< at most six, the first answers the question
    std::vector<std::string> disagreement; ///< of two answers: stated in the opening
    /// Ids of figures, those that decide first: the first two that the report has are shown in the first screen.
    std::vector<std::string> pictures;
    bool shows_grains = false; ///< the sample before and after decides more than any curve
};

/// @param findings that the page shows: none where the case follows no paper
Opening open_answer(const study::RunResults& results, const std::vector<study::Finding>& findings);

} // namespace suffuse::answer
