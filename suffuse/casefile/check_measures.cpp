#include "suffuse/casefile/check_measures.hpp"

#include "suffuse/casefile/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace suffuse::casefile {

void check_measures(ReadContext& context, const Stage& stage, const Node& item) {
    const std::string verb = verb_of(stage.spec);
    const Node::Entry* list = item.find("measure");
    for (std::size_t k = 0; k < stage.measure.size(); ++k) {
        const std::vector<std::string> verbs = names::verbs_of_measure(stage.measure[k]);
        if (verbs.empty() || std::find(verbs.begin(), verbs.end(), verb) != verbs.end()) {
            continue;
        }
        std::vector<std::string> known;
        for (const std::string_view measure : names::measures) {
            const std::vector<std::string> others = names::verbs_of_measure(measure);
            if (others.empty() || std::find(others.begin(), others.end(), verb) != others.end()) {
                known.emplace_back(measure);
            }
        }
        const bool is_listed = list != nullptr && k < list->value.items.size();
        context.problems.error(
            "E407", is_listed ? list->value.items[k].place : Place{},
            fmt::format(
                "stage \"{}\" does \"{}\", which has no \"{}\": that belongs to {}", stage.name, verb, stage.measure[k],
                fmt::join(verbs, ", ")
            ),
            fmt::format("this stage can measure {}", fmt::join(known, ", "))
        );
    }
}

} // namespace suffuse::casefile
