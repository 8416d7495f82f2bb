#include "apps/cut_verdicts.hpp"

#include "suffuse/stability/open_curve.hpp"

#include <fmt/format.h>

#include <map>

namespace suffuse::apps {

CutVerdicts judge_cut(const grains::Grading& measured, const grains::Grading& modeled, double finer_than) {
    stability::AssessSpec spec;
    spec.finer_than = finer_than;
    const auto before = stability::assess_measured(measured, spec).criteria;
    const auto after = stability::assess(modeled, spec).criteria;
    CutVerdicts verdicts{stability::summary(before), stability::summary(after), {}};
    for (std::size_t k = 0; k < before.size(); ++k) {
        if (before[k].verified && after[k].verified && before[k].verdict != after[k].verdict) {
            verdicts.turned.push_back(
                {before[k].id, before[k].name, stability::verdict_word(before[k].verdict),
                 stability::verdict_word(after[k].verdict)}
            );
        }
    }
    return verdicts;
}

std::string turned_text(const CutVerdicts& verdicts) {
    std::map<std::string, std::string> names; // of the criteria, by the way in which they were turned
    for (const CutVerdicts::Turned& turned : verdicts.turned) {
        std::string& list = names[fmt::format("{} -> {}", turned.given, turned.modeled)];
        list += (list.empty() ? "" : ", ") + turned.name;
    }
    std::string text;
    for (const auto& [way, list] : names) {
        text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", way, list);
    }
    return text;
}

} // namespace suffuse::apps
