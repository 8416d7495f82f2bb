#pragma once
// Why a gradient that moves fines differs from those of rules and of other measures.

#include "suffuse/study/mobility_story.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::answer {

/// Where Skempton and Brogan's rule and the motion of the fines disagree on the specified gradient: both, and why.
std::optional<std::string> disagreement(const study::MobilityStory& story);

/// Skempton and Brogan's gradient next to the one found, and why they differ where they do; sifting.
std::vector<std::string> remarks_on(const study::MobilityStory& story);

} // namespace suffuse::answer
