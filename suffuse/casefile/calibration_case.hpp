#pragma once
// A case that calibrates, and the cases of its samples: each sample is a study of one copy, written as users write
// them.

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/casefile/calibrate_spec.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/casefile/node.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace suffuse::casefile {

struct CalibrationCase {
    CalibrateSpec spec;
    std::string title;
    std::uint64_t seed = 1;
    std::string settings;             ///< the case with --set, in one spelling
    Node base;                        ///< the case without [calibrate] and studies
    std::string folder;               ///< where its relative paths start
    std::vector<Diagnostic> warnings; ///< of the samples at both ends of the ranges
};

/// Whether the case has samples to calibrate, and no study to run.
bool calibrates(const std::string& path);

/// Only --preset and --set of `options` count. @throws CaseProblems with every problem of the case
CalibrationCase load_calibration(const std::string& path, const LoadOptions& options = {});

/// One simulation of one target.
struct CalibrationSample {
    int target = 0;             ///< row of the targets
    int number = 0;             ///< of the design; names the study and, with the target, decides the seed
    std::vector<double> shares; ///< one an unknown, from 0 to 1: value_at
};

std::string study_of(const CalibrationCase& what, const CalibrationSample& sample);

/// The values that the sample really has, in SI: those of the case file, with six digits.
std::vector<double> values_of(const CalibrationCase& what, const CalibrationSample& sample);

/// A case whose studies are these samples: `suffuse run` and `suffuse sweep` know it. Each packs a sample of the soil,
/// compacts it to its void ratio, stage "sample", and tests it, stage "test".
Case case_of_samples(const CalibrationCase& what, const std::vector<CalibrationSample>& samples);

/// The same with what is to be said of it, at the lines of the case that calibrates. @throws CaseProblems, likewise
LoadedCase load_samples(const CalibrationCase& what, const std::vector<CalibrationSample>& samples);

} // namespace suffuse::casefile
