#pragma once
// How long a run will still take: the plan's ranges, corrected by what the finished stages took against them.

#include "suffuse/run/plan.hpp"
#include "suffuse/run/runner.hpp"

namespace suffuse::apps {

class TimeLeft {
public:
    explicit TimeLeft(run::RunPlan plan) : plan_(std::move(plan)) {}

    /// Learns from a stage that is done.
    void learn(const run::Progress& progress);

    /// From where the run is now [s].
    [[nodiscard]] run::Range left(const run::Progress& progress) const;

private:
    [[nodiscard]] const run::StageEstimate* stage_of(const run::Progress& progress) const;

    /// Wall time over the middle of the plan's range, of the stages that are done [-].
    [[nodiscard]] double correction() const;

    run::RunPlan plan_;
    double taken_ = 0, expected_ = 0; ///< by the stages that are done [s]
};

} // namespace suffuse::apps
