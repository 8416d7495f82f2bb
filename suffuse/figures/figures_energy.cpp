#include "suffuse/figures/figures_energy.hpp"

#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::figures {

namespace {

using nlohmann::json;

/// A part of the work as it is drawn.
struct Part {
    const char* name;
    double dem::EnergyParts::*energy;
    const char* color;
};

constexpr std::array<Part, 5> parts = {
    {{"slip", &dem::EnergyParts::slip, color::coarse},
     {"rolling", &dem::EnergyParts::rolling, color::staying},
     {"springs", &dem::EnergyParts::springs, "#5aa17f"},
     {"motion", &dem::EnergyParts::motion, "#9467bd"},
     {"damping", &dem::EnergyParts::damping, color::fines}}};

/// What the parts share: the work, and what springs gave back, as those of a sample that liquefies do.
double spent(const dem::EnergyParts& energy) {
    return energy.work + std::max(0.0, -energy.springs);
}

double share_of(const dem::EnergyParts& energy, double dem::EnergyParts::*part) {
    return 100 * std::max(0.0, energy.*part) / spent(energy);
}

/// "28 %", or "24 to 30 %" over several tests.
std::string range_of_share(const std::vector<TestEnergy>& tests, double dem::EnergyParts::*energy) {
    double least = 100, most = -100;
    for (const TestEnergy& test : tests) {
        const double share = share_of(test.energy, energy);
        least = std::min(least, share), most = std::max(most, share);
    }
    const std::string from = short_number(least, 2), to = short_number(most, 2);
    return from == to ? from + " %" : from + " to " + to + " %";
}

} // namespace

std::optional<Figure> energy_of_tests(const std::vector<TestEnergy>& all) {
    std::vector<TestEnergy> tests = all;
    std::erase_if(tests, [](const TestEnergy& test) { return !(spent(test.energy) > 0); });
    if (tests.empty()) {
        return std::nullopt;
    }
    std::vector<std::string> name, part;
    std::vector<double> energy, share;
    double gap = 0;
    bool gives_back = false;
    json order = json::array();
    for (const TestEnergy& test : tests) {
        for (const Part& each : parts) {
            name.push_back(test.name);
            part.emplace_back(each.name);
            energy.push_back(test.energy.*each.energy / 1e3);
            share.push_back(share_of(test.energy, each.energy));
        }
        order.push_back(test.name);
        gap = std::max(gap, std::abs(test.energy.unaccounted()) / spent(test.energy));
        gives_back = gives_back || test.energy.springs < 0;
    }
    json names = json::array(), colors = json::array();
    for (const Part& each : parts) {
        names.push_back(each.name);
        colors.push_back(each.color);
    }
    Figure figure;
    figure.id = "own-energy";
    figure.section = "Tests";
    figure.title = "Where the work of the tests goes";
    figure.caption = fmt::format(
        "Of the work done on the {}, sliding contacts take {} and rolling ones {}, {} stays in the springs, and "
        "numerical damping takes {}. The parts are computed independently and add up to the work within {} %.",
        tests.size() == 1 ? "sample" : "samples", range_of_share(tests, &dem::EnergyParts::slip),
        range_of_share(tests, &dem::EnergyParts::rolling), range_of_share(tests, &dem::EnergyParts::springs),
        range_of_share(tests, &dem::EnergyParts::damping), short_number(100 * gap, 2)
    );
    if (gives_back) {
        figure.caption += " Energy released by springs counts as work.";
    }
    figure.table.add("test", std::move(name));
    figure.table.add("part", std::move(part));
    figure.table.add("energy", "kJ/m³", std::move(energy));
    figure.table.add("share", "%", std::move(share));
    figure.chart = json::parse(R"json({
        "width": 480, "height": {"step": 30},
        "mark": {"type": "bar"},
        "encoding": {
            "y": {"field": "test", "type": "nominal", "title": null, "axis": {"labelLimit": 420}},
            "x": {"field": "share", "type": "quantitative", "title": "share of the work [%]",
                  "stack": "zero", "scale": {"nice": false}},
            "color": {"field": "part", "type": "nominal", "title": null},
            "tooltip": [
                {"field": "test", "title": "test"}, {"field": "part", "title": "part"},
                {"field": "energy", "title": "energy [kJ/m³]", "format": ".4g"},
                {"field": "share", "title": "share [%]", "format": ".3g"}]}
    })json");
    json& encoding = figure.chart["encoding"];
    encoding["y"]["sort"] = order;
    encoding["color"]["scale"] = {{"domain", names}, {"range", colors}};
    return figure;
}

} // namespace suffuse::figures
