// Figures 11 and 12: what each pass took.
#include "suffuse/base/words.hpp"
#include "suffuse/figures/figures.hpp"
#include "suffuse/stats/coordination.hpp"
#include "suffuse/study/erosion_span.hpp"
#include "suffuse/study/passes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::figures {

namespace {

using erosion::ErosionResult;
using erosion::PassResult;
using nlohmann::json;

constexpr std::size_t most_drawn = 6;              ///< passes, where each has bars or words of its own
constexpr std::size_t most_bars_with_numbers = 10; ///< above them

struct RemovedGrains {
    std::int64_t all = 0, active = 0; ///< with at least two contacts
};

RemovedGrains count_contacts(const PassResult& pass) {
    RemovedGrains removed;
    for (const auto& [coordination, count] : pass.coordination_histogram) {
        removed.all += count;
        removed.active += coordination >= stats::active_contacts ? count : 0;
    }
    return removed;
}

double share_of_active(const study::SomePasses& passes) {
    double all = 0, active = 0;
    for (const PassResult* pass : passes) {
        const auto counts = count_contacts(*pass);
        all += static_cast<double>(counts.all);
        active += static_cast<double>(counts.active);
    }
    return 100 * active / all;
}

} // namespace

std::optional<Figure> eroded_mass(const ErosionResult& erosion) {
    if (erosion.passes.empty()) {
        return std::nullopt;
    }
    std::vector<double> removed, share, of_initial;
    std::string claim;
    for (const PassResult& pass : erosion.passes) {
        removed.push_back(static_cast<double>(pass.removed));
        share.push_back(pass.eroded_mass_percent);
        of_initial.push_back(pass.eroded_mass_percent_of_initial);
    }
    const double total = erosion::eroded_percent(erosion);
    const study::SomePasses few = study::few_passes(erosion, most_drawn);
    for (const PassResult* pass : few) {
        claim += fmt::format(
            "{}{} % in pass {}", claim.empty() ? "" : ", ", short_number(pass->eroded_mass_percent), pass->pass
        );
    }
    Figure figure;
    figure.id = "fig11";
    figure.section = "Erosion";
    figure.title = "Eroded mass of each pass";
    figure.claim = total > 0
                       ? fmt::format(
                             "{} {} out {} % of the mass",
                             erosion.passes.size() == 1 ? "One pass" : fmt::format("{} passes", erosion.passes.size()),
                             study::span_of({&erosion})->has_forced ? "took" : "carried", short_number(total, 2)
                         )
                       : "No grain left";
    figure.caption = fmt::format(
        "Of the mass before the pass: {}{}; {} % of the initial mass in all.", claim,
        study::part_of_passes(few, erosion.passes.size()), short_number(total)
    );
    figure.table.add("pass", study::pass_names(erosion));
    figure.table.add("removed_grains", "", std::move(removed));
    figure.table.add("eroded_mass", "%", std::move(share));
    figure.table.add("eroded_mass_of_initial", "%", std::move(of_initial));
    figure.chart = json::parse(R"json({
        "width": 360, "height": 240,
        "encoding": {
            "x": {"field": "pass", "type": "nominal", "title": "erosion pass [-]", "sort": null, "axis": {"labelAngle": 0}},
            "y": {"field": "eroded_mass", "type": "quantitative", "title": "eroded mass Δm / m [%]"}
        },
        "layer": [
            {"mark": {"type": "bar", "width": {"band": 0.5}, "color": "#c8322b"},
             "encoding": {"tooltip": [{"field": "pass", "title": "pass"},
                {"field": "eroded_mass", "title": "of the mass before [%]", "format": ".4g"},
                {"field": "eroded_mass_of_initial", "title": "of the initial mass [%]", "format": ".4g"},
                {"field": "removed_grains", "title": "grains", "format": ","}]}},
            {"mark": {"type": "text", "dy": -8, "fontSize": 12, "color": "#333333"},
             "encoding": {"text": {"field": "eroded_mass", "type": "quantitative", "format": ".3~g"}}}
        ]
    })json");
    if (erosion.passes.size() > most_bars_with_numbers) {
        figure.chart["layer"].erase(1);
    }
    return figure;
}

std::optional<Figure> eroded_coordination(const ErosionResult& erosion) {
    std::vector<std::string> name;
    std::vector<double> contacts, grains, share;
    std::string claim;
    study::SomePasses that_took;
    int most = 4; // contacts on the axis at least: so that "all had none" differs from "nobody had"
    for (const PassResult& pass : erosion.passes) {
        for (const auto& [coordination, count] : pass.coordination_histogram) {
            most = count > 0 ? std::max(most, coordination) : most;
        }
        if (count_contacts(pass).all > 0) {
            that_took.push_back(&pass);
        }
    }
    if (that_took.empty()) {
        return std::nullopt;
    }
    for (const PassResult* pass : that_took) {
        const double all = static_cast<double>(count_contacts(*pass).all);
        for (int coordination = 0; coordination <= most; ++coordination) {
            const auto found = pass->coordination_histogram.find(coordination);
            const std::int64_t count = found == pass->coordination_histogram.end() ? 0 : found->second;
            name.push_back(study::pass_name(pass->pass));
            contacts.push_back(coordination);
            grains.push_back(static_cast<double>(count));
            share.push_back(100.0 * static_cast<double>(count) / all);
        }
    }
    const study::SomePasses few = study::few_of(that_took, most_drawn);
    for (const PassResult* pass : few) {
        const auto [all, active] = count_contacts(*pass);
        claim += fmt::format(
            "{}pass {}: {} of {} removed grains had at least two contacts ({} %)", claim.empty() ? "" : "; ",
            pass->pass, grouped(active), grouped(all),
            short_number(100.0 * static_cast<double>(active) / static_cast<double>(all))
        );
    }
    const std::vector<std::string> order = study::pass_names(few);
    Figure figure;
    figure.id = "fig12";
    figure.section = "Erosion";
    figure.title = "Contacts that the removed grains had";
    figure.claim = fmt::format(
        "{} % of the removed grains had at least two contacts", short_number(share_of_active(that_took), 2)
    );
    figure.caption = as_sentence(claim) + study::part_of_passes(few, that_took.size()) + ".";
    figure.table.add("pass", std::move(name));
    figure.table.add("coordination", "", std::move(contacts));
    figure.table.add("grains", "", std::move(grains));
    figure.table.add("share", "%", std::move(share));
    figure.chart = json::parse(R"json({
        "width": 480, "height": 240,
        "mark": {"type": "bar"},
        "encoding": {
            "x": {"field": "coordination", "type": "ordinal", "title": "contacts of the grain, coordination number Z [-]",
                  "axis": {"labelAngle": 0, "format": "d"}},
            "xOffset": {"field": "pass", "type": "nominal"},
            "y": {"field": "share", "type": "quantitative", "title": "share of the grains removed in the pass [%]"},
            "color": {"field": "pass", "type": "nominal", "title": null},
            "tooltip": [{"field": "pass", "title": "pass"}, {"field": "coordination", "title": "contacts"},
                        {"field": "grains", "title": "grains", "format": ","},
                        {"field": "share", "title": "share [%]", "format": ".3g"}]
        }
    })json");
    figure.chart["transform"] = {{{"filter", {{"field", "pass"}, {"oneOf", order}}}}};
    figure.chart["encoding"]["color"]["scale"] = {{"domain", order}, {"range", color::sequence()}};
    figure.chart["encoding"]["xOffset"]["sort"] = order;
    return figure;
}

} // namespace suffuse::figures
