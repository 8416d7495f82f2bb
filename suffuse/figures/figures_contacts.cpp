// Figures 5 and 6: who touches whom over the fines content, and which of it is strong.
#include "suffuse/base/words.hpp"
#include "suffuse/figures/figures_fines.hpp"
#include "suffuse/figures/fines_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace suffuse::figures {

namespace {

using nlohmann::json;

/// The axis of shares, from none to `most` [%].
void set_domain(json& chart, double most) {
    for (json& layer : chart["layer"]) {
        json& encoding = layer["encoding"];
        if (encoding.contains("y") && !encoding["y"].contains("scale")) {
            encoding["y"]["scale"] = {{"domain", {0, most}}, {"nice", false}};
            encoding["y"]["axis"] = {{"values", json::array()}}; // room above a hundred percent is not for numbers
            for (int tick = 0; tick <= std::min(100.0, most); tick += most > 50 ? 20 : 10) {
                encoding["y"]["axis"]["values"].push_back(tick);
            }
        }
    }
}

/// The arrangement that the paper sets into its Figure 6: fines between coarse grains, forces through them. In an upper
/// corner of the panel, the one next to the highest point of the curve.
json active_arrangement(bool to_the_right) {
    struct Disk {
        double x, y, radius;
    };

    static constexpr std::array<Disk, 6> disks = {
        {{62, 32, 24}, {31, 85.7, 24}, {93, 85.7, 24}, {46.5, 58.9, 7}, {77.5, 58.9, 7}, {62, 85.7, 7}}};
    const auto from_edge = [&](double x) { return to_the_right ? x - 124 : x; };
    json grains = json::array(), forces = json::array();
    for (const Disk& disk : disks) {
        const bool is_coarse = disk.radius > 10;
        grains.push_back(
            {{"px", from_edge(disk.x)},
             {"py", disk.y},
             {"area", std::numbers::pi * disk.radius * disk.radius},
             {"ink", is_coarse ? color::coarse : color::fines}}
        );
    }
    for (const auto& [from, to] : {std::pair{0, 1}, {1, 2}, {2, 0}}) {
        const Disk &a = disks[static_cast<std::size_t>(from)], &b = disks[static_cast<std::size_t>(to)];
        forces.push_back({{"px", from_edge(a.x)}, {"py", a.y}, {"qx", from_edge(b.x)}, {"qy", b.y}});
    }
    json layers = json::parse(R"json([
        {"mark": {"type": "point", "shape": "circle", "filled": true, "opacity": 1, "stroke": "#666666", "strokeWidth": 0.8,
                  "xOffset": {"expr": "datum.px"}},
         "encoding": {"x": {"value": 0},
                      "y": {"field": "py", "type": "quantitative", "scale": null, "axis": null},
                      "size": {"field": "area", "type": "quantitative", "scale": null},
                      "fill": {"field": "ink", "type": "nominal", "scale": null}}},
        {"mark": {"type": "rule", "color": "#6d7278", "strokeWidth": 2.5,
                  "xOffset": {"expr": "datum.px"}, "x2Offset": {"expr": "datum.qx"}},
         "encoding": {"x": {"value": 0}, "x2": {"value": 0},
                      "y": {"field": "py", "type": "quantitative", "scale": null, "axis": null}, "y2": {"field": "qy"}}}
    ])json");
    layers[0]["data"]["values"] = grains;
    layers[1]["data"]["values"] = forces;
    for (json& layer : layers) {
        for (const char* channel : {"x", "x2"}) {
            if (to_the_right && layer["encoding"].contains(channel)) {
                layer["encoding"][channel] = {{"value", "width"}};
            }
        }
    }
    return layers;
}

/// Largest share of one line, and where.
std::pair<double, double> peak(const study::FinesStudy& study, const FinesLine& line) {
    double most = 0, at = 0;
    for (std::size_t k = 0; k < line.curve->points.size(); ++k) {
        const study::Scatter value = study::number_of(line.curve->points[k], study.fines_content[k], line.number);
        if (value.seeds > 0 && value.mean > most) {
            most = value.mean;
            at = study.fines_content[k];
        }
    }
    return {most, at};
}

} // namespace

std::optional<Figure> contact_classes(const study::FinesStudy& study) {
    const std::vector<FinesLine> lines = {
        {"LL (large-large)", color::coarse, &study.loose, "contact_share.LL"},
        {"LS (large-small)", color::staying, &study.loose, "contact_share.LS"},
        {"SS (small-small)", color::fines, &study.loose, "contact_share.SS"}};
    FinesTable numbers("share_of_contacts", "%", 100);
    for (const FinesLine& line : lines) {
        numbers.add(study, line);
    }
    if (numbers.most_samples() == 0) {
        return std::nullopt;
    }
    const auto [most, at] = peak(study, lines[1]);
    Figure figure;
    figure.id = "fig05";
    figure.section = "Fines and structure";
    figure.title = "Contacts of large and small grains";
    figure.claim = fmt::format(
        "Large-small contacts are most frequent at FC = {} ({} %)", study::percent_name(at), short_number(100 * most)
    );
    figure.caption =
        fmt::format("Shares of the contacts by class, {}.", study::name_of_loose(study.loose, study.dense));
    figure.caption += about_bars(numbers.most_samples());
    figure.chart = fines_panel(study, lines, "share_of_contacts", "share of all contacts [%]", study.activity);
    set_domain(figure.chart, 100);
    figure.table = std::move(numbers).table();
    return figure;
}

std::optional<Figure> strong_contacts(const study::FinesStudy& study) {
    const FinesLine line{"LS among strong contacts", color::staying, &study.loose, "strong_contact_share.LS"};
    FinesTable numbers("strong_share", "%", 100);
    numbers.add(study, line);
    if (numbers.most_samples() == 0) {
        return std::nullopt;
    }
    const auto [most, at] = peak(study, line);
    Figure figure;
    figure.id = "fig06";
    figure.section = "Fines and structure";
    figure.title = "Large-small contacts among the strong ones";
    figure.claim = fmt::format(
        "Strong large-small contacts are most frequent at FC = {} ({} %)", study::percent_name(at),
        short_number(100 * most)
    );
    figure.caption = fmt::format(
        "Share of large-small contacts among those whose force exceeds the mean over all contacts, {}.",
        study::name_of_loose(study.loose, study.dense)
    );
    figure.caption += " Inset: active fines part large grains and pass strong forces between them.";
    figure.caption += about_bars(numbers.most_samples());
    figure.chart = fines_panel(study, {line}, "strong_share", "LS among the strong contacts [%]", study.activity);
    // Room above the curve for the drawing.
    set_domain(figure.chart, std::clamp(10 * std::ceil(10 * most * 1.5), 10.0, 100.0));
    for (json& layer : figure.chart["layer"]) {
        for (const char* channel : {"color", "strokeDash"}) {
            if (layer["encoding"].contains(channel)) {
                layer["encoding"][channel]["legend"] = nullptr;
            }
        }
    }
    for (json& layer : active_arrangement(at < 0.6 * study.fines_content.back())) {
        figure.chart["layer"].push_back(std::move(layer));
    }
    figure.table = std::move(numbers).table();
    return figure;
}

} // namespace suffuse::figures
