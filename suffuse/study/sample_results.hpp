#pragma once
// The few numbers that one sample came to, read off its finished stages.

#include "suffuse/study/study_outcome.hpp"

namespace suffuse::study {

std::map<Result, double>
results_of_sample(const std::vector<record::FinishedStage>& stages, const casefile::Variant& sample);

/// Permeability after the erosions of a sample over that before, with what it is known to be off by.
struct PermeabilityAfter {
    double before = 0, after = 0;      ///< [m2]
    double change = 1;                 ///< after / before [-]
    std::optional<double> known_error; ///< of the one after, at most; nothing where no bound is known [-]
    bool is_too_high = false;          ///< known to be, for fines seem to raise it or the packing is too open for it
};

/// Of the passes of one erosion; nothing without a permeability on both sides.
std::optional<PermeabilityAfter>
permeability_after(const erosion::ErosionResult& erosion, flow::Conductance conductance);

} // namespace suffuse::study
