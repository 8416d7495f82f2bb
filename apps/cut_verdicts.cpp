#include "apps/cut_verdicts.hpp"

#include "suffuse/stability/open_curve.hpp"

#include <fmt/format.h>

#include <map>

namespace suffuse::apps {

CutVerdicts judge_cut(const grains::Grading& measured, const grains::Grading& part, double finer_than) {
    stability::AssessSpec spec;
    spec.finer_than = finer_than;
    const auto given = stability::assess_measured(measured, spec).criteria;
    const auto modeled = stability::assess(part, spec).criteria;
    CutVerdicts verdicts{stability::summary(given), stability::summary(modeled), {}};
    for (std::size_t k = 0; k < given.size(); ++k) {
        if (given[k].verified && given[k].verdict != modeled[k].verdict) {
            verdicts.turned.push_back(
                {given[k].id, given[k].name, stability::verdict_word(given[k].verdict),
                 stability::verdict_word(modeled[k].verdict)}
            );
        }
    }
    return verdicts;
}

std::string turned_text(const CutVerdicts& verdicts) {
    std::map<std::string, std::string> names; // of the criteria, by the way in which they were turned
    for (const CutVerdicts::Turned& turned : verdicts.turned) {
        std::string& list = names[fmt::format("{} as given but {} as modeled", turned.given, turned.modeled)];
        list += (list.empty() ? "" : ", ") + turned.name;
    }
    std::string text;
    for (const auto& [way, list] : names) {
        text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", way, list);
    }
    return text;
}

} // namespace suffuse::apps
