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

const run::StageEstimate* TimeLeft::stage_of(const run::Progress& progress) const {
    const auto row = static_cast<std::size_t>(progress.stage_number - 1);
    return progress.stage_number >= 1 && row < plan_.stages.size() ? &plan_.stages[row] : nullptr;
}

double TimeLeft::correction() const {
    return (taken_ + trust) / (expected_ + trust);
}

void TimeLeft::learn(const run::Progress& progress) {
    if (const run::StageEstimate* stage = stage_of(progress)) {
        taken_ += progress.stage_seconds;
        expected_ += middle(stage->seconds);
    }
}

run::Range TimeLeft::left(const run::Progress& progress) const {
    const double factor = correction(), gone = progress.stage_finished ? 0 : progress.stage_seconds;
    run::Range left;
    for (std::size_t row = 0; row < plan_.stages.size(); ++row) {
        const auto number = static_cast<int>(row) + 1;
        run::Range stage{factor * plan_.stages[row].seconds.least, factor * plan_.stages[row].seconds.most};
        if (number < progress.stage_number || (number == progress.stage_number && progress.stage_finished)) {
            continue;
        }
        if (number == progress.stage_number) {
            // A stage beyond its range has as yet shown no end: up to half of what it took may follow.
            stage = {std::max(stage.least - gone, 0.0), std::max(stage.most - gone, 0.5 * gone)};
        }
        left += stage;
    }
    return left;
}

} // namespace suffuse::apps
