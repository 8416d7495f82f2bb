// Figure 1: the gradings that are mixed, one for each fines content.
#include "suffuse/base/words.hpp"
#include "suffuse/figures/figures_fines.hpp"
#include "suffuse/figures/size_axis.hpp"
#include "suffuse/grains/grading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::figures {

namespace {

using grains::Grading;
using nlohmann::json;

constexpr int curve_points = 60;         ///< of a specified line, besides its corners
constexpr int sample_points = 24;        ///< of a sample, drawn as dots
constexpr std::size_t most_corners = 50; ///< a curve with more is smooth as it is

/// Evenly spaced on the logarithmic axis, and where the curve has its corners.
std::vector<double> sizes_of(const Grading& grading, double from, double to, int count) {
    std::vector<double> sizes = grading.diameter.size() < most_corners ? grading.diameter : std::vector<double>{};
    for (int k = 0; k < count; ++k) {
        sizes.push_back(from * std::pow(to / from, static_cast<double>(k) / (count - 1)));
    }
    std::sort(sizes.begin(), sizes.end());
    return sizes;
}

struct Columns {
    std::vector<std::string> mixture, kind;
    std::vector<double> fines_content, diameter, passing;

    void add(const study::Mixture& of, const char* what, const Grading& grading, double from, double to, int count) {
        for (const double d : sizes_of(grading, from, to, count)) {
            mixture.push_back("FC " + study::percent_name(of.fines_content));
            kind.emplace_back(what);
            fines_content.push_back(100 * of.fines_content);
            diameter.push_back(1e3 * d);
            passing.push_back(100 * grains::passing(grading, d));
        }
    }
};

double largest_difference(const study::Mixture& mixture) {
    double largest = 0;
    for (const double d : mixture.sampled.diameter) {
        largest =
            std::max(largest, std::abs(grains::passing(mixture.specified, d) - grains::passing(mixture.sampled, d)));
    }
    return largest;
}

} // namespace

std::optional<Figure> mixture_gradings(const std::vector<study::Mixture>& mixtures, GradingAxis axis) {
    if (mixtures.empty()) {
        return std::nullopt;
    }
    double from = mixtures[0].specified.diameter.front(), to = mixtures[0].specified.diameter.back(), difference = 0;
    json names = json::array();
    std::vector<double> contents;
    for (const study::Mixture& mixture : mixtures) {
        from = std::min(from, mixture.specified.diameter.front());
        to = std::max(to, mixture.specified.diameter.back());
        difference = std::max(difference, largest_difference(mixture));
        names.push_back("FC " + study::percent_name(mixture.fines_content));
        contents.push_back(mixture.fines_content);
    }
    const json colors = study::fines_colors(contents);
    Columns columns;
    bool has_samples = false;
    for (const study::Mixture& mixture : mixtures) {
        columns.add(mixture, "specified", mixture.specified, from, to, curve_points);
        if (!mixture.sampled.diameter.empty()) {
            columns.add(mixture, "sample", mixture.sampled, from, to, sample_points);
            has_samples = true;
        }
    }
    Figure figure;
    figure.id = "fig01";
    figure.section = "Soils";
    figure.title = "Gradings of the mixtures";
    figure.caption = fmt::format(
        "Sand and silt mixed to fines contents of {} to {} by mass.",
        study::percent_name(mixtures.front().fines_content), study::percent_name(mixtures.back().fines_content)
    );
    if (has_samples) {
        figure.caption += fmt::format(
            " Dots: one sample of each, which follows its grading within {} % of the mass.",
            short_number(100 * difference, 2)
        );
    }
    json layers = class_layers(1e3 * from / 1.15, 1e3 * to * 1.15);
    json drawn = json::parse(R"json([
        {"transform": [{"filter": "datum.kind == 'specified'"}], "mark": {"type": "line", "strokeWidth": 1.8},
         "encoding": {"order": {"field": "diameter"}}},
        {"transform": [{"filter": "datum.kind == 'sample'"}], "mark": {"type": "point", "filled": true, "size": 20, "opacity": 1},
         "encoding": {"tooltip": [{"field": "mixture", "title": "mixture"}, {"field": "diameter", "title": "d [mm]", "format": ".4g"},
                        {"field": "passing", "title": "F [%]", "format": ".4g"}]}}
    ])json");
    for (json& layer : drawn) {
        json& encoding = layer["encoding"];
        encoding["x"] = {{"field", "diameter"}, {"type", "quantitative"}};
        encoding["y"] = {
            {"field", "passing"},
            {"type", "quantitative"},
            {"title", "passing by mass F [%]"},
            {"scale", {{"domain", {0, 100}}}}};
        encoding["color"] = {
            {"field", "mixture"},
            {"type", "nominal"},
            {"title", nullptr},
            {"scale", {{"domain", names}, {"range", colors}}},
            {"legend", {{"columns", 7}}}};
        layers.push_back(std::move(layer));
    }
    figure.chart = {
        {"width", 560},
        {"height", 300},
        {"encoding", {{"x", size_axis(1e3 * from / 1.15, 1e3 * to * 1.15, axis == GradingAxis::Reversed)}}},
        {"layer", std::move(layers)}};
    figure.table.add("mixture", std::move(columns.mixture));
    figure.table.add("kind", std::move(columns.kind));
    figure.table.add("fines_content", "%", std::move(columns.fines_content));
    figure.table.add("diameter", "mm", std::move(columns.diameter));
    figure.table.add("passing", "%", std::move(columns.passing));
    return figure;
}

} // namespace suffuse::figures
