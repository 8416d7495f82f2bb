#pragma once
// What gradients do to fines that have weight, in sentences: the verdict that an engineer needs.

#include "suffuse/record/finished_stage.hpp"
#include "suffuse/study/mobility_story.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::answer {

/// "Upward", "Downward", "Level", "Oblique".
std::string flow_in_words(const erosion::MobilityResult& mobility);

/// "Upward flow"; "By a surrogate, upward flow".
std::string subject_of(const study::MobilityStory& story);

/// "Upward flow moves 1 % of the fines at i = 0.30, a tenth at 0.51; the soil heaves at 1.05. At the specified 0.20 it
/// moves 0.2 % (factor of safety 1.5; one sample)."
std::string verdict(const study::MobilityStory& story);

/// The same in at most two sentences of at most 20 words, without deviations: what the page opens with.
std::vector<std::string> short_verdict(const study::MobilityStory& story);

/// Verdicts and remarks of all.
std::vector<std::string> answer_of_mobility(const std::vector<study::MobilityStory>& stories);

/// One sentence for cases whose fines have no weight; nothing if no stage finds what moves.
std::optional<std::string> what_weight_would_change(const std::vector<record::FinishedStage>& stages);

} // namespace suffuse::answer
