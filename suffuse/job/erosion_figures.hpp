#pragma once
// The figures of an erosion, and what the soil's grading alone says of it.

#include "suffuse/report/page.hpp"
#include "suffuse/study/erosion_story.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace suffuse::job {

/// Figures 7 to 14 and our own, as far as the run has what they show.
std::vector<figures::Figure>
draw_erosion(const casefile::Case& what, const std::filesystem::path& folder, const study::ErosionStory& story);

/// Internal stability of a sample's soil by its grading, for the section "Soils".
void show_stability(const casefile::Case& what, const grains::Soil& soil, report::ReportData& data);

/// The soil's grading next to that of the sample from which a stage started, for the same section.
std::optional<figures::Figure>
draw_grading(const casefile::Case& what, const std::filesystem::path& folder, const record::FinishedStage& stage);

/// A sample's grading at sizes evenly spaced on the logarithmic axis, and at those of its soil: the corners of the
/// specified curve and the limit of the fines, on both sides of which a gap may lie.
grains::Grading sampled_grading(const std::vector<double>& radius, const std::optional<grains::Soil>& soil);

} // namespace suffuse::job
