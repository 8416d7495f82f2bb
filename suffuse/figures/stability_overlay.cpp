#include "suffuse/figures/stability_overlay.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/figures/size_axis.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::figures {

namespace {

enum Verdicts : std::size_t { MostlyUnstable, PartlyUnstable, NowhereUnstable };

Verdicts verdicts_of(const stability::Assessment& assessment) {
    const stability::Tally tally = stability::count_verdicts(assessment.criteria);
    const int others = tally.stable + tally.transition;
    return tally.unstable == 0 ? NowhereUnstable : tally.unstable > others ? MostlyUnstable : PartlyUnstable;
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

namespace {

/// Curves that share a name in the legend share their color.
struct Group {
    const char* name;
    const char* color;
    std::vector<int> dash;
};

/// @param group_of the place in `groups` of each soil
Figure curves_of(
    const std::vector<NamedAssessment>& soils, const std::vector<Group>& groups,
    const std::vector<std::size_t>& group_of
) {
    std::vector<std::string> names, legend;
    std::vector<double> sizes, shares;
    for (std::size_t soil = 0; soil < soils.size(); ++soil) {
        const stability::Assessment& found = *soils[soil].assessment;
        for (std::size_t k = 0; k < found.grading.diameter.size(); ++k) {
            const double share = found.grading.passing[k];
            if (share >= found.missing_fine && share <= 1 - found.missing_coarse) { // completed ends are not drawn
                names.push_back(soils[soil].name), legend.emplace_back(groups[group_of[soil]].name);
                sizes.push_back(1e3 * found.grading.diameter[k]), shares.push_back(100 * share);
            }
        }
    }
    const double from = std::ranges::min(sizes) / 1.15, to = std::ranges::max(sizes) * 1.15;
    Figure figure;
    figure.section = "Soils";
    figure.table.add("soil", std::move(names));
    figure.table.add("verdicts", std::move(legend));
    figure.table.add("diameter", "mm", std::move(sizes));
    figure.table.add("passing", "%", std::move(shares));
    nlohmann::json layers = class_layers(from, to);
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
    nlohmann::json domain = nlohmann::json::array(), colors = domain, dashes = domain;
    for (const Group& group : groups) {
        domain.push_back(group.name), colors.push_back(group.color), dashes.push_back(group.dash);
    }
    line["encoding"]["color"]["scale"] = {{"domain", domain}, {"range", colors}};
    line["encoding"]["strokeDash"]["scale"] = {{"domain", domain}, {"range", dashes}};
    layers.push_back(std::move(line));
    figure.chart = {
        {"width", 560}, {"height", 340}, {"encoding", {{"x", size_axis(from, to, false)}}}, {"layer", layers}};
    return figure;
}

} // namespace

Figure stability_overlay(const std::vector<NamedAssessment>& soils) {
    std::vector<std::size_t> group_of;
    group_of.reserve(soils.size());
    for (const NamedAssessment& soil : soils) {
        group_of.push_back(verdicts_of(*soil.assessment));
    }
    Figure figure = curves_of(
        soils,
        {{"most criteria say unstable", color::detachable, {1, 0}},
         {"some say unstable", color::coarse, {6, 3}},
         {"none says unstable", color::staying, {2, 2}}},
        group_of
    );
    figure.id = "own-stability-overlay";
    figure.title = "Gradings of all samples over each other";
    figure.caption = fmt::format(
        "{} of {} soils are unstable by most of the criteria that can say.",
        std::ranges::count(group_of, std::size_t{MostlyUnstable}), soils.size()
    );
    return figure;
}

Figure filter_overlay(const NamedAssessment& soil, const NamedAssessment& filter, const std::string& verdict) {
    Figure figure = curves_of(
        {soil, filter}, {{"the soil", color::staying, {1, 0}}, {"its filter", color::coarse, {6, 3}}}, {0, 1}
    );
    figure.id = "own-stability-filter";
    figure.title = "The soil and its filter";
    figure.caption = verdict;
    return figure;
}

} // namespace suffuse::figures
