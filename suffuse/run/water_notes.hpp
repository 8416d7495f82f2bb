#pragma once
// Warnings and flaws of the verbs with water: what the flow or the probe found that its reader must know.

#include "suffuse/erosion/detachment.hpp"
#include "suffuse/flow/seepage.hpp"
#include "suffuse/run/stage_work.hpp"

#include <string>

namespace suffuse::run {

/// Whose flow it is, where that matters, and where the law of conductance is known to be far off.
/// @param when "of the sample", "after pass 2"
/// @param would_resolve whether the case leaves it to the flow to be resolved
void note_network(
    StageWork& work, const std::string& when, const flow::FlowSource& source, double porosity, bool would_resolve
);

/// @param closed with grains by id
void note_closed_voids(StageWork& work, const std::string& when, const flow::ClosedVoids& closed);

/// Where the water's inertia, which slow flow leaves out, would take much of the flux.
void note_fast_water(StageWork& work, const std::string& when, double gradient, double reynolds, double porosity);

/// What is to be said of a gradient so steep that fines hit others before they are judged, with what to do; else empty.
std::string describe_hits(const erosion::ProbeResult& probe);

/// @param decides whether the probe says what leaves
void note_probe(StageWork& work, const erosion::DetachSpec& rule, const erosion::ProbeResult& probe, bool decides);

} // namespace suffuse::run
