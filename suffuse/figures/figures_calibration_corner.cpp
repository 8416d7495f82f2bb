#include "suffuse/figures/calibration_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace suffuse::figures {
namespace {

using nlohmann::json;

constexpr std::size_t most_sets_drawn = 400; // samples of the posterior
constexpr std::size_t most_in_corner = 6;    // parameters
constexpr int histogram_bins = 16;           // of a histogram

/// A scale between these ends, logarithmic where all decades are as likely.
json range_scale(const CalibratedParameter& parameter, double low, double high) {
    return {{"type", parameter.is_log ? "log" : "linear"}, {"domain", {low, high}}, {"nice", false}, {"zero", false}};
}

/// The smallest and the largest value, with a margin.
std::pair<double, double>
drawn_ends(const CalibratedParameter& parameter, std::size_t column, const std::vector<std::vector<double>>& rows) {
    double low = rows.front()[column], high = low;
    for (const std::vector<double>& row : rows) {
        low = std::min(low, row[column]);
        high = std::max(high, row[column]);
    }
    if (low >= high) {
        return {parameter.least, parameter.most};
    }
    if (parameter.is_log) {
        const double margin = std::pow(high / low, 0.03);
        return {low / margin, high * margin};
    }
    const double margin = 0.03 * (high - low);
    return {low - margin, high + margin};
}

/// Axes of a panel that stands with others in rows and columns: shown at the left and at the bottom alone. A vertical
/// one has always the same room, so that columns are straight.
json corner_axis(const std::string& title, bool is_vertical) {
    constexpr int room = 46; // [px]
    json axis = {{"grid", false}, {"tickCount", 3}, {"labelOverlap", "greedy"}, {"format", ".3~g"}, {"title", title}};
    if (is_vertical) {
        axis.update({{"minExtent", room}, {"maxExtent", room}});
    }
    return axis;
}

json without_labels(json axis) {
    axis.update({{"labels", false}, {"ticks", false}, {"title", nullptr}});
    return axis;
}

/// The share of the samples in each of some bins.
json value_histogram(const CalibratedParameter& p, double low, double high, json x_axis) {
    const auto on_scale = [&](double value) { return p.is_log ? std::log10(value) : value; };
    const std::string number = fmt::format("datum['{}']", p.field);
    const auto back = [&](const char* end) {
        return p.is_log ? fmt::format("pow(10, datum.{})", end) : fmt::format("datum.{}", end);
    };
    json panel = {{"height", 90}, {"width", 90}, {"mark", {{"type", "bar"}, {"binSpacing", 0}}}};
    panel["transform"] = {
        {{"calculate", p.is_log ? fmt::format("log({}) / LN10", number) : number}, {"as", "on_scale"}},
        {{"bin",
          {{"extent", {on_scale(low), on_scale(high)}}, {"step", (on_scale(high) - on_scale(low)) / histogram_bins}}},
         {"field", "on_scale"},
         {"as", {"from", "to"}}},
        {{"aggregate", {{{"op", "count"}, {"as", "samples"}}}}, {"groupby", {"from", "to"}}},
        {{"calculate", back("from")}, {"as", "begin"}},
        {{"calculate", back("to")}, {"as", "end"}}};
    json x = number_channel("begin", nullptr);
    x.erase("title");
    x["scale"] = range_scale(p, low, high);
    x["axis"] = x_axis;
    panel["encoding"] = {
        {"x", x},
        {"x2", {{"field", "end"}}},
        {"y", number_channel("samples", nullptr)},
        {"y2", {{"datum", 0}}},
        {"color", {{"value", color::staying}}},
        {"tooltip",
         {{{"field", "begin"}, {"title", "from"}, {"format", ".4g"}},
          {{"field", "end"}, {"title", "to"}, {"format", ".4g"}},
          {{"field", "samples"}, {"title", "samples"}}}}};
    panel["encoding"]["y"]["axis"] = nullptr;
    return panel;
}

} // namespace

std::optional<Figure>
calibration_corner(const std::vector<CalibratedParameter>& all, const std::vector<std::vector<double>>& posterior) {
    if (all.size() < 2 || posterior.size() < 2) {
        return std::nullopt;
    }
    const std::size_t count = std::min(all.size(), most_in_corner),
                      step = std::max<std::size_t>(1, posterior.size() / most_sets_drawn);
    const std::vector<CalibratedParameter> parameters(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
    Figure figure = calibration_figure("own-calibration-corner", "Parameters", "Posterior of each pair", "");
    std::vector<std::vector<double>> drawn;
    for (std::size_t k = 0; k < posterior.size(); k += step) {
        drawn.push_back(posterior[k]);
    }
    json rows = json::array();
    for (std::size_t a = 0; a < count; ++a) {
        const bool is_last = a + 1 == count;
        std::vector<double> values;
        for (const std::vector<double>& row : drawn) {
            values.push_back(row[a]);
        }
        figure.table.add(parameters[a].field, parameters[a].unit, std::move(values));
        json panels = json::array();
        const auto [low, high] = drawn_ends(parameters[a], a, posterior);
        for (std::size_t b = 0; b < a; ++b) {
            const auto [left, right] = drawn_ends(parameters[b], b, posterior);
            json x = number_channel(parameters[b].field, with_unit(parameters[b])),
                 y = number_channel(parameters[a].field, with_unit(parameters[a]));
            x["scale"] = range_scale(parameters[b], left, right);
            y["scale"] = range_scale(parameters[a], low, high);
            x["axis"] = is_last ? corner_axis(with_unit(parameters[b]), false) : without_labels(corner_axis("", false));
            y["axis"] = b == 0 ? corner_axis(with_unit(parameters[a]), true) : json(nullptr);
            json panel = {
                {"width", 90},
                {"height", 90},
                {"mark", {{"type", "point"}, {"filled", true}, {"size", 8}, {"opacity", 0.35}}}};
            panel["encoding"] = {{"x", x}, {"y", y}, {"color", {{"value", color::staying}}}};
            panels.push_back(std::move(panel));
        }
        const json below = corner_axis(with_unit(parameters[a]), false);
        json diagonal = value_histogram(parameters[a], low, high, is_last ? below : without_labels(below));
        if (a == 0) { // as wide as the axes of the rows below
            diagonal["encoding"]["y"]["axis"] = without_labels(corner_axis("", true));
            diagonal["encoding"]["y"]["axis"]["title"] = " ";
        }
        panels.push_back(std::move(diagonal));
        rows.push_back({{"hconcat", std::move(panels)}, {"spacing", 8}});
    }
    figure.chart = {{"vconcat", std::move(rows)}, {"spacing", 8}};
    figure.caption = fmt::format(
        "{} of {} equally likely sets of parameters; all are in posterior.csv. On the diagonal: how often each value "
        "occurs. A narrow slanted cloud: the two parameters replace each other.{}",
        drawn.size(), posterior.size(),
        count < all.size() ? fmt::format(" The first {} of {} parameters.", count, all.size()) : ""
    );
    return figure;
}

} // namespace suffuse::figures
