#pragma once
// What a case will cost before it is run: steps, time, memory and disk of every stage, always as a range. Strain-driven
// steps follow from the strain, the inertial number and the time step; relaxations are ranges seen on samples of 500 to
// 10,000 grains; time is priced by measure_speed.

#include "suffuse/casefile/case.hpp"
#include "suffuse/run/machine_speed.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace suffuse::run {

struct Range {
    double least = 0, most = 0;

    Range& operator+=(const Range& other) { return least += other.least, most += other.most, *this; }
};

struct StageEstimate {
    std::string study; ///< folder of the variant, as in Progress
    std::string stage, verb;
    std::int64_t grains = 0; ///< at most: what erosion takes is not known beforehand
    Range steps;
    Range seconds;     ///< wall time [s]
    double memory = 0; ///< while it runs, beyond the process itself [B]
    double disk = 0;   ///< that it leaves [B]
    std::string basis; ///< where the steps come from, in words
};

struct RunPlan {
    MachineSpeed speed;
    std::vector<StageEstimate> stages; ///< in the order in which they run
    int studies = 0;
    Range steps;
    Range seconds;     ///< wall time [s]
    double memory = 0; ///< of the greediest stage, the process included [B]
    double disk = 0;   ///< of all stages [B]
};

/// The most grains that a stage of the case holds. @throws as plan_run.
std::int64_t largest_sample(const casefile::Case& what);

/// @throws IoError, CaseError where a packing cannot be read or a soil cannot be sampled.
RunPlan plan_run(const casefile::Case& what, const MachineSpeed& speed);

void to_json(nlohmann::json& json, const RunPlan& plan);

} // namespace suffuse::run
