#pragma once
// What a critical gradient rests on: every estimate of it, by name, and what makes it doubtful, with the call that
// would remove each doubt.

#include "suffuse/atlas/row.hpp"
#include "suffuse/study/mobility_story.hpp"

#include <string>
#include <vector>

namespace suffuse::answer {

/// "Upward flow moves 1 % of the fines at estimated gradients of 0.14 (...), 0.20 (simulated). Over the specified 0.3:
/// ..."; empty where there is one alone, which the verdict has.
/// @param rows of the atlas, which has an estimate for each of its densities if the soil is within it
std::string
estimates_of(const study::MobilityStory& story, const std::vector<atlas::Row>& rows = atlas::shipped_rows());

/// At most three sentences, the largest doubt first: a part or a surrogate of the soil, a narrow cell, fines that were
/// still moving, shear stress left over from the preparation. How many samples there are is reported elsewhere.
std::vector<std::string> doubts_about(const study::MobilityStory& story);

} // namespace suffuse::answer
