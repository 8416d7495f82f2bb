#pragma once
// What gradients do to fines that have weight, as headlines.

#include "suffuse/answer/headlines.hpp"
#include "suffuse/study/mobility_story.hpp"

#include <vector>

namespace suffuse::answer {

/// Factor of safety, the gradients that move 1 and 10 %, heave; each with what is known of its uncertainty.
std::vector<Headline> mobility_headlines(const study::MobilityStory& story);

} // namespace suffuse::answer
