// Figure 8, and what the sizes say: gradings before and after erosion, constrictions and fines.
#include "suffuse/base/quantile.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/figures/figures.hpp"
#include "suffuse/figures/size_axis.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/study/passes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace suffuse::figures {

namespace {

using erosion::ErosionResult;
using erosion::LedgerRow;
using erosion::PassResult;
using grains::Grading;
using nlohmann::json;

constexpr std::size_t most_points = 200; ///< of a curve in a drawing

struct Curves {
    std::vector<std::string> curve;
    std::vector<double> diameter, passing; ///< [mm], [%]
    json order = json::array(), colors = json::array();

    /// A curve with a point for each of thousands of grains is thinned to what can be seen; its ends stay.
    void add(const std::string& name, const char* color, const Grading& grading) {
        order.push_back(name);
        colors.push_back(color);
        const std::size_t last = grading.diameter.size() - 1, steps = std::min(last, most_points - 1);
        for (std::size_t step = 0; step <= steps; ++step) {
            const std::size_t k = steps == 0 ? 0 : step * last / steps;
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

json grading_chart(const Curves& curves, std::optional<double> finer_than, GradingAxis axis) {
    const auto [low, high] = std::minmax_element(curves.diameter.begin(), curves.diameter.end());
    const double from = *low / 1.15, to = *high * 1.15;
    json layers = json::array();
    if (finer_than && 1e3 * *finer_than > from) {
        layers = fines_layers(from, std::min(to, 1e3 * *finer_than), axis == GradingAxis::Reversed);
    }
    for (json& layer : class_layers(from, to)) {
        layers.push_back(std::move(layer));
    }
    json lines = json::parse(R"json({
        "mark": {"type": "line", "strokeWidth": 2.2},
        "encoding": {
            "x": {"field": "diameter", "type": "quantitative"},
            "y": {"field": "passing", "type": "quantitative", "title": "passing by mass F [%]", "scale": {"domain": [0, 100]}},
            "color": {"field": "curve", "type": "nominal", "title": null},
            "strokeDash": {"field": "curve", "type": "nominal", "title": null},
            "order": {"field": "diameter"}
        }
    })json");
    lines["encoding"]["color"]["scale"] = {{"domain", curves.order}, {"range", curves.colors}};
    lines["encoding"]["strokeDash"]["scale"] = {{"domain", curves.order}, {"range", color::dashes()}};
    layers.push_back(lines);
    // Unseen points under the pointer say what a line is and where.
    json points = json::parse(R"json({
        "mark": {"type": "point", "filled": true, "size": 60, "opacity": 0},
        "encoding": {
            "x": {"field": "diameter", "type": "quantitative"},
            "y": {"field": "passing", "type": "quantitative"},
            "tooltip": [{"field": "curve", "title": "curve"}, {"field": "diameter", "title": "d [mm]", "format": ".4g"},
                        {"field": "passing", "title": "F [%]", "format": ".4g"}]
        }
    })json");
    layers.push_back(std::move(points));
    return {
        {"width", 560},
        {"height", 300},
        {"encoding", {{"x", size_axis(from, to, axis == GradingAxis::Reversed)}}},
        {"layer", layers}};
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

/// Of the grains that left, the mass of those finer than this [kg].
double mass_finer_than(double diameter, const std::vector<LedgerRow>& rows) {
    return std::accumulate(rows.begin(), rows.end(), 0.0, [diameter](double sum, const LedgerRow& row) {
        return row.diameter < diameter ? sum + row.mass : sum;
    });
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

/// The mean for each way of merging the pores of one void; nothing for a run of earlier times, which shows one only.
std::string means_by_merge(const PassResult& pass) {
    if (pass.constrictions_by_merge.front().count == 0) {
        return "";
    }
    std::string means;
    for (std::size_t way = 0; way < pores::every_merge.size(); ++way) {
        const erosion::ConstrictionSummary& summary = pass.constrictions_by_merge[way];
        means += fmt::format(
            "{}{} {} mm ({})", means.empty() ? "" : ", ", pores::name_of(pores::every_merge[way]),
            short_number(1e3 * summary.mean), grouped(summary.count)
        );
    }
    return fmt::format(
        " Mean (and number) in pass {} by the way in which pores are merged to voids (`merge`): {}. Drawn is “{}”.",
        pass.pass, means, pores::name_of(pass.merge)
    );
}

} // namespace

std::optional<Figure>
grading_curves(const Grading& specified, const Grading& sampled, std::optional<double> finer_than, GradingAxis axis) {
    if (!is_usable(specified) || !is_usable(sampled)) {
        return std::nullopt;
    }
    Curves curves;
    curves.add("sample", color::staying, sampled);
    curves.add("specified", color::detachable, specified);
    Figure figure;
    figure.id = "fig08";
    figure.section = "Soils";
    figure.title = "Grading of the soil";
    figure.claim = fmt::format(
        "The sample follows the specified grading within {} % of the mass",
        short_number(largest_difference(specified, sampled), 2)
    );
    figure.caption = fmt::format(
        "D50 = {} mm, D60/D10 = {}.", short_number(1e3 * grains::size_at(sampled, 0.5)),
        short_number(grains::uniformity(sampled))
    );
    if (finer_than) {
        figure.caption += fmt::format(
            " Grains smaller than {} mm count as fine (shaded): {} % of the mass.", short_number(1e3 * *finer_than),
            short_number(100 * grains::passing(sampled, *finer_than))
        );
    }
    figure.chart = grading_chart(curves, finer_than, axis);
    figure.table = std::move(curves).table();
    return figure;
}

std::optional<Figure> surrogate_grading(const grains::Soil& soil, GradingAxis axis) {
    if (!soil.surrogate || !is_usable(*soil.measured)) {
        return std::nullopt;
    }
    const grains::Surrogate& surrogate = *soil.surrogate;
    Curves curves;
    curves.add("soil", color::staying, *soil.measured);
    curves.add("surrogate", color::detachable, grains::mixture(*soil.coarse, *soil.fines, soil.fines_content));
    Figure figure;
    figure.id = "own-surrogate";
    figure.section = "Soils";
    figure.title = "The soil and its surrogate";
    figure.claim = fmt::format(
        "Two fractions stand for the soil: {} % of fines, size ratio {}", short_number(100 * soil.fines_content),
        short_number(surrogate.size_ratio)
    );
    figure.caption = fmt::format(
        "The soil's curve is split at {} mm (its fines are shaded). Its parts have a ratio D50/d50 of {}.",
        short_number(1e3 * surrogate.finer_than), short_number(surrogate.ratio_of_soil)
    );
    figure.chart = grading_chart(curves, surrogate.finer_than, axis);
    figure.table = std::move(curves).table();
    return figure;
}

std::optional<Figure> eroded_grading(const Grading& sampled, const ErosionResult& erosion, GradingAxis axis) {
    if (!is_usable(sampled) || erosion.ledger.empty() || !(erosion.initial_mass > 0)) {
        return std::nullopt;
    }
    const double eroded = mass_finer_than(std::numeric_limits<double>::infinity(), erosion.ledger);
    if (!(eroded < erosion.initial_mass)) {
        return std::nullopt;
    }
    // At the sizes of the sample's curve only: between them it is a line, and where the finest leave that line can lie
    // below what left.
    Grading left{sampled.diameter, {}, {}}, remains = left;
    for (std::size_t k = 0; k < sampled.diameter.size(); ++k) {
        const double gone = mass_finer_than(sampled.diameter[k], erosion.ledger), finer = sampled.passing[k];
        left.passing.push_back(gone / eroded);
        remains.passing.push_back((finer * erosion.initial_mass - gone) / (erosion.initial_mass - eroded));
    }
    Curves curves;
    curves.add("before erosion", color::staying, sampled);
    curves.add("what left", color::fines, left);
    curves.add("what remains", color::coarse, remains);
    Figure figure;
    figure.id = "own-eroded-grading";
    figure.section = "Erosion";
    figure.title = "Grading before erosion, of what left and of what remains";
    figure.claim = fmt::format(
        "D50 of what left: {} mm; of what remains: {} mm", short_number(1e3 * grains::size_at(left, 0.5), 2),
        short_number(1e3 * grains::size_at(remains, 0.5), 2)
    );
    figure.caption = fmt::format(
        "{} with {} % of the mass left; D50 moves from {} to {} mm.",
        erosion.ledger.size() == 1 ? "1 grain" : grouped(std::ssize(erosion.ledger)) + " grains",
        short_number(100 * eroded / erosion.initial_mass), short_number(1e3 * grains::size_at(sampled, 0.5)),
        short_number(1e3 * grains::size_at(remains, 0.5))
    );
    figure.chart = grading_chart(curves, std::nullopt, axis);
    figure.table = std::move(curves).table();
    return figure;
}

std::optional<Figure> constriction_sizes(const ErosionResult& erosion) {
    std::vector<std::string> curve, order;
    std::vector<double> size, share;
    std::string claim, stresses;
    constexpr std::size_t most_curves = 4;
    const study::SomePasses few = study::few_passes(erosion, most_curves);
    for (const PassResult* pass : few) {
        if (pass->constrictions.diameter.empty()) {
            continue;
        }
        const std::string name = fmt::format("constrictions of pass {}", pass->pass);
        order.push_back(name);
        add_distribution(name, pass->constrictions.diameter, curve, size, share);
        stresses += fmt::format(
            "{}pass {}: mean {}, median {}, D35 {} mm",
            stresses.empty() ? "Constrictions of the coarse skeleton in " : "; ", pass->pass,
            short_number(1e3 * pass->constrictions.mean), short_number(1e3 * pass->constrictions.median),
            short_number(1e3 * pass->constrictions.d35)
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
        stresses += fmt::format("; the largest fine grain: {} mm", short_number(1e3 * largest));
        claim = fmt::format(
            "The largest fine grain is {} than the mean constriction of pass {}",
            largest < first.constrictions.mean ? "smaller" : "larger", first.pass
        );
    }
    Figure figure;
    figure.id = "own-constrictions";
    figure.section = "Water";
    figure.title = "Constriction sizes of the coarse skeleton, and sizes of the fines";
    figure.claim = claim;
    figure.caption = stresses + study::part_of_passes(few, erosion.passes.size()) +
                     ". Shares by number of facets and of grains; the upper hundredth is left out of the drawing." +
                     means_by_merge(first);
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
    figure.chart["encoding"]["strokeDash"]["scale"] = {{"domain", order}, {"range", color::dashes()}};
    return figure;
}

} // namespace suffuse::figures
