// What samples may cost that no plan can name: those that `refine` adds where a curve has its extreme.

#include "suffuse/plan/plan.hpp"
#include "suffuse/plan/sum_ranges.hpp"

#include <algorithm>
#include <map>

namespace suffuse::plan {
namespace {

/// From the cheapest to the dearest sample of a study that is run at all [s].
Range seconds_of_a_sample(const RunPlan& plan, const casefile::Study& study) {
    std::map<std::string, std::vector<Range>> of_sample;
    for (const StageEstimate& stage : plan.stages) {
        of_sample[stage.study].push_back(stage.seconds);
    }
    Range seconds;
    for (const casefile::Variant& variant : study.variants) {
        const Range one = sum_ranges(of_sample[variant.folder]);
        if (one.most > 0) {
            seconds.least = seconds.most > 0 ? std::min(seconds.least, one.least) : one.least;
            seconds.most = std::max(seconds.most, one.most);
        }
    }
    return seconds;
}

} // namespace

RefinedEstimate price_refined(const RunPlan& plan, const casefile::Case& what) {
    RefinedEstimate refined;
    for (const casefile::Study& study : what.studies) {
        const Range seconds = seconds_of_a_sample(plan, study);
        if (!study.refine || !(seconds.most > 0)) {
            continue;
        }
        const auto sweep = std::ranges::find(study.sweep, study.refine->key, &casefile::Sweep::key);
        const auto copies = static_cast<double>(study.variants.size() / sweep->values.size()); // of a value
        const double a_side = study.refine->add * copies;
        const bool is_first = !(refined.seconds.most > 0);
        refined.samples += {a_side, 2 * a_side * static_cast<double>(study.refine->at.size())};
        refined.seconds = {
            is_first ? seconds.least : std::min(refined.seconds.least, seconds.least),
            std::max(refined.seconds.most, seconds.most)};
    }
    return refined;
}

Range seconds_of_refined(const RefinedEstimate& refined, int at_once) {
    const auto rounds = [&](double samples) { return samples > 0 ? std::max(samples / at_once, 1.0) : 0; };
    return Range{rounds(refined.samples.least), rounds(refined.samples.most)} * refined.seconds;
}

} // namespace suffuse::plan
