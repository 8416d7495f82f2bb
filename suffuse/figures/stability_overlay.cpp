#include "suffuse/figures/stability_overlay.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/figures/size_axis.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::figures {

namespace {

constexpr const char* mostly_unstable = "most criteria say unstable";
constexpr const char* partly_unstable = "some say unstable";
constexpr const char* nowhere_unstable = "none says unstable";

const char* group_of(const stability::Assessment& assessment) {
    const stability::Tally tally = stability::count_verdicts(assessment.criteria);
    const int others = tally.stable + tally.transition;
    return tally.unstable == 0 ? nowhere_unstable : tally.unstable > others ? mostly_unstable : partly_unstable;
}

} // namespace

PageTable stability_matrix(const std::vector<NamedAssessment>& soils) {
    PageTable table;
    table.section = "Soils";
    table.title = "Criteria of internal stability, soil by soil";
    table.note = "Verdict and number of each criterion whose limits were read in a source.";
    table.header = {"soil"};
    for (const stability::Criterion& criterion : soils.front().assessment->criteria) {
        if (criterion.verified) {
            table.header.push_back(criterion.name);
        }
    }
    table.numeric.assign(table.header.size(), false);
    for (const NamedAssessment& soil : soils) {
        std::vector<std::string> row{soil.name};
        for (const stability::Criterion& criterion : soil.assessment->criteria) {
            if (criterion.verified) {
                row.push_back(fmt::format(
                    "{}{}", stability::verdict_word(criterion.verdict),
                    criterion.value ? " " + short_number(*criterion.value) : ""
                ));
            }
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

Figure stability_overlay(const std::vector<NamedAssessment>& soils) {
    std::vector<std::string> names, groups;
    std::vector<double> sizes, shares;
    double from = 1e300, to = 0;
    std::size_t unstable = 0;
    for (const NamedAssessment& soil : soils) {
        const stability::Assessment& found = *soil.assessment;
        unstable += group_of(found) == mostly_unstable ? 1U : 0U;
        for (std::size_t k = 0; k < found.grading.diameter.size(); ++k) {
            const double share = found.grading.passing[k];
            if (share >= found.missing_fine && share <= 1 - found.missing_coarse) { // completed ends are not drawn
                names.push_back(soil.name), groups.emplace_back(group_of(found));
                sizes.push_back(1e3 * found.grading.diameter[k]), shares.push_back(100 * share);
                from = std::min(from, sizes.back()), to = std::max(to, sizes.back());
            }
        }
    }
    Figure figure;
    figure.id = "own-stability-overlay";
    figure.section = "Soils";
    figure.title = "Gradings of all samples over each other";
    figure.caption =
        fmt::format("{} of {} soils are unstable by most of the criteria that can say.", unstable, soils.size());
    figure.table.add("soil", std::move(names));
    figure.table.add("verdicts", std::move(groups));
    figure.table.add("diameter", "mm", std::move(sizes));
    figure.table.add("passing", "%", std::move(shares));
    nlohmann::json layers = class_layers(from / 1.15, to * 1.15);
    nlohmann::json line = nlohmann::json::parse(R"json({
        "mark": {"type": "line", "strokeWidth": 1.6},
        "encoding": {"x": {"field": "diameter", "type": "quantitative"},
                     "y": {"field": "passing", "type": "quantitative", "title": "passing by mass F [%]",
                           "scale": {"domain": [0, 100]}},
                     "detail": {"field": "soil"}, "order": {"field": "diameter"},
                     "color": {"field": "verdicts", "type": "nominal", "title": null},
                     "strokeDash": {"field": "verdicts", "type": "nominal", "title": null},
                     "tooltip": [{"field": "soil", "title": "soil"},
                                 {"field": "diameter", "title": "d [mm]", "format": ".4g"},
                                 {"field": "passing", "title": "F [%]", "format": ".3g"}]}
    })json");
    const nlohmann::json order = {mostly_unstable, partly_unstable, nowhere_unstable};
    line["encoding"]["color"]["scale"] = {
        {"domain", order}, {"range", {color::detachable, color::coarse, color::staying}}};
    line["encoding"]["strokeDash"]["scale"] = {
        {"domain", order}, {"range", nlohmann::json::parse("[[1, 0], [6, 3], [2, 2]]")}};
    layers.push_back(std::move(line));
    figure.chart = {
        {"width", 560},
        {"height", 340},
        {"encoding", {{"x", size_axis(from / 1.15, to * 1.15, false)}}},
        {"layer", layers}};
    return figure;
}

} // namespace suffuse::figures
