#pragma once
// The few numbers of a run that are shown large below its verdict, each with what is known of its uncertainty.

#include "suffuse/erosion/result.hpp"
#include "suffuse/flow/fluid.hpp"
#include "suffuse/study/finding.hpp"
#include "suffuse/study/fines_thresholds.hpp"
#include "suffuse/study/study_outcome.hpp"

#include <optional>
#include <vector>

namespace suffuse::answer {

/// A number for the eye: a card below the verdict.
struct Headline {
    std::string value;        ///< "13 %"
    std::string label;        ///< "Mass carried out"
    std::string detail;       ///< "in two passes at i = 0.05; no replicate"; may be empty
    std::string spread = {};  ///< "± 0.03", small behind the value
    std::string lead = {};    ///< "up to", small before it
    std::string caution = {}; ///< a warning that touches this number
    int samples = 0;          ///< that it is the mean of, 1 of one alone; 0: no number of samples
};

/// Adds that there is no replicate where nothing else is known of the uncertainty, or that samples agree.
Headline with_certainty(Headline headline, const study::Scatter& value);

/// Of an erosion: mass carried out, permeability, loss of mean stress at constant volume; those that the run has.
/// @param outcome over the seeds; of one sample where null
std::vector<Headline>
erosion_headlines(const erosion::ErosionResult& erosion, const flow::Fluid& fluid, const study::OutcomePoint* outcome);

/// Of a study over what it sweeps: its results at one end and at the other, with their deviations.
std::vector<Headline> sweep_headlines(const study::StudyOutcome& outcome, const flow::Fluid& fluid);

/// Of a run without water that moves fines: strength, permeability, void ratio.
std::vector<Headline> state_headlines(const study::OutcomePoint& outcome, const flow::Fluid& fluid);

/// How many findings were met; nothing without findings.
std::optional<Headline> findings_headline(const std::vector<study::Finding>& findings);

/// The fines contents of lowest void ratio, loose and densest, and those from which on fines carry: those that most
/// seeds have.
std::vector<Headline> fines_headlines(const std::vector<study::ContentThreshold>& thresholds);

/// "in two passes", "in one to three passes".
std::string passes_in_words(const study::ErosionSpan& span);

/// "gradient 0.1, friction 30°": all that is swept.
std::string point_in_words(const study::StudyOutcome& outcome, const study::OutcomePoint& point);

/// "all 3 points", "2 of 3 points": those that a result over a sweep stands for.
std::string points_in_words(const study::StudyOutcome& outcome, const study::SweepEffect& effect);

/// "one sample", "three seeds", "one to three seeds": of each point.
std::string seeds_in_words(const study::StudyOutcome& outcome);

/// "10 %", "0.05", "30°": a value of a swept key as written in the case.
std::string value_in_words(const study::SweepPoint& at, std::size_t key);

/// The value of a result at one point, as reported: "13 %", "0.30", "338 kPa".
std::string result_text(study::Result which, double value, const flow::Fluid& fluid);

/// Of the mean at a point: "0.30", "≤ 0.30" where it is an upper bound. @param bound in front of such a one
std::string
mean_text(const study::OutcomePoint& point, study::Result which, const flow::Fluid& fluid, const char* bound = "≤ ");

/// Whether its text is "none".
bool is_none(study::Result which, double value);

/// "± 2 %" in the same unit; empty for a single sample.
std::string result_spread(study::Result which, const study::Scatter& value, const flow::Fluid& fluid);

/// "Mass carried out", "Peak strength": what a card says.
std::string result_label(study::Result which);

} // namespace suffuse::answer
