#include "suffuse/study/run_results.hpp"

#include "suffuse/study/findings_by_seed.hpp"
#include "suffuse/study/trace_curves.hpp"

namespace suffuse::study {

RunResults find_results(const casefile::Case& what, std::vector<record::FinishedStage> stages) {
    RunResults found;
    found.what = &what;
    found.stages = std::move(stages);
    found.curves = trace_curves(what, found.stages);
    found.fines_sweep = find_fines_sweep(what, found.curves);
    found.fines = gather_fines(found.fines_sweep, found.stages);
    if (found.fines_sweep && found.fines) {
        mark_thresholds(found.fines->thresholds, found.fines_sweep->curves);
    }
    found.story = find_story(found.stages);
    found.readings = judge_readings(found.stages);
    found.mobility = gather_mobility(found.stages);
    found.strength = compare_strength(found.stages);
    found.probed_states = gather_probed_states(found.stages);
    found.outcomes = gather_outcomes(what, found.stages);
    found.findings = judge_fines_of(found.fines);
    for (Finding& finding : judge_erosion_by_seed(found.stages)) {
        found.findings.push_back(std::move(finding));
    }
    return found;
}

} // namespace suffuse::study
