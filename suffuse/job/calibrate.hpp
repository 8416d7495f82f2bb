#pragma once
// A calibration from its case to what the parameters are: rounds of samples, each a run of its own, whose results say
// where the next round looks.

#include "suffuse/calibration/interval.hpp"
#include "suffuse/casefile/calibration_case.hpp"
#include "suffuse/job/laboratory_curve.hpp"
#include "suffuse/job/sample_fit.hpp"
#include "suffuse/record/run_outcome.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace suffuse::job {

/// A round under way: what is to be run, and where.
struct CalibrationRound {
    std::string name; ///< "round-1", "held-out"
    int number = 1;   ///< from 1
    int rounds = 1;   ///< at most
    casefile::Case samples;
    std::filesystem::path folder; ///< of the run, in that of the calibration
};

struct CalibrationResult;

struct CalibrationOptions {
    std::filesystem::path folder;
    /// Runs the samples; failures of single ones are no error. @return false where it was stopped before its end
    std::function<bool(const CalibrationRound&)> run;
    /// Sees what is known after each round but the last; may be empty.
    std::function<void(const CalibrationResult&)> on_round = {};
};

struct SampleCurve {
    casefile::CalibrationSample sample;
    std::vector<double> curve; ///< empty where the sample failed
    std::string failure;
};

/// A target with its curves.
struct TargetFit {
    casefile::CalibrateTarget target;
    LaboratoryCurve laboratory;
    std::vector<double> model;           ///< the measured parts at the likeliest parameters; held out: mean of samples
    std::vector<double> model_deviation; ///< of it: the error of the emulator; held out: scatter of the samples
    std::vector<double> seed_scatter;    ///< of it, between samples of the same parameters; empty where there are none
    int samples = 0, failed = 0;
    double band = 0; ///< half the width of what a sample lies in with 90 %, over model_deviation; infinite: not known
};

/// A measurement that would narrow an interval that these data leave wide.
enum class Remedy {
    None,
    VolumetricStrain, ///< of a test of which only stresses are there
    OtherPressure,    ///< the same test at another pressure
    LargerSamples,    ///< no test: more grains in each sample, for samples scatter more than all else is uncertain
    Oedometer,        ///< compression without shear
};

struct ParameterResult {
    casefile::CalibrateUnknown unknown;
    double mean = 0, low = 0, high = 0, best = 0; ///< in SI; mean of a logarithmic range: of the logarithms
    calibration::Interval interval;               ///< of the unit cube
    Remedy remedy = Remedy::None;
};

struct RoundResult {
    int designs = 0, samples = 0, failed = 0;
    double width = 1;                             ///< mean of the intervals / those of the prior, after it
    std::vector<ParameterResult> parameters = {}; ///< after it; of held-out tests none
};

struct CalibrationResult {
    bool is_complete = false; ///< else it was stopped before the first round ended, or in a later one
    std::vector<ParameterResult> parameters;
    std::vector<std::vector<double>> correlations;
    std::vector<std::vector<double>> posterior; ///< values in SI, a row a sample
    double effective_samples = 0, log_likelihood = 0;
    std::vector<TargetFit> fits; ///< held-out targets last
    std::vector<RoundResult> rounds;
    std::vector<record::FailedSample> failures;
    std::vector<SampleFit> samples; ///< in the order in which they were run
};

/// Runs round after round until the intervals stop changing or the samples of the case are spent. The same case gives
/// the same bits; a round that the folder holds is taken as it is.
/// @throws StateError where too few samples of a target succeed
CalibrationResult calibrate(const casefile::CalibrationCase& what, const CalibrationOptions& options);

/// What was assumed of the records of its targets, and what was not read of them; once for each file.
std::vector<Diagnostic> warnings_of_records(const casefile::CalibrationCase& what);

/// The first round alone, to know its price.
casefile::Case first_round(casefile::CalibrationCase what);

} // namespace suffuse::job
