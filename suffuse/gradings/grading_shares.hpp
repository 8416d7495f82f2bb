#pragma once
// From what sieves retain to what passes them: shares or masses, each sieve's own or cumulative.

#include "suffuse/gradings/grading_curve.hpp"
#include "suffuse/gradings/grading_rows.hpp"

#include <optional>
#include <vector>

namespace suffuse::gradings {

/// The points of a soil's curve in the order of its rows; empty where its numbers do not say which they are, or of
/// which mass they are a share, which is reported. The soil then has the meaning that was found.
std::optional<std::vector<GradingPoint>> find_passing(SievedSoil& soil, Problems& problems);

/// "retained on each sieve alone".
const char* words_of(ShareMeaning meaning);

/// Gives columns of one table whose headings say nothing the only meaning that all their numbers satisfy.
void agree_on_meaning(std::vector<SievedSoil>& soils);

} // namespace suffuse::gradings
