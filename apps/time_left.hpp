#pragma once
// How long a run will still take: the plan's ranges, corrected by what the finished stages took against them and, as
// long as there are few of these, by the pace of the one that runs; shared among the samples that run side by side.

#include "suffuse/plan/plan.hpp"
#include "suffuse/run/run_options.hpp"

#include <map>

namespace suffuse::apps {

class TimeLeft {
public:
    explicit TimeLeft(plan::RunPlan plan) : plan_(std::move(plan)) {}

    /// Learns where a sample is, and from a stage that is done.
    void see(const run::Progress& progress);

    /// From what was seen last [s].
    [[nodiscard]] Range left() const;

private:
    using Row = std::size_t;

    /// Wall time over the middle of the plan's range, of the stages that are done [-].
    [[nodiscard]] double correction() const;

    void see_refined(const run::Progress& progress);

    plan::RunPlan plan_;
    int listed_ = 0;                  ///< samples, before any was refined
    int refined_done_ = 0;            ///< samples next to them
    std::map<Row, double> running_;   ///< stage -> seconds that it took so far
    double pace_ = 1;                 ///< priced speed of the stage that runs over its own [-]
    double taken_ = 0, expected_ = 0; ///< by the stages that are done [s]
};

} // namespace suffuse::apps
