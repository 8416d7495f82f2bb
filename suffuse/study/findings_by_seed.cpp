#include "suffuse/study/findings_by_seed.hpp"

#include "suffuse/study/erosion_story.hpp"

#include <algorithm>

namespace suffuse::study {
namespace {

/// The sample whose story is shown: the first that was eroded, or else the first that was probed.
const record::FinishedStage* find_first(const std::vector<record::FinishedStage>& stages) {
    const auto any = [](const record::FinishedStage&) { return true; };
    const record::FinishedStage* const eroded = find_eroded(stages, any);
    return eroded != nullptr ? eroded : find_probed(stages, any);
}

/// The first probes of the stages that belong, and their first erosion with those that follow it.
std::vector<Finding> judge(const std::vector<record::FinishedStage>& stages, const Belongs& belongs) {
    const record::FinishedStage* const probed = find_probed(stages, belongs);
    const record::FinishedStage* const eroded = find_eroded(stages, belongs);
    return judge_erosion(
        probed != nullptr ? probed->findings.probes : std::vector<erosion::ProbeResult>{},
        passes_of(find_chain(stages, eroded))
    );
}

std::string name_of(const Erosions& chain) {
    std::string name;
    for (const record::FinishedStage* stage : chain) {
        name += (name.empty() ? "" : ", then ") + stage->stage->name;
    }
    return name;
}

/// The ways of one sample: those to erosions that no other follows.
std::vector<Erosions> ways_of(const std::vector<record::FinishedStage>& stages, const casefile::Variant& variant) {
    std::vector<Erosions> ways;
    for (const record::FinishedStage& stage : stages) {
        if (stage.variant == &variant && stage.findings.erosion && find_chain(stages, &stage).size() == 1) {
            ways.push_back(chain_to(stages, stage));
        }
    }
    return ways;
}

} // namespace

std::vector<Reading> judge_readings(const std::vector<record::FinishedStage>& stages) {
    const record::FinishedStage* const first = find_eroded(stages, [](const record::FinishedStage&) { return true; });
    if (first == nullptr) {
        return {};
    }
    std::vector<std::pair<std::string, std::vector<std::vector<Finding>>>> by_seed; // of each way
    for (const casefile::Variant& variant : first->study->variants) {
        if (variant.values != first->variant->values) {
            continue;
        }
        const record::FinishedStage* const probed =
            find_probed(stages, [&](const record::FinishedStage& stage) { return stage.variant == &variant; });
        for (const Erosions& way : ways_of(stages, variant)) {
            const std::string name = name_of(way);
            auto found = std::ranges::find(by_seed, name, &decltype(by_seed)::value_type::first);
            if (found == by_seed.end()) {
                found = by_seed.insert(by_seed.end(), {name, {}});
            }
            found->second.push_back(judge_erosion(
                probed != nullptr ? probed->findings.probes : std::vector<erosion::ProbeResult>{}, passes_of(way)
            ));
        }
    }
    std::vector<Reading> readings;
    readings.reserve(by_seed.size());
    for (const auto& [name, findings] : by_seed) {
        readings.push_back({name, combine_seeds(findings)});
    }
    return readings;
}

std::vector<Finding> judge_erosion_by_seed(const std::vector<record::FinishedStage>& stages) {
    const record::FinishedStage* const first = find_first(stages);
    if (first == nullptr) {
        return {};
    }
    if (first->study->replicates == 1) { // probes may stand in another sample of the sweep
        return judge(stages, [&](const record::FinishedStage& stage) { return stage.study == first->study; });
    }
    std::vector<std::vector<Finding>> by_seed;
    for (const casefile::Variant& variant : first->study->variants) {
        const bool is_there = std::any_of(stages.begin(), stages.end(), [&](const record::FinishedStage& stage) {
            return stage.variant == &variant && (stage.findings.erosion || !stage.findings.probes.empty());
        });
        if (is_there && variant.values == first->variant->values) {
            by_seed.push_back(judge(stages, [&](const record::FinishedStage& stage) {
                return stage.variant == &variant;
            }));
        }
    }
    return combine_seeds(by_seed);
}

} // namespace suffuse::study
