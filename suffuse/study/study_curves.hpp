#pragma once
// What a study measured, as curves over its sweep: for each stage and each set of sweep values every number of the
// stage, seed by seed, with mean and scatter. What figures with error bars, thresholds and findings are made from.

#include "suffuse/casefile/case.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace suffuse::study {

/// One number of one stage at one set of sweep values, over the seeds.
struct Scatter {
    std::vector<double> of_seed;   ///< in the order of SweepPoint::seed; not a number where that seed has none
    double mean = 0;               ///< over the seeds that have it
    double standard_deviation = 0; ///< of the sample (n - 1); 0 for a single seed
    int seeds = 0;                 ///< that have it
};

/// @param of_seed not a number where a seed has none
Scatter scatter_of(std::vector<double> of_seed);

/// Whether several seeds have it, and all the same to the last bit.
bool agree(const Scatter& scatter);

/// "12.3 ± 1.4": the mean, and the standard deviation of several seeds unless it is below a thousandth of the mean. The
/// mean ends where the deviation does. "–" where no seed has the number.
std::string with_scatter(const Scatter& value, double factor = 1, int digits = 3);

/// ", in 1 of 3 seeds" where some have none; nothing where all have it.
std::string seeds_that_have(const Scatter& scatter);

/// "fines content", "gradient", "friction": a swept key by its last part, in words; the whole path of its table, too,
/// where another of `keys` ends alike: "stage.initial pressure".
std::string key_in_words(const std::string& key, const std::vector<std::string>& keys = {});

/// One set of sweep values.
struct SweepPoint {
    std::vector<double> value;        ///< of each swept key, in SI; not a number for words
    std::vector<std::string> written; ///< as in the case
    std::vector<std::uint64_t> seed;  ///< of the replicates that are there
    /// By the names of stage.json; those of inner objects are joined by points: "contact_share.LS".
    std::map<std::string, Scatter> number;
    std::map<std::string, casefile::Scalar> of_row; ///< values of the row of `rows` that it chooses, by their keys
};

/// One stage over the sweep, in the order of the values.
struct StageCurve {
    std::string stage;
    std::vector<SweepPoint> points;
};

struct StudyCurves {
    std::string study;
    std::vector<std::string> keys; ///< that are swept
    int replicates = 1;            ///< specified
    std::vector<StageCurve> stages;

    /// Null where the study has no such stage.
    [[nodiscard]] const StageCurve* find(const std::string& stage) const;
};

} // namespace suffuse::study
