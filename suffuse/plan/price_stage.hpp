#pragma once
// What one stage takes: steps, memory, and time besides the steps. Strain-driven steps follow from the strain, the rate
// and the time step that the expected contact network allows, their seconds from how many grains carry load;
// relaxations and settling are ranges seen in runs. A test holds all of it to tests/reference/planned_runs.csv.

#include "suffuse/base/range.hpp"
#include "suffuse/casefile/case.hpp"
#include "suffuse/plan/machine_speed.hpp"
#include "suffuse/plan/priced_sample.hpp"

#include <string>

namespace suffuse::plan {

inline constexpr double grain_memory = 1000; // [B]

struct StagePrice {
    Range steps = {};
    Range reference_steps = {}; ///< more of them, in reference mode whatever the mode of the case
    Range seconds = {};         ///< besides the steps [s]
    double memory_a_grain = 0;  ///< [B]
    std::string basis;          ///< where the steps come from, in words
    std::string kind = {};      ///< of the verb, where its kinds cost differently
    bool only_pushes = false;   ///< contacts have no friction
    Range more_work = {};       ///< of a step, beyond that of the sample at the stage's end
    Range work = {}; ///< of a step, in grains of the packing that measure_speed steps; filled in by price_stage
};

/// The price of a stage; `sample` goes from its start to its end.
/// @throws IoError, CaseError where a packing cannot be read or a soil cannot be sampled.
StagePrice price_stage(
    const casefile::Case& what, const casefile::Variant& variant, const casefile::Stage& stage, PricedSample& sample
);

/// Steps until balanced, and then the patience of the case.
Range waited(const casefile::Case& what, const Range& steps);

/// Strain of each axis from one porosity to another, at least a little [-].
double strain_between(double start, double end);

/// Wall time of a stage on a machine [s].
Range seconds_of(const StagePrice& price, const MachineSpeed& speed);

} // namespace suffuse::plan
