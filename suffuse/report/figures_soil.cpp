// Figure 8, and what the sizes say: gradings before and after erosion, constrictions beside the fines.
#include "suffuse/grains/grading.hpp"
#include "suffuse/report/figures.hpp"
#include "suffuse/report/quantile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suffuse::report {

namespace {

using erosion::ErosionResult;
using erosion::LedgerRow;
using erosion::PassResult;
using grains::Grading;
using nlohmann::json;

struct Curves {
    std::vector<std::string> curve;
    std::vector<double> diameter, passing; ///< [mm], [%]
    std::vector<std::string> order;

    void add(const std::string& name, const Grading& grading) {
        order.push_back(name);
        for (std::size_t k = 0; k < grading.diameter.size(); ++k) {
            curve.push_back(name);
            diameter.push_back(1e3 * grading.diameter[k]);
            passing.push_back(100 * grading.passing[k]);
        }
    }

    Table table() && {
        Table table;
        table.add("curve", std::move(curve));
        table.add("diameter", "mm", std::move(diameter));
        table.add("passing", "%", std::move(passing));
        return table;
    }
};

/// ISO 14688: where the classes of grain size begin [mm].
struct SizeClass {
    double from;
    const char* name;
};

constexpr SizeClass size_classes[] = {{0.0001, "clay"},        {0.002, "fine silt"}, {0.0063, "medium silt"},
                                      {0.02, "coarse silt"},   {0.063, "fine sand"}, {0.2, "medium sand"},
                                      {0.63, "coarse sand"},   {2.0, "fine gravel"}, {6.3, "medium gravel"},
                                      {20.0, "coarse gravel"}, {63.0, "cobbles"}};

/// Class names and limits that the domain [mm] shows.
json class_layers(double from, double to) {
    json names = json::array(), limits = json::array();
    for (std::size_t k = 0; k < std::size(size_classes); ++k) {
        const double begin = std::max(from, size_classes[k].from);
        const double end = std::min(to, k + 1 < std::size(size_classes) ? size_classes[k + 1].from : to);
        if (begin >= end) {
            continue;
        }
        if (begin > from) {
            limits.push_back({{"limit", begin}});
        }
        if (end / begin > 1.25) {
            names.push_back({{"middle", std::sqrt(begin * end)}, {"name", size_classes[k].name}});
        }
    }
    json layers = json::array();
    layers.push_back(
        {{"data", {{"values", limits}}},
         {"mark", {{"type", "rule"}, {"color", color::quiet}, {"strokeDash", {1, 3}}}},
         {"encoding", {{"x", {{"field", "limit"}, {"type", "quantitative"}}}}}}
    );
    layers.push_back(
        {{"data", {{"values", names}}},
         {"mark", {{"type", "text"}, {"baseline", "bottom"}, {"dy", -4}, {"color", color::quiet}}},
         {"encoding",
          {{"x", {{"field", "middle"}, {"type", "quantitative"}}},
           {"y", {{"value", 0}}},
           {"text", {{"field", "name"}}}}}}
    );
    return layers;
}

json grading_chart(const Curves& curves, std::optional<double> finer_than, GradingAxis axis) {
    const auto [low, high] = std::minmax_element(curves.diameter.begin(), curves.diameter.end());
    const double from = *low / 1.15, to = *high * 1.15;
    json chart = json::parse(R"json({
        "width": 560, "height": 300,
        "encoding": {
            "x": {"type": "quantitative", "title": "grain diameter d [mm]",
                  "axis": {"labelExpr": "format(datum.value, '~g')", "labelOverlap": "greedy"}}
        },
        "layer": []
    })json");
    chart["encoding"]["x"]["scale"] = {
        {"type", "log"}, {"domain", {from, to}}, {"nice", false}, {"reverse", axis == GradingAxis::Reversed}};
    if (finer_than) {
        const double limit = 1e3 * *finer_than;
        chart["layer"].push_back(
            {{"data",
              {{"values", {{{"from", from}, {"to", limit}, {"text", fmt::format("fines, d < {:.3g} mm", limit)}}}}}},
             {"mark", {{"type", "rect"}, {"color", color::fines}, {"opacity", 0.12}}},
             {"encoding",
              {{"x", {{"field", "from"}, {"type", "quantitative"}}},
               {"x2", {{"field", "to"}}},
               {"tooltip", {{"field", "text"}}}}}}
        );
    }
    for (json& layer : class_layers(from, to)) {
        chart["layer"].push_back(std::move(layer));
    }
    json lines = json::parse(R"json({
        "mark": {"type": "line", "strokeWidth": 2.2, "point": {"size": 22, "filled": true}},
        "encoding": {
            "x": {"field": "diameter", "type": "quantitative"},
            "y": {"field": "passing", "type": "quantitative", "title": "passing by mass F [%]", "scale": {"domain": [0, 100]}},
            "color": {"field": "curve", "type": "nominal", "title": null},
            "strokeDash": {"field": "curve", "type": "nominal", "title": null, "scale": {"range": [[1, 0], [6, 3], [2, 2], [8, 2, 2, 2]]}},
            "order": {"field": "diameter"},
            "tooltip": [{"field": "curve", "title": "curve"}, {"field": "diameter", "title": "d [mm]", "format": ".4g"},
                        {"field": "passing", "title": "F [%]", "format": ".4g"}]
        }
    })json");
    lines["encoding"]["color"]["scale"] = {{"domain", curves.order}, {"range", color::sequence()}};
    lines["encoding"]["strokeDash"]["scale"]["domain"] = curves.order;
    chart["layer"].push_back(std::move(lines));
    return chart;
}

bool is_usable(const Grading& grading) {
    return grading.diameter.size() >= 2 && grading.diameter.size() == grading.passing.size();
}

/// Largest difference of percent passing between two curves, at the points of either [%].
double largest_difference(const Grading& a, const Grading& b) {
    double largest = 0;
    for (const Grading* points : {&a, &b}) {
        for (const double d : points->diameter) {
            largest = std::max(largest, std::abs(grains::passing(a, d) - grains::passing(b, d)));
        }
    }
    return 100 * largest;
}

/// Mass of removed grains not larger than `diameter` [kg].
double mass_up_to(double diameter, const std::vector<LedgerRow>& rows) {
    return std::accumulate(rows.begin(), rows.end(), 0.0, [diameter](double sum, const LedgerRow& row) {
        return row.diameter <= diameter ? sum + row.mass : sum;
    });
}

constexpr int curve_points = 41;

std::vector<double> log_spaced(double from, double to) {
    std::vector<double> sizes;
    for (int k = 0; k < curve_points; ++k) {
        sizes.push_back(from * std::pow(to / from, static_cast<double>(k) / (curve_points - 1)));
    }
    return sizes;
}

/// Share of the values not larger than each of a hundred quantiles, thinned for drawing.
void add_distribution(
    const std::string& name, std::vector<double> diameters, std::vector<std::string>& curve, std::vector<double>& size,
    std::vector<double>& share
) {
    std::sort(diameters.begin(), diameters.end());
    constexpr int steps = 100;
    for (int k = 0; k <= steps; ++k) {
        curve.push_back(name);
        share.push_back(100.0 * k / steps);
        size.push_back(1e3 * quantile_of_sorted(diameters, static_cast<double>(k) / steps));
    }
}

} // namespace

std::optional<Figure>
grading_curves(const Grading& asked, const Grading& sampled, std::optional<double> finer_than, GradingAxis axis) {
    if (!is_usable(asked) || !is_usable(sampled)) {
        return std::nullopt;
    }
    Curves curves;
    curves.add("sample", sampled);
    curves.add("asked for", asked);
    Figure figure;
    figure.id = "fig08";
    figure.section = "Soils";
    figure.title = "Grading of the soil";
    figure.caption = fmt::format(
        "The sample follows the grading asked for within {:.2g} % of the mass; D50 = {:.3g} mm, D60/D10 = {:.3g}.",
        largest_difference(asked, sampled), 1e3 * grains::size_at(sampled, 0.5), grains::uniformity(sampled)
    );
    if (finer_than) {
        figure.caption += fmt::format(
            " Grains smaller than {:.3g} mm count as fine (shaded): {:.3g} % of the mass.", 1e3 * *finer_than,
            100 * grains::passing(sampled, *finer_than)
        );
    }
    figure.chart = grading_chart(curves, finer_than, axis);
    figure.table = std::move(curves).table();
    return figure;
}

std::optional<Figure> eroded_grading(const Grading& sampled, const ErosionResult& erosion, GradingAxis axis) {
    if (!is_usable(sampled) || erosion.ledger.empty() || !(erosion.initial_mass > 0)) {
        return std::nullopt;
    }
    const double infinite = sampled.diameter.back() * 2;
    const double eroded = mass_up_to(infinite, erosion.ledger);
    if (!(eroded < erosion.initial_mass)) {
        return std::nullopt;
    }
    Grading before, left, remains;
    for (const double d : log_spaced(sampled.diameter.front(), sampled.diameter.back())) {
        const double gone = mass_up_to(d, erosion.ledger), finer = grains::passing(sampled, d);
        for (Grading* grading : {&before, &left, &remains}) {
            grading->diameter.push_back(d);
        }
        before.passing.push_back(finer);
        left.passing.push_back(gone / eroded);
        remains.passing.push_back((finer * erosion.initial_mass - gone) / (erosion.initial_mass - eroded));
    }
    Curves curves;
    curves.add("before erosion", before);
    curves.add("what left", left);
    curves.add("what remains", remains);
    Figure figure;
    figure.id = "own-eroded-grading";
    figure.section = "Erosion";
    figure.title = "Grading before erosion, of what left and of what remains";
    figure.caption = fmt::format(
        "{} grains with {:.3g} % of the mass left; D50 moves from {:.3g} to {:.3g} mm.",
        grouped(std::ssize(erosion.ledger)), 100 * eroded / erosion.initial_mass, 1e3 * grains::size_at(before, 0.5),
        1e3 * grains::size_at(remains, 0.5)
    );
    figure.chart = grading_chart(curves, std::nullopt, axis);
    figure.table = std::move(curves).table();
    return figure;
}

std::optional<Figure> constriction_sizes(const ErosionResult& erosion) {
    std::vector<std::string> curve, order;
    std::vector<double> size, share;
    std::string claim;
    for (const PassResult& pass : erosion.passes) {
        if (pass.constrictions.diameter.empty()) {
            continue;
        }
        const std::string name = fmt::format("constrictions, pass {}", pass.pass);
        order.push_back(name);
        add_distribution(name, pass.constrictions.diameter, curve, size, share);
        claim += fmt::format(
            "{}pass {}: mean {:.3g}, median {:.3g}, D35 {:.3g} mm",
            claim.empty() ? "Constrictions of the coarse skeleton in " : "; ", pass.pass, 1e3 * pass.constrictions.mean,
            1e3 * pass.constrictions.median, 1e3 * pass.constrictions.d35
        );
    }
    if (order.empty()) {
        return std::nullopt;
    }
    const PassResult& first = erosion.passes.front();
    if (!first.probe.diameter.empty()) {
        order.insert(order.begin(), "fine grains");
        add_distribution("fine grains", first.probe.diameter, curve, size, share);
        const double largest = *std::max_element(first.probe.diameter.begin(), first.probe.diameter.end());
        claim += fmt::format(
            "; the largest fine grain, {:.3g} mm, is {} than the mean constriction of pass {}", 1e3 * largest,
            largest < first.constrictions.mean ? "smaller" : "larger", first.pass
        );
    }
    Figure figure;
    figure.id = "own-constrictions";
    figure.section = "Erosion";
    figure.title = "Constriction sizes of the coarse skeleton, and sizes of the fines";
    figure.caption =
        claim + ". Shares by number of facets and of grains; the upper hundredth is left out of the drawing.";
    figure.table.add("curve", std::move(curve));
    figure.table.add("diameter", "mm", std::move(size));
    figure.table.add("share_smaller", "%", std::move(share));
    figure.chart = json::parse(R"json({
        "width": 560, "height": 280,
        "transform": [{"filter": "datum.share_smaller <= 99"}],
        "mark": {"type": "line", "strokeWidth": 2.2},
        "encoding": {
            "x": {"field": "diameter", "type": "quantitative", "title": "diameter d [mm]"},
            "y": {"field": "share_smaller", "type": "quantitative", "title": "share smaller, by number [%]",
                  "scale": {"domain": [0, 100]}},
            "color": {"field": "curve", "type": "nominal", "title": null},
            "strokeDash": {"field": "curve", "type": "nominal", "title": null},
            "order": {"field": "share_smaller"},
            "tooltip": [{"field": "curve", "title": "curve"}, {"field": "diameter", "title": "d [mm]", "format": ".4g"},
                        {"field": "share_smaller", "title": "share smaller [%]"}]
        }
    })json");
    json range = json::array({color::fines});
    for (const json& next : color::sequence()) {
        range.push_back(next);
    }
    if (first.probe.diameter.empty()) {
        range.erase(range.begin());
    }
    figure.chart["encoding"]["color"]["scale"] = {{"domain", order}, {"range", range}};
    figure.chart["encoding"]["strokeDash"]["scale"] = {
        {"domain", order}, {"range", json::parse("[[1, 0], [6, 3], [2, 2], [8, 2, 2, 2]]")}};
    return figure;
}

} // namespace suffuse::report
