#pragma once
// What the benchmarks of the step time: a packing settled with the example's law at 100 kPa, then sheared slowly,
// lateral stress held by the servo [reference, section 6].

#include "suffuse/dem/step.hpp"
#include "suffuse/plan/bench_packing.hpp"

#include <cstdint>

namespace suffuse::plan {

struct ShearSpec {
    dem::Mode mode = dem::Mode::Reference;
    double time_step = 4.1e-8; ///< [s]
    double pressure = 100e3;   ///< of the settled state, and then of the lateral stress [Pa]
    double strain_rate = 10;   ///< axial, along z, compression positive [1/s]
};

struct BenchShear {
    dem::World world; ///< settled, its grains along the curve
    dem::StepCaches caches;
    dem::StepPlan plan; ///< of the shear
    std::int64_t settle_steps = 0;
    double settle_seconds = 0;
};

/// @throws as load_bench_packing; StateError where the packing does not settle at the pressure.
BenchShear settle_for_shear(const BenchPacking& packing, const ShearSpec& spec);

} // namespace suffuse::plan
