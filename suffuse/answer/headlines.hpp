#pragma once
// The few numbers of an erosion, and of a study over the fines content, that are shown large beside the answer.

#include "suffuse/erosion/result.hpp"
#include "suffuse/study/finding.hpp"
#include "suffuse/study/fines_thresholds.hpp"

#include <optional>
#include <vector>

namespace suffuse::answer {

/// A number for the eye: shown large beside the answer.
struct Headline {
    std::string value;  ///< "13.5 %"
    std::string label;  ///< "of the mass eroded"
    std::string detail; ///< "in 2 passes at i = 0.05"; may be empty
};

/// Eroded mass, change of permeability, largest loss of mean stress at constant volume: those that the run can tell.
std::vector<Headline> erosion_headlines(const erosion::ErosionResult& erosion);

/// How many findings were met; nothing without findings.
std::optional<Headline> findings_headline(const std::vector<study::Finding>& findings);

/// The fines contents of lowest void ratio, loose and densest, and those from which on fines carry: those that were
/// found.
std::vector<Headline> fines_headlines(const std::vector<study::ContentThreshold>& thresholds);

} // namespace suffuse::answer
