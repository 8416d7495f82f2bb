#pragma once
// Parts of the sentences and headlines on gradients that move fines.

#include "suffuse/study/mobility_story.hpp"

#include <optional>
#include <string>

namespace suffuse::answer {

/// "0.30 ± 0.02"; a single sample has no deviation.
std::string gradient_text(const study::Scatter& gradient);

/// Of a share that sentences give as less than a tenth of a percent.
bool is_almost_nothing(double share);

/// "12 %", "less than 0.1 %".
std::string moved_text(double share);

/// Largest over the samples: "12 %", "up to 12 %".
std::string sifting_text(const study::MobilityStory& story);

/// "half a diameter": what a grain moves along the flow before it counts.
std::string distance_text(const study::MobilityStory& story);

/// Its highest gradient.
double end_of_ramp(const study::MobilityStory& story);

/// Whether the ramp goes as far as the gradient that lifts the whole soil.
bool goes_to_heave(const study::MobilityStory& story);

/// "below heave", "up to i = 1.20": how far the ramp goes.
std::string end_text(const study::MobilityStory& story);

/// The gradient of heave over the specified one: "0.81".
std::string heave_factor_text(const study::MobilityStory& story);

/// Ramps know a gradient to 0.01.
bool is_almost_none(double gradient);

/// What Skempton and Brogan's rule makes of the specified gradient; nothing where it does not apply.
std::optional<double> safety_by_rule(const study::MobilityStory& story);

/// Whether of rule and motion one calls the specified gradient safe, and the other does not.
bool do_disagree(const study::MobilityStory& story);

} // namespace suffuse::answer
