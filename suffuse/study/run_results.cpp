#include "suffuse/study/run_results.hpp"

#include "suffuse/study/findings_by_seed.hpp"
#include "suffuse/study/trace_curves.hpp"

namespace suffuse::study {

RunResults find_results(const casefile::Case& what, std::vector<record::FinishedStage> stages) {
    RunResults results;
    results.what = &what;
    results.stages = std::move(stages);
    results.curves = trace_curves(what, results.stages);
    results.fines_sweep = find_fines_sweep(what, results.curves);
    results.fines = gather_fines(results.fines_sweep, results.stages);
    if (results.fines_sweep && results.fines) {
        mark_thresholds(results.fines->thresholds, results.fines_sweep->curves);
    }
    results.story = find_story(results.stages);
    results.readings = judge_readings(results.stages);
    results.mobility = gather_mobility(results.stages);
    results.strength = compare_strength(results.stages);
    results.probed_states = gather_probed_states(results.stages);
    results.outcomes = gather_outcomes(what, results.stages);
    results.findings = judge_fines_of(results.fines);
    for (Finding& finding : judge_erosion_by_seed(results.stages)) {
        results.findings.push_back(std::move(finding));
    }
    return results;
}

} // namespace suffuse::study
