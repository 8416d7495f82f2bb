#include "suffuse/figures/size_axis.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/figures/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <vector>

namespace suffuse::figures {

using nlohmann::json;

namespace {

/// Round sizes between `from` and `to`, at least four where they exist.
json log_ticks(double from, double to) {
    for (const std::vector<double>& steps : {std::vector<double>{1}, {1, 2, 5}, {1, 1.5, 2, 3, 4, 5, 7}}) {
        json ticks = json::array();
        for (int decade = static_cast<int>(std::floor(std::log10(from))); std::pow(10.0, decade) <= to; ++decade) {
            for (const double step : steps) {
                // Read from text, so that 0.3 is 0.3 and not the nearest product.
                const double tick = std::strtod(fmt::format("{}e{}", step, decade).c_str(), nullptr);
                if (tick >= from && tick <= to) {
                    ticks.push_back(tick);
                }
            }
        }
        if (ticks.size() >= 4 || steps.size() == 7) {
            return ticks;
        }
    }
    return json::array();
}

/// ISO 14688: where the classes of grain size begin [mm].
struct SizeClass {
    double from;
    const char* name;
};

constexpr SizeClass size_classes[] = {{0.0001, "clay"},        {0.002, "fine silt"}, {0.0063, "medium silt"},
                                      {0.02, "coarse silt"},   {0.063, "fine sand"}, {0.2, "medium sand"},
                                      {0.63, "coarse sand"},   {2.0, "fine gravel"}, {6.3, "medium gravel"},
                                      {20.0, "coarse gravel"}, {63.0, "cobbles"}};

} // namespace

json size_axis(double from, double to, bool reversed) {
    return {
        {"type", "quantitative"},
        {"title", "grain diameter d [mm]"},
        {"axis", {{"values", log_ticks(from, to)}, {"format", "~g"}, {"labelOverlap", "greedy"}}},
        {"scale", {{"type", "log"}, {"domain", {from, to}}, {"nice", false}, {"reverse", reversed}}}};
}

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
        // A name takes about an eighth of the width.
        if (std::log(end / begin) > std::log(to / from) / 8) {
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

json fines_layers(double from, double limit, bool is_reversed) {
    const json data = {
        {"values", {{{"from", from}, {"to", limit}, {"text", "fines, d < " + short_number(limit) + " mm"}}}}};
    json layers = json::array();
    layers.push_back(
        {{"data", data},
         {"mark", {{"type", "rect"}, {"color", color::fines}, {"opacity", 0.12}}},
         {"encoding", {{"x", {{"field", "from"}, {"type", "quantitative"}}}, {"x2", {{"field", "to"}}}}}}
    );
    json text = {{"type", "text"}, {"baseline", "top"}, {"dy", 8}, {"dx", 6}, {"color", color::ink}};
    text["align"] = "left"; // from the axis on: centered, a name wider than the fines would leave the frame
    layers.push_back(
        {{"data", data},
         {"mark", text},
         {"encoding",
          {{"x", {{"field", is_reversed ? "to" : "from"}, {"type", "quantitative"}}},
           {"y", {{"value", 0}}},
           {"text", {{"field", "text"}}}}}}
    );
    return layers;
}

} // namespace suffuse::figures
