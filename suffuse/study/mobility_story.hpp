#pragma once
// Gradients that move the fines of a run's samples against their weight: the samples of one stage that differ in
// their seed alone, side by side.

#include "suffuse/record/finished_stage.hpp"
#include "suffuse/study/study_curves.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace suffuse::study {

/// One soil under one flow.
struct MobilityStory {
    const record::FinishedStage* first = nullptr;
    std::string name;                                      ///< "mobility, FC 10 %": the same for all its samples
    std::vector<const erosion::MobilityResult*> of_sample; ///< at least one
    Scatter moves_1, moves_10, moves_50, heave;            ///< gradients; not a number where a sample has none [-]
    bool at_most_1 = false, at_most_10 = false, at_most_50 = false; ///< of one sample at least it is an upper bound
    bool ends_in_motion = false; ///< of one sample at least the last gradient moved less than 1 %, and rose in motion
    Scatter skempton_brogan, fines_heave;     ///< gradients, likewise
    Scatter alpha_fines;                      ///< [-]
    Scatter safety;                           ///< factor of safety against the specified gradient, as moves_1 [-]
    Scatter moved_at_specified;               ///< share of the fines' mass [-]
    bool moved_at_specified_at_least = false; ///< of one sample at least it is a lower bound
    std::optional<double> specified_gradient; ///< of the first
    std::size_t lifted_at_specified = 0;      ///< samples whose whole soil floats there
    std::optional<double> safety_at_least; ///< where a ramp ends before it moves 1 %: the least of all samples, if any
    bool sifts = false;                    ///< in one of them at least
    double hold_at_most = 100;             ///< of a gradient under which motion does not end, in units of time [-]
    double moved = 0.5;                    ///< along the flow, beyond which a grain counts as mobile [diameters]

    [[nodiscard]] const erosion::MobilityResult& one() const { return *of_sample.front(); }

    /// Null where the samples are of the soil itself.
    [[nodiscard]] const grains::Surrogate* surrogate() const;
};

/// Whether more than half of the samples have it.
bool is_met(const Scatter& value, const MobilityStory& story);

/// Of the soil as it was: an erosion gives, of its passes up to the first from which fines left, the one of the highest
/// ramp. Null where fines have no weight.
const erosion::MobilityResult* mobility_of(const record::FinishedStage& stage);

/// That this soil has to bear: nothing where a later pass of an erosion has a higher one.
std::optional<double> specified_gradient(const record::FinishedStage& stage);

/// In the order of the stages.
std::vector<MobilityStory> gather_mobility(const std::vector<record::FinishedStage>& stages);

/// The one that the report shows first; null where fines have no weight.
const MobilityStory* main_mobility(const std::vector<MobilityStory>& stories);

} // namespace suffuse::study
