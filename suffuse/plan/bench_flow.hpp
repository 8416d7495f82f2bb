#pragma once
// The seconds of each part of a flow solution on a packing brought from elsewhere and the memory that it takes, with
// the permeability found.

#include "suffuse/flow/fluid.hpp"
#include "suffuse/plan/bench_packing.hpp"

#include <nlohmann/json.hpp>

namespace suffuse::plan {

struct BenchFlowSpec {
    BenchPacking packing;
    double gradient = 0.05;     ///< hydraulic gradient [-]
    Vec3 direction = {1, 0, 0}; ///< where the water goes
    flow::Conductance conductance = flow::Conductance::Bounded;
};

struct BenchFlowResult {
    int threads = 1;
    std::size_t grains = 0, pores = 0, throats = 0;
    double triangulate = 0, conductance = 0, forces = 0; ///< wall time [s]
    double set_up = 0, solve = 0;                        ///< of the multigrid, and the solution by it, likewise [s]
    double total = 0;                                    ///< of the whole [s]
    double peak_bytes_per_grain = 0;                     ///< beyond what the program had before the flow
    int iterations = 0;                                  ///< of the solution
    double permeability = 0;                             ///< along the direction [m2]
    Vec3 mean_velocity;                                  ///< superficial [m/s]
    double residual = 0;                                 ///< of the linear solve [-]
    double force_sum_error = 0;                          ///< relative to -V grad p [-]
};

/// @throws as load_bench_packing and flow::solve_seepage.
BenchFlowResult bench_flow(const BenchFlowSpec& spec);

void to_json(nlohmann::json& json, const BenchFlowResult& result);

} // namespace suffuse::plan
