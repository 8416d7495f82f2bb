#pragma once
// What a run knows of a soil that a grading does not show: the share of the stress that its fines carry.

#include "suffuse/stability/critical_gradient.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace suffuse::job {

/// Of the samples of one soil, before anything was taken out.
struct SampleStress {
    double alpha = 0;     ///< mean over the samples [-]
    double deviation = 0; ///< standard deviation [-]
    int samples = 0;
    double porosity = 0;                      ///< mean [-]
    double grain_density = 0;                 ///< [kg/m3]
    std::string stage;                        ///< that left them so: "initial"
    std::optional<double> specified_gradient; ///< the first that a stage of theirs is under
};

/// @param soil of the run's case; empty: the one that it has
/// @throws CaseError, StateError where the folder holds no run, or no such soil, or none with fines under stress
SampleStress read_sample_stress(const std::filesystem::path& run, const std::string& soil = {});

/// The same soil under upward seepage, with what the run knows of it where the user says nothing.
/// @param gradient, porosity, density as specified; the run's unless given
stability::Seepage seepage_of(
    const SampleStress& stress, std::optional<double> gradient, std::optional<double> porosity,
    std::optional<double> density
);

/// "alpha = 0.29 ± 0.02 of 3 samples of runs/my-0001 (stage initial)".
std::string words_of(const SampleStress& stress, const std::string& run);

} // namespace suffuse::job
