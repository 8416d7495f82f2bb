#pragma once
// A surrogate in words: what two fractions leave out of the soil that they stand for, and how
// the gradients depend on the size ratio where the soil's own could not be simulated.

#include "suffuse/figures/page_table.hpp"
#include "suffuse/study/mobility_story.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::answer {

/// Above this size ratio fines fit between three coarse grains that touch: single ones may fall through the skeleton by
/// their own weight (docs/theory/surrogates.md).
inline constexpr double sifting_ratio = 6.5;

/// What differs from the soil, a sentence each. @param soil of a surrogate
/// @param largest_ratio that is simulated [-]
std::vector<std::string> left_out_of(const grains::Soil& soil, double largest_ratio);

/// The reported story of the largest size ratio; null for other runs.
const study::MobilityStory* nearest_surrogate(const std::vector<study::MobilityStory>& stories);

/// The verdict of surrogates of one soil at several size ratios; nothing for other runs.
std::vector<std::string> verdict_by_ratio(const std::vector<study::MobilityStory>& stories);

/// The soil and its surrogate side by side; nothing for other runs.
std::optional<figures::PageTable> tabulate_surrogate(const std::vector<study::MobilityStory>& stories);

} // namespace suffuse::answer
