#include "apps/time_left.hpp"

#include <algorithm>

namespace suffuse::apps {
namespace {

constexpr double trust = 5;     // seconds of experience that weigh as much as the plan
constexpr double steady = 2;    // [s] into a stage from which on its pace means something
constexpr double moment = 0.01; // [s] what counts as no time

} // namespace

double TimeLeft::correction() const {
    return (taken_ + trust * pace_) / (expected_ + trust);
}

/// How many samples are added is known when the first of them begins; none of their stages is in the plan.
void TimeLeft::see_refined(const run::Progress& progress) {
    listed_ = listed_ > 0 ? listed_ : progress.samples;
    const auto is_of = [&](const plan::StageEstimate& stage) { return stage.study == progress.study; };
    if (progress.sample_ended && std::ranges::none_of(plan_.stages, is_of)) {
        ++refined_done_;
    }
    if (progress.samples > listed_) {
        const double rest = std::max(progress.samples - listed_ - refined_done_, 0);
        plan_.refined.samples = {rest, rest};
    }
}

void TimeLeft::see(const run::Progress& progress) {
    see_refined(progress);
    const auto row = static_cast<Row>(progress.stage_number - 1);
    const bool is_known =
        progress.stage_number >= 1 && row < plan_.stages.size() && plan_.stages[row].study == progress.study;
    if (progress.sample_ended) { // what a failed sample leaves undone will not be done
        for (Row k = 0; k < plan_.stages.size(); ++k) {
            if (plan_.stages[k].study == progress.study) {
                plan_.stages[k].seconds = {};
                running_.erase(k);
            }
        }
    } else if (is_known && progress.stage_finished) {
        const bool makes_steps = plan_.stages[row].steps.most > 0; // a cloud or a flow says nothing of others' speed
        if (!progress.from_cache && makes_steps) {
            taken_ += progress.stage_seconds;
            expected_ += middle(plan_.stages[row].seconds, moment);
        }
        plan_.stages[row].seconds = {};
        running_.erase(row);
    } else if (is_known) {
        running_[row] = progress.stage_seconds;
        const plan::StageEstimate& plan = plan_.stages[row];
        const double priced = middle(plan.steps) * static_cast<double>(plan.grains) / middle(plan.seconds, moment);
        if (priced > 0 && progress.particle_steps_per_second > 0 && progress.stage_seconds > steady) {
            pace_ = priced / progress.particle_steps_per_second;
        }
    }
}

Range TimeLeft::left() const {
    const double factor = correction();
    std::vector<plan::StageEstimate> stages = plan_.stages;
    for (plan::StageEstimate& stage : stages) {
        stage.seconds = {factor * stage.seconds.least, factor * stage.seconds.most};
    }
    for (const auto& [row, gone] : running_) {
        // A stage beyond its range has as yet shown no end: up to half of what it took may follow.
        Range& rest = stages[row].seconds;
        rest = {std::max(rest.least - gone, 0.0), std::max(rest.most - gone, 0.5 * gone)};
    }
    return plan::side_by_side(stages, plan_.speed.at_once) +
           factor * plan::seconds_of_refined(plan_.refined, plan_.speed.at_once);
}

} // namespace suffuse::apps
