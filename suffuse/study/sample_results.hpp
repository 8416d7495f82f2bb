#pragma once
// The few numbers that one sample came to, read off its finished stages.

#include "suffuse/study/study_outcome.hpp"

namespace suffuse::study {

struct SampleResults {
    std::map<Result, double> value;
    std::set<Result> at_most; ///< of these: upper bounds, as motion had not ended when the gradient rose
    std::string probe;        ///< stage that first movements are of; empty: none
};

SampleResults results_of_sample(const std::vector<record::FinishedStage>& stages, const casefile::Variant& sample);

/// The first erosion of a sample, and those that follow it; empty where none eroded it.
Erosions erosions_of_sample(const std::vector<record::FinishedStage>& stages, const casefile::Variant& sample);

/// Permeability after the erosions of a sample over that before, with what it is known to be off by.
struct PermeabilityAfter {
    double before = 0, after = 0;      ///< [m2]
    double change = 1;                 ///< after / before [-]
    std::optional<double> known_error; ///< of each, at most; nothing where no bound is known [-]
    bool before_is_too_high = false, after_is_too_high = false; ///< known to be, by is_too_high
};

/// Of the passes of one erosion; nothing without a permeability on both sides.
std::optional<PermeabilityAfter>
permeability_after(const erosion::ErosionResult& erosion, flow::Conductance conductance);

} // namespace suffuse::study
