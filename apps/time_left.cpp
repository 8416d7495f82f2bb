#include "apps/time_left.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::apps {
namespace {

constexpr double trust = 5; // seconds of experience that weigh as much as the plan

double middle(const run::Range& range) {
    return std::sqrt(std::max(range.least, 0.01) * std::max(range.most, 0.01));
}

} // namespace

double TimeLeft::correction() const {
    return (taken_ + trust) / (expected_ + trust);
}

void TimeLeft::see(const run::Progress& progress) {
    const auto row = static_cast<Row>(progress.stage_number - 1);
    const bool is_known = progress.stage_number >= 1 && row < plan_.stages.size();
    if (progress.sample_ended) { // what a failed sample leaves undone will not be done
        for (Row k = 0; k < plan_.stages.size(); ++k) {
            if (plan_.stages[k].study == progress.study) {
                plan_.stages[k].seconds = {};
                running_.erase(k);
            }
        }
    } else if (is_known && progress.stage_finished) {
        if (!progress.from_cache) {
            taken_ += progress.stage_seconds;
            expected_ += middle(plan_.stages[row].seconds);
        }
        plan_.stages[row].seconds = {};
        running_.erase(row);
    } else if (is_known) {
        running_[row] = progress.stage_seconds;
    }
}

run::Range TimeLeft::left() const {
    const double factor = correction();
    std::vector<run::StageEstimate> stages = plan_.stages;
    for (run::StageEstimate& stage : stages) {
        stage.seconds = {factor * stage.seconds.least, factor * stage.seconds.most};
    }
    for (const auto& [row, gone] : running_) {
        // A stage beyond its range has as yet shown no end: up to half of what it took may follow.
        run::Range& rest = stages[row].seconds;
        rest = {std::max(rest.least - gone, 0.0), std::max(rest.most - gone, 0.5 * gone)};
    }
    return run::side_by_side(stages, plan_.speed.at_once);
}

} // namespace suffuse::apps
