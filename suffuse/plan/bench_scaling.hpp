#pragma once
// How far the time step and the flow would scale, seen on one thread: of each phase the share outside parallel loops,
// and the speed-up that this share and the size of the blocks allow (base/loop_meter.hpp). What memory bandwidth, a
// second socket and waiting for each other take from it is not in these numbers.

#include "suffuse/plan/bench_shear.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace suffuse::plan {

struct BenchScalingSpec {
    BenchPacking packing;
    ShearSpec shear;
    std::int64_t steps = 500; ///< of slow shear, measured for each number of threads
    std::vector<int> threads = {8, 16, 64};
};

struct ScalingPhase {
    std::string name;
    double seconds = 0;             ///< of one thread that works as one [s]
    double serial_share = 0;        ///< of them outside parallel loops [-]
    std::int64_t loops = 0;         ///< each of which has to be begun and waited for
    std::map<int, double> speed_up; ///< by the number of threads [-]
};

struct ScalingWork {
    std::vector<ScalingPhase> phases;
    ScalingPhase all;
};

struct BenchScalingResult {
    std::int64_t grains = 0, steps = 0;
    ScalingWork step, flow;
};

/// Settles on all threads, then works on the calling thread alone. @throws as bench_step and bench_flow.
BenchScalingResult bench_scaling(const BenchScalingSpec& spec);

void to_json(nlohmann::json& json, const BenchScalingResult& result);

} // namespace suffuse::plan
