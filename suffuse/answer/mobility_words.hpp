#pragma once
// What gradients do to fines that have weight, in sentences: the verdict that an engineer needs, and why two answers
// may differ.

#include "suffuse/answer/headlines.hpp"
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

/// Where Skempton and Brogan's rule and the motion of the fines disagree on the specified gradient: both, and why.
std::optional<std::string> disagreement(const study::MobilityStory& story);

/// Skempton and Brogan's gradient next to the one found, and why they differ where they do; sifting.
std::vector<std::string> remarks_on(const study::MobilityStory& story);

/// Verdicts and remarks of all.
std::vector<std::string> answer_of_mobility(const std::vector<study::MobilityStory>& stories);

/// Factor of safety, the gradients that move 1 and 10 %, heave; each with what is known of its uncertainty.
std::vector<Headline> mobility_headlines(const study::MobilityStory& story);

/// One sentence for cases whose fines have no weight; nothing if no stage finds what moves.
std::optional<std::string> what_weight_would_change(const std::vector<record::FinishedStage>& stages);

} // namespace suffuse::answer
