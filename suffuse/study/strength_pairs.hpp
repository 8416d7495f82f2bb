#pragma once
// Which tests of a run show what erosion did to the strength: the same test from a state before fines went and from one
// after, of one sample. Same means path, axis, strain, rate, the grains' inertia and the time step.

#include "suffuse/record/finished_stage.hpp"
#include "suffuse/triaxial/spec.hpp"

#include <vector>

namespace suffuse::study {

/// The test of a sample before fines went, and after.
struct TestPair {
    const record::FinishedStage *before, *after;
    const record::FinishedStage *tested, *eroded; ///< states where the two tests start
    const record::FinishedStage* intact;          ///< state before anything left
    double removed_mass;                          ///< share of the mass of the intact state [-]
    bool has_failed;                              ///< the skeleton, while fines went
};

/// In the order of the tests after.
std::vector<TestPair> find_test_pairs(const std::vector<record::FinishedStage>& stages);

/// The settings of a test of strength; null for other stages, tests that stop at a stress, and proportional paths.
const triaxial::TriaxialSpec* test_of_strength(const casefile::Stage& stage);

} // namespace suffuse::study
