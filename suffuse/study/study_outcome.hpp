#pragma once
// What the samples of each study came to, in a few numbers a sample: over the seeds, and over what the study sweeps.
// Of a sample that was eroded, probed or tested several times the first in the case's order counts.

#include "suffuse/record/finished_stage.hpp"
#include "suffuse/study/erosion_span.hpp"
#include "suffuse/study/study_curves.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace suffuse::study {

/// The numbers, those that answer more of a question first.
enum class Result {
    Safety,             ///< specified gradient against the one that moves 1 % of the fines [-]
    FirstMovement,      ///< gradient that moves 1 % of the fines [-]
    ErodedMass,         ///< carried out by water, of the mass before [-]
    RemovedMass,        ///< taken out without water, of the mass before [-]
    PermeabilityChange, ///< after over before, of an erosion [-]
    StressChange,       ///< of the mean stress at constant volume, the largest of a pass [-]
    RemovalStrain,      ///< volume that a removal without water costs, contraction positive [-]
    Strength,           ///< highest deviator stress of the first test to an end [Pa]
    Permeability,       ///< of the first flow, along it [m2]
    VoidRatio           ///< at rest under stress, before water and tests [-]
};

inline constexpr int results = static_cast<int>(Result::VoidRatio) + 1;

/// How a result is called, and drawn.
struct ResultScale {
    const char* label;
    const char* unit; ///< "" where it has none
    double factor;    ///< from SI to that unit
    double least;     ///< change that counts: less is the balance's noise, or rounding [SI]
};

ResultScale scale_of(Result which);

/// The samples at one set of sweep values that have a result.
struct OutcomePoint {
    SweepPoint at;                                 ///< its values and seeds; without numbers
    std::vector<const casefile::Variant*> samples; ///< in the order of the seeds
    std::map<Result, Scatter> result;              ///< those that one sample at least has
    std::set<Result> at_most;           ///< of these: upper bounds, as in one sample at least motion had not ended
    std::optional<ErosionSpan> erosion; ///< that the samples have in common; nothing where none was eroded

    [[nodiscard]] const Scatter* find(Result which) const;

    [[nodiscard]] bool is_at_most(Result which) const { return at_most.contains(which); }
};

struct StudyOutcome {
    const casefile::Study* study = nullptr;
    std::vector<std::string> keys;    ///< that are swept
    std::vector<OutcomePoint> points; ///< with a result; where no sample has one, with a finished stage
    std::size_t specified = 0;        ///< points that the case has
    std::string first_probe; ///< stage that first movements are of, where others probe the fines, too; else empty

    [[nodiscard]] std::size_t samples() const;
    /// Seeds of the point that has most of them, and of the one that has fewest.
    [[nodiscard]] std::size_t seeds() const;
    [[nodiscard]] std::size_t fewest_seeds() const;

    /// All points, with those that have no result.
    [[nodiscard]] std::size_t all_points() const { return std::max(specified, points.size()); }

    /// Whether at least half of the points have it.
    [[nodiscard]] bool has(Result which) const;
};

/// One for each study with a finished stage, in the order of the case.
std::vector<StudyOutcome> gather_outcomes(const casefile::Case& what, const std::vector<record::FinishedStage>& stages);

/// The study with the most samples, of those the one with the most points; null without one.
const StudyOutcome* main_outcome(const std::vector<StudyOutcome>& outcomes);

/// The first of the results that the study has over its points, at best one that its sweep changes.
std::optional<Result> main_result(const StudyOutcome& outcome);

/// How the means of a result differ over a sweep.
enum class Difference {
    Clear,         ///< by more than by chance, a twentieth of the mean and the least change that counts
    WithinScatter, ///< by no more than by chance: the 90 % interval of the mean of differences by seed; without two
                   ///< pairs of one seed, twice the largest deviation
    Small          ///< by less than counts; of single samples nobody knows the scatter
};

/// A result over a sweep, and the points and samples that it stands for: those that have it.
struct SweepEffect {
    Difference difference = Difference::Small;
    const OutcomePoint *first = nullptr, *last = nullptr; ///< in the order of the points; null where none has it
    const OutcomePoint *least = nullptr, *most = nullptr; ///< by their means
    std::size_t points = 0;                               ///< that have it
    int fewest_samples = 0, most_samples = 0;             ///< of these points

    [[nodiscard]] bool has_scatter() const { return most_samples > 1; }
};

SweepEffect effect_of_sweep(const StudyOutcome& outcome, Result which);

/// Whether that is a clear difference.
bool depends_on_sweep(const StudyOutcome& outcome, Result which);

/// "gradient": what is swept; of two keys "gradient and friction".
std::string keys_in_words(const StudyOutcome& outcome);

} // namespace suffuse::study
