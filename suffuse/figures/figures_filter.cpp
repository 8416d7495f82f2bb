// Ours: does a filter hold its base, and what of it passes?
#include "suffuse/figures/figures_filter.hpp"

#include "suffuse/base/escaped.hpp"
#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::figures {
namespace {

using erosion::BaseProfile;
using erosion::BaseSizes;
using erosion::StackCut;
using nlohmann::json;

constexpr std::size_t most_panels = 6, most_cuts = 3;
constexpr double in_mm = 1e3;

/// Of stacks, as many as are shown.
std::vector<MigrationCurve> stacks_of(const std::vector<MigrationCurve>& curves, std::size_t most) {
    std::vector<MigrationCurve> stacks;
    for (const MigrationCurve& curve : curves) {
        if (!curve.result.profile.base.empty() && !curve.result.holds.empty() && stacks.size() < most) {
            stacks.push_back(curve);
        }
    }
    return stacks;
}

json panels(const std::vector<MigrationCurve>& stacks, json spec) {
    std::vector<std::string> names;
    names.reserve(stacks.size());
    for (const MigrationCurve& stack : stacks) {
        names.push_back(stack.name);
    }
    return {
        {"facet",
         {{"field", "stage"},
          {"type", "nominal"},
          {"title", nullptr},
          {"sort", names},
          {"header", {{"labelAnchor", "start"}}}}},
        {"columns", stacks.size() > 1 ? 2 : 1},
        {"spec", std::move(spec)}};
}

json quantity(const char* field, const char* title) {
    return {{"field", field}, {"type", "quantitative"}, {"title", title}};
}

/// Colors and dashes of the three curves or two, by their names.
json line_of(const std::vector<std::string>& names, const std::vector<std::string>& colors) {
    return {
        {"field", "what"},
        {"type", "nominal"},
        {"title", nullptr},
        {"scale", {{"domain", names}, {"range", colors}}},
        {"legend", {{"orient", "top"}}}};
}

/// "s/flow: 2 % of the base passed, 12 % is beyond the interface; ..."
std::string what_passed(const std::vector<MigrationCurve>& stacks) {
    std::string words;
    for (const MigrationCurve& stack : stacks) {
        const erosion::MigrationHold& end = stack.result.holds.back();
        words += fmt::format(
            "{}{}: {} % of the base passed, and {} % went beyond the interface", words.empty() ? "" : "; ", stack.name,
            short_number(100 * end.eroded_mass_share, 2), short_number(100 * end.entered_mass_share, 2)
        );
    }
    return as_sentence(words) + ". ";
}

Figure begin_figure(const char* id, const char* title) {
    Figure figure;
    figure.id = id;
    figure.section = "Filter";
    figure.title = title;
    return figure;
}

// Lengths of the drawing, in its own pixels.
constexpr double cut_width = 260, cut_gap = 40, cut_left = 16, cut_head = 46;

/// One state of a stack, as it is cut: grains that reach over a side come in again at the other one. @param x, y where
/// it begins
std::string draw_cut(const StackCut& cut, double first, double x, double y, double scale, double height) {
    std::string out = fmt::format(
        R"(<g><rect class="flow-box" x="{0:.1f}" y="{1:.1f}" width="{2:.1f}" height="{3:.1f}" fill="none" stroke="#8a8577"/>)"
        R"(<svg x="{0:.1f}" y="{1:.1f}" width="{2:.1f}" height="{3:.1f}">)"
        "\n",
        x, y, cut_width, height
    );
    for (std::size_t k = 0; k < cut.radius.size(); ++k) {
        const double radius = cut.radius[k] * scale;
        for (const int image : {-1, 0, 1}) {
            const double across = (cut.across[k] + image * cut.width) * scale;
            if (across + radius > 0 && across - radius < cut_width) {
                out += fmt::format(
                    R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" fill="{}"/>)"
                    "\n",
                    across, (cut.along[k] - first) * scale, radius, cut.is_base[k] != 0 ? color::fines : color::coarse
                );
            }
        }
    }
    const double interface = y - first * scale;
    return out + fmt::format(
                     R"(</svg><path d="M{0:.1f} {1:.1f}H{2:.1f}" stroke="{3}" stroke-dasharray="5 4" fill="none"/></g>)"
                     "\n",
                     x, interface, x + cut_width, color::staying
                 );
}

std::string cut_label(double x, double y, const std::string& words) {
    return fmt::format(
        R"(<text class="flow-label" x="{:.1f}" y="{:.1f}" fill="#333333">{}</text>)"
        "\n",
        x, y, escaped(words)
    );
}

std::string draw_cuts(const std::vector<MigrationCurve>& stacks) {
    std::string out;
    double y = 0;
    for (const MigrationCurve& stack : stacks) {
        const BaseProfile& profile = stack.result.profile;
        const StackCut& before = stack.result.filter.before;
        const double scale = cut_width / before.width;     // pixels a meter
        const double first = profile.first - profile.step; // its face is rough, too
        const double length = static_cast<double>(profile.filter.size() + 1) * profile.step, height = length * scale;
        const double right = cut_left + cut_width + cut_gap;
        out += cut_label(cut_left, y + 16, stack.name);
        out += cut_label(cut_left, y + 36, "before") + cut_label(right, y + 36, "at the end");
        out += draw_cut(before, first, cut_left, y + cut_head, scale, height);
        out += draw_cut(stack.result.filter.after, first, right, y + cut_head, scale, height);
        y += cut_head + height + 24;
    }
    const double width = 2 * cut_left + 2 * cut_width + cut_gap;
    return fmt::format(
               R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0:.0f} {1:.0f}" width="{0:.0f}" )"
               R"(height="{1:.0f}" font-family="Helvetica, Arial, 'DejaVu Sans', sans-serif" font-size="14" role="img">)"
               "\n",
               width, y
           ) +
           out + "</svg>\n";
}

} // namespace

std::optional<Figure> filter_profile(const std::vector<MigrationCurve>& curves) {
    const std::vector<MigrationCurve> stacks = stacks_of(curves, most_panels);
    if (stacks.empty()) {
        return std::nullopt;
    }
    const std::vector<std::string> names = {"filter", "base before", "base at the end"};
    std::vector<std::string> stage, what;
    std::vector<double> depth, solid;
    for (const MigrationCurve& stack : stacks) {
        const BaseProfile& profile = stack.result.profile;
        const auto add = [&](const std::string& name, const std::vector<double>& of_slice) {
            for (std::size_t k = 0; k < of_slice.size(); ++k) {
                stage.push_back(stack.name);
                what.push_back(name);
                depth.push_back(in_mm * (profile.first + (static_cast<double>(k) + 0.5) * profile.step));
                solid.push_back(100 * of_slice[k]);
            }
        };
        add(names[0], profile.filter);
        add(names[1], profile.base.front());
        add(names[2], profile.base.back());
    }
    Figure figure = begin_figure("own-filter-profile", "Where the base is, and where it was");
    figure.caption = what_passed(stacks) +
                     "Solid volume of filter and base in slices half of a filter grain thick, over that of the slice. "
                     "The depth counts from where the filter begins; the water flows to the right.";
    figure.table.add("stage", std::move(stage));
    figure.table.add("what", std::move(what));
    figure.table.add("depth", "mm", std::move(depth));
    figure.table.add("solid", "%", std::move(solid));
    json spec = {{"width", 300}, {"height", 180}};
    spec["mark"] = {{"type", "line"}, {"interpolate", "step"}, {"strokeWidth", 2}};
    spec["encoding"] = {
        {"x", quantity("depth", "depth in the filter [mm]")},
        {"y", quantity("solid", "solid [%]")},
        {"color", line_of(names, {color::coarse, color::quiet, color::fines})},
        {"strokeDash",
         {{"field", "what"},
          {"type", "nominal"},
          {"legend", nullptr},
          {"scale", {{"domain", names}, {"range", {{1, 0}, {4, 3}, {1, 0}}}}}}},
        {"tooltip",
         {{{"field", "what"}, {"title", "of"}},
          {{"field", "depth"}, {"title", "depth [mm]"}, {"format", ".3g"}},
          {{"field", "solid"}, {"title", "solid [%]"}, {"format", ".3g"}}}}};
    figure.chart = panels(stacks, std::move(spec));
    return figure;
}

std::optional<Figure> filter_cut(const std::vector<MigrationCurve>& curves) {
    std::vector<MigrationCurve> stacks = stacks_of(curves, curves.size());
    std::erase_if(stacks, [](const MigrationCurve& stack) { return stack.result.filter.before.radius.empty(); });
    if (stacks.empty()) {
        return std::nullopt;
    }
    stacks.resize(std::min(stacks.size(), most_cuts));
    Figure figure = begin_figure("own-filter-cut", "A cut through base and filter, before and at the end");
    figure.caption = what_passed(stacks) +
                     "A plane along the flow through the middle of the sample cuts each grain in a circle; the water "
                     "flows down the page. The dashed line is where the filter began; what left is not drawn.";
    std::vector<std::string> stage, state, layer;
    std::vector<double> depth, across, diameter;
    for (const MigrationCurve& stack : stacks) {
        const auto add = [&](const std::string& name, const StackCut& cut) {
            for (std::size_t k = 0; k < cut.radius.size(); ++k) {
                stage.push_back(stack.name);
                state.push_back(name);
                layer.emplace_back(cut.is_base[k] != 0 ? "base" : "filter");
                depth.push_back(in_mm * cut.along[k]);
                across.push_back(in_mm * cut.across[k]);
                diameter.push_back(2 * in_mm * cut.radius[k]);
            }
        };
        add("before", stack.result.filter.before);
        add("at the end", stack.result.filter.after);
    }
    figure.table.add("stage", std::move(stage));
    figure.table.add("state", std::move(state));
    figure.table.add("layer", std::move(layer));
    figure.table.add("depth", "mm", std::move(depth));
    figure.table.add("across", "mm", std::move(across));
    figure.table.add("circle", "mm", std::move(diameter));
    figure.drawing = draw_cuts(stacks);
    return figure;
}

std::optional<Figure> filter_sizes(const std::vector<MigrationCurve>& curves) {
    std::vector<MigrationCurve> stacks = stacks_of(curves, curves.size());
    std::erase_if(stacks, [](const MigrationCurve& stack) { return stack.result.filter.sizes.diameter.empty(); });
    if (stacks.empty()) {
        return std::nullopt;
    }
    stacks.resize(std::min(stacks.size(), most_panels));
    const std::vector<std::string> names = {"beyond the interface", "left the filter"};
    std::vector<std::string> stage, what;
    std::vector<double> size, share;
    std::string constrictions;
    for (const MigrationCurve& stack : stacks) {
        const erosion::FilterView& view = stack.result.filter;
        const auto add = [&](const std::string& name, const std::vector<double>& of_size) {
            for (std::size_t k = 0; k < of_size.size(); ++k) {
                stage.push_back(stack.name);
                what.push_back(name);
                size.push_back(in_mm * view.sizes.diameter[k]);
                share.push_back(100 * of_size[k]);
            }
        };
        add(names[0], view.sizes.entered);
        add(names[1], view.sizes.eroded);
        constrictions += fmt::format(
            "{}{} mm for {}", constrictions.empty() ? "" : ", ", short_number(in_mm * view.constriction, 2), stack.name
        );
    }
    Figure figure = begin_figure("own-filter-sizes", "Which sizes of the base pass");
    figure.caption = what_passed(stacks) +
                     "Of each size of the base, in classes of equal mass, the share that passed the interface and the "
                     "share that left the filter. The filter's controlling constriction, without its base, is " +
                     constrictions + ".";
    figure.table.add("stage", std::move(stage));
    figure.table.add("what", std::move(what));
    figure.table.add("size", "mm", std::move(size));
    figure.table.add("share", "%", std::move(share));
    json spec = {{"width", 300}, {"height", 160}};
    spec["mark"] = {{"type", "line"}, {"point", true}, {"strokeWidth", 2}};
    spec["encoding"] = {
        {"x", quantity("size", "size of the base grains [mm]")},
        {"y", quantity("share", "of that size [%]")},
        {"color", line_of(names, {color::staying, color::fines})},
        {"tooltip",
         {{{"field", "what"}, {"title", "share that"}},
          {{"field", "size"}, {"title", "size [mm]"}, {"format", ".3g"}},
          {{"field", "share"}, {"title", "share [%]"}, {"format", ".3g"}}}}};
    spec["encoding"]["x"]["scale"] = {{"zero", false}};
    spec["encoding"]["y"]["scale"] = {{"domainMin", 0}};
    figure.chart = panels(stacks, std::move(spec));
    figure.chart["resolve"] = {{"scale", {{"x", "independent"}}}};
    return figure;
}

} // namespace suffuse::figures
