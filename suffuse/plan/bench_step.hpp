#pragma once
// The speed of the time step on a packing that is sheared slowly, with the physics that it was reached at.

#include "suffuse/plan/bench_shear.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>

namespace suffuse::plan {

struct BenchStepSpec {
    BenchPacking packing;
    ShearSpec shear;
    std::int64_t steps = 2000; ///< that are timed
};

struct BenchStepResult {
    dem::Mode mode = dem::Mode::Reference;
    int threads = 1;
    std::int64_t grains = 0, steps = 0;
    std::int64_t contacts_before = 0, contacts = 0; ///< touching, before and after the timed steps
    double seconds = 0;                             ///< of the timed steps
    double steps_per_second = 0, particle_steps_per_second = 0, contact_steps_per_second = 0;
    double ns_per_contact = 0;               ///< wall time of a step over its touching contacts [ns]
    std::int64_t rebuilds = 0;               ///< neighbor searches within the timed steps
    std::int64_t contact_tables = 0;         ///< contact tables made from their pairs, likewise
    double candidates_per_contact = 0;       ///< pairs that a step looks at / touching contacts [-]
    std::uint64_t state_hash = 0;            ///< after the timed steps
    double void_ratio = 0, coordination = 0; ///< [-]
    Mat3 stress;                             ///< compression positive [Pa]
    double mean_stress = 0;                  ///< [Pa]
    double unbalanced_force = 0;             ///< over grains with at least two contacts [-]
    double unbalanced_force_yade = 0;        ///< over all grains [-]
    double max_overlap_ratio = 0;            ///< [-]
    double bytes_per_grain = 0;              ///< resident in the timed steps, beyond what the program had before
    double peak_bytes_per_grain = 0;         ///< the most, while tables were made
    std::int64_t settle_steps = 0;           ///< before the timed steps
    double settle_seconds = 0;
};

/// @throws as settle_for_shear.
BenchStepResult bench_step(const BenchStepSpec& spec);

void to_json(nlohmann::json& json, const BenchStepResult& result);

} // namespace suffuse::plan
