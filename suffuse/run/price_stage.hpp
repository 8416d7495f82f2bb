#pragma once
// What one stage takes: steps, memory, and time beside the steps. Strain-driven steps follow from the strain, the
// inertial number and the time step; relaxations and settling are ranges seen in the runs of
// tests/reference/planned_runs.csv, which a test holds this to.

#include "suffuse/casefile/case.hpp"
#include "suffuse/run/machine_speed.hpp"
#include "suffuse/run/range.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace suffuse::run {

/// What is known of a sample at the end of a stage before it is run.
struct PricedSample {
    std::int64_t grains = 0; ///< before any erosion
    Range left{1, 1};        ///< of them, after those planned [-]
    double smallest = 0;     ///< radius [m]
    double median = 0;       ///< diameter by mass [m]
    double pressure = 100e3;
    double porosity = 0.4;
    double density = 2600;
    double pair_time_step = 0; ///< stable for one pair of the smallest grains [s]
    std::int64_t coarse = 0;
    std::optional<double> fines_content; ///< of a sample that was drawn [-]
};

struct StagePrice {
    Range steps;
    Range seconds;             ///< beside the steps [s]
    double memory_a_grain = 0; ///< [B]
    std::string basis;         ///< where the steps come from, in words
    Range left = {1, 1};       ///< of the grains, when it begins [-]
};

/// The price of a stage; `sample` goes from its start to its end.
/// @throws IoError, CaseError where a packing cannot be read or a soil cannot be sampled.
StagePrice price_stage(
    const casefile::Case& what, const casefile::Variant& variant, const casefile::Stage& stage, PricedSample& sample
);

/// Wall time of a stage on a machine [s].
Range seconds_of(const StagePrice& price, double grains, const MachineSpeed& speed);

} // namespace suffuse::run
