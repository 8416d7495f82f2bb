#pragma once
// What the samples of each study came to, in a few numbers a sample: over the seeds, and over what the study sweeps.
// Of a sample that was eroded, probed or tested several times the first in the case's order counts.

#include "suffuse/record/finished_stage.hpp"
#include "suffuse/study/study_curves.hpp"

#include <map>
#include <optional>
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

/// "fines content", "gradient", "friction": a swept key by its last part, in words.
std::string key_in_words(const std::string& key);

/// The samples at one set of sweep values.
struct OutcomePoint {
    SweepPoint at;                                 ///< its values and seeds; without numbers
    std::vector<const casefile::Variant*> samples; ///< in the order of the seeds
    std::map<Result, Scatter> result;              ///< those that one sample at least has

    [[nodiscard]] const Scatter* find(Result which) const;
};

struct StudyOutcome {
    const casefile::Study* study = nullptr;
    std::vector<std::string> keys; ///< that are swept
    std::vector<OutcomePoint> points;

    [[nodiscard]] std::size_t samples() const;
    /// Seeds of the point that has most of them.
    [[nodiscard]] std::size_t seeds() const;
    /// Whether more than half of the points have it.
    [[nodiscard]] bool has(Result which) const;
};

/// One for each study with a finished stage, in the order of the case.
std::vector<StudyOutcome> gather_outcomes(const casefile::Case& what, const std::vector<record::FinishedStage>& stages);

/// The study with the most samples, of those the one with the most points; null without one.
const StudyOutcome* main_outcome(const std::vector<StudyOutcome>& outcomes);

/// The first of the results that the study has over its points, at best one that its sweep changes.
std::optional<Result> main_result(const StudyOutcome& outcome);

/// Whether the means differ by more than the seeds do: twice the largest deviation, a twentieth of the mean, and the
/// least change that counts.
bool depends_on_sweep(const StudyOutcome& outcome, Result which);

} // namespace suffuse::study
