// Ours: the fines, with weight, that a gradient moves.
#include "suffuse/figures/figures_mobility.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/study/factor_of_safety.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace suffuse::figures {
namespace {

using erosion::MobilityResult;
using nlohmann::json;
using study::MobilityStory;

constexpr std::size_t most_mobility_curves = 6; ///< as many as there are colors
constexpr double least_mobile_percent = 0.1;    ///< of a logarithmic axis: less is drawn there

/// Columns of the curves, one below the other.
struct MobilityColumns {
    std::vector<std::string> curve;
    std::vector<double> gradient, mobile, leaving, drawn;
    std::vector<std::string> ended; ///< whether motion had, when the gradient rose

    void add(const std::string& name, const MobilityResult& mobility) {
        for (const erosion::MobilityStep& step : mobility.ramp) {
            curve.push_back(name);
            gradient.push_back(step.gradient);
            mobile.push_back(100 * step.mobile_mass_share);
            leaving.push_back(step.leaving_mass_share ? 100 * *step.leaving_mass_share : missing);
            drawn.push_back(std::max(least_mobile_percent, mobile.back()));
            ended.emplace_back(erosion::is_still_growing(step) ? "still growing" : "ended");
        }
    }
};

/// A gradient that something else names: a vertical line with its label.
json marked_gradients(const MobilityStory& story) {
    constexpr int line_height = 14; // [px]: a row each, as they may lie close together
    json marks = json::array();
    const auto mark = [&](double gradient, const char* label) {
        const auto row = static_cast<int>(marks.size());
        marks.push_back({{"at", gradient}, {"label", label}, {"level", row * line_height}});
    };
    if (story.specified_gradient) {
        mark(*story.specified_gradient, "specified");
    }
    if (story.skempton_brogan.seeds > 0) {
        mark(story.skempton_brogan.mean, "α i_c");
    }
    if (story.heave.seeds > 0) {
        mark(story.heave.mean, is_upward(story.one()) ? "heave, i_c" : "heave");
    }
    return marks;
}

json mobility_chart(const json& marks, double last) {
    json chart = json::parse(R"json({
        "width": 560, "height": 320,
        "encoding": {"x": {"type": "quantitative", "title": "hydraulic gradient i [-]"}},
        "layer": [
            {"mark": {"type": "rule", "strokeDash": [4, 3], "color": "#56606c"},
             "encoding": {"x": {"field": "at", "type": "quantitative"}}},
            {"mark": {"type": "text", "align": "left", "dx": 4, "dy": 4, "baseline": "top"},
             "encoding": {"x": {"field": "at", "type": "quantitative"}, "text": {"field": "label"},
                          "y": {"field": "level", "type": "quantitative", "scale": null, "axis": null}}},
            {"mark": {"type": "line", "strokeWidth": 2.4},
             "encoding": {
                "x": {"field": "gradient", "type": "quantitative"},
                "y": {"field": "drawn", "type": "quantitative", "title": "fines that move, by mass [%]",
                      "scale": {"type": "log", "domain": [0.1, 100]}, "axis": {"values": [0.1, 1, 10, 100], "format": "~g"}},
                "color": {"field": "curve", "type": "nominal", "title": null}}},
            {"mark": {"type": "point", "size": 32, "filled": true},
             "encoding": {
                "x": {"field": "gradient", "type": "quantitative"},
                "y": {"field": "drawn", "type": "quantitative"},
                "color": {"field": "curve", "type": "nominal", "title": null},
                "shape": {"field": "motion", "type": "nominal", "legend": null,
                          "scale": {"domain": ["ended", "still growing"], "range": ["circle", "triangle-up"]}},
                "tooltip": [{"field": "curve", "title": "sample"},
                            {"field": "gradient", "title": "i", "format": ".3g"},
                            {"field": "mobile", "title": "moves [%]", "format": ".3g"},
                            {"field": "leaving", "title": "leaves [%]", "format": ".3g"},
                            {"field": "motion", "title": "motion"}]}}
        ]
    })json");
    chart["encoding"]["x"]["scale"] = {{"domain", {0, last}}};
    for (std::size_t k : {0U, 1U}) {
        chart["layer"][k]["data"] = {{"values", marks}};
    }
    return chart;
}

/// Where the fines' sizes are cut: equal parts of their logarithm.
struct SizeClasses {
    double least = 0, most = 0;
    std::size_t count = 1;

    explicit SizeClasses(const MobilityResult& mobility) {
        constexpr double ratio = 1.2; // of a class, about
        const auto [first, last] = std::minmax_element(mobility.diameter.begin(), mobility.diameter.end());
        least = *first, most = *last;
        count = std::clamp<std::size_t>(static_cast<std::size_t>(std::log(most / least) / std::log(ratio)), 1, 8);
    }

    [[nodiscard]] double edge(std::size_t k) const {
        return least * std::pow(most / least, static_cast<double>(k) / static_cast<double>(count));
    }

    [[nodiscard]] std::size_t of(double diameter) const {
        const double part = most > least ? std::log(diameter / least) / std::log(most / least) : 0;
        return std::min(count - 1, static_cast<std::size_t>(part * static_cast<double>(count)));
    }
};

std::string range_text(const SizeClasses& sizes, std::size_t k) {
    return fmt::format("{} to {}", short_number(1e3 * sizes.edge(k)), short_number(1e3 * sizes.edge(k + 1)));
}

/// Gradients at which the shares by size are shown: a few of the ramp below heave.
std::vector<double> shown_gradients(const MobilityResult& mobility) {
    constexpr std::size_t most = 4;
    std::vector<double> shown;
    const std::span<const erosion::MobilityStep> steps = steps_below_heave(mobility);
    for (std::size_t k = 1; k <= most && !steps.empty(); ++k) {
        shown.push_back(steps[std::max<std::size_t>(1, k * steps.size() / most) - 1].gradient);
    }
    shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
    return shown;
}

} // namespace

std::optional<Figure> mobility_curves(const std::vector<MobilityStory>& stories) {
    const MobilityStory* const main = study::main_mobility(stories);
    if (main == nullptr) {
        return std::nullopt;
    }
    MobilityColumns curves;
    double last = 0;
    std::size_t drawn = 0;
    for (const MobilityStory& story : stories) {
        int sample = 0;
        for (const MobilityResult* mobility : story.of_sample) {
            ++sample;
            const std::string name =
                story.of_sample.size() == 1 ? story.name : fmt::format("{}, sample {}", story.name, sample);
            if (drawn++ < most_mobility_curves) {
                curves.add(name, *mobility);
                last = std::max(last, mobility->ramp.back().gradient);
            }
        }
    }
    Figure figure;
    figure.id = "own-mobility";
    figure.section = "Water";
    figure.title = main->specified_gradient && is_met(main->safety, *main)
                       ? fmt::format(
                             "First movement is at {}{} times the specified gradient", main->at_most_1 ? "most " : "",
                             factor_text(main->safety.mean)
                         )
                       : "Fines that a gradient moves";
    figure.caption = fmt::format(
        "Fines count as mobile once the water has moved them half a diameter along the flow, against their weight. 1 % "
        "and 10 % of their mass decide; what is below 0.1 % is drawn there. Where motion had not ended when the "
        "gradient rose, a triangle marks a lower bound. Coarse grains and the {:.0f} % of the fines that carry the "
        "skeleton's forces are held.{}",
        100 * main->one().load_bearing_mass_share,
        drawn > most_mobility_curves ? fmt::format(" The first {} of {} samples.", most_mobility_curves, drawn) : ""
    );
    figure.table.add("curve", std::move(curves.curve));
    figure.table.add("gradient", "-", std::move(curves.gradient));
    figure.table.add("mobile", "%", std::move(curves.mobile));
    figure.table.add("leaving", "%", std::move(curves.leaving));
    figure.table.add("drawn", "%", std::move(curves.drawn));
    figure.table.add("motion", std::move(curves.ended));
    const json marks = marked_gradients(*main);
    for (const json& mark : marks) {
        last = std::max(last, mark.at("at").get<double>());
    }
    figure.chart = mobility_chart(marks, last);
    for (const std::size_t layer : {2U, 3U}) {
        json& color = figure.chart["layer"][layer]["encoding"]["color"];
        color["scale"] = {{"range", color::sequence()}};
        if (drawn == 1) {
            color["legend"] = nullptr;
        }
    }
    return figure;
}

std::optional<Figure> mobile_sizes(const MobilityStory* story) {
    if (story == nullptr) {
        return std::nullopt;
    }
    const MobilityResult& mobility = story->one();
    const SizeClasses sizes(mobility);
    std::vector<std::string> size, at;
    std::vector<double> share;
    for (const double gradient : shown_gradients(mobility)) {
        std::vector<double> mobile(sizes.count, 0), all(sizes.count, 0);
        for (std::size_t k = 0; k < mobility.id.size(); ++k) {
            const std::size_t of = sizes.of(mobility.diameter[k]);
            all[of] += mobility.mass[k];
            mobile[of] += mobility.mobile_gradient[k] <= gradient ? mobility.mass[k] : 0;
        }
        for (std::size_t k = 0; k < sizes.count; ++k) {
            if (all[k] > 0) {
                size.push_back(range_text(sizes, k));
                at.push_back(fmt::format("i = {:.2f}", gradient));
                share.push_back(100 * mobile[k] / all[k]);
            }
        }
    }
    std::vector<std::string> order;
    for (std::size_t k = 0; k < sizes.count; ++k) {
        order.push_back(range_text(sizes, k));
    }
    Figure figure;
    figure.id = "own-mobile-sizes";
    figure.section = "Water";
    figure.title = "Which sizes of the fines move";
    figure.caption = fmt::format(
        "Mass of each size that moves, at some gradients of {}{}. Small grains weigh less, and find more room between "
        "the others.",
        story->name, story->of_sample.size() > 1 ? ", sample 1" : ""
    );
    figure.table.add("size", std::move(size));
    figure.table.add("at", std::move(at));
    figure.table.add("share", "%", std::move(share));
    figure.chart = json::parse(R"json({
        "width": 560, "height": 280,
        "mark": {"type": "bar"},
        "encoding": {
            "x": {"field": "size", "type": "nominal", "title": "diameter [mm]", "axis": {"labelAngle": 0}},
            "xOffset": {"field": "at"},
            "y": {"field": "share", "type": "quantitative", "title": "moves, by mass of the size [%]",
                  "scale": {"domain": [0, 100]}},
            "color": {"field": "at", "type": "nominal", "title": null},
            "tooltip": [{"field": "size", "title": "d [mm]"}, {"field": "at", "title": "gradient"},
                        {"field": "share", "title": "moves [%]", "format": ".3g"}]
        }
    })json");
    figure.chart["encoding"]["x"]["sort"] = order;
    figure.chart["encoding"]["color"]["scale"] = {{"range", color::sequence()}};
    return figure;
}

std::optional<PageTable> mobility_table(const std::vector<MobilityStory>& stories) {
    if (stories.empty()) {
        return std::nullopt;
    }
    const auto text = [](const study::Scatter& value) { return study::with_scatter(value, 1, 3); };
    const auto bounded = [](const study::Scatter& value, bool at_most, const std::string& written) {
        return (at_most && value.seeds > 0 ? "≤ " : "") + written;
    };
    const auto reached = [&](const study::Scatter& value, bool at_most) {
        return bounded(value, at_most, text(value));
    };
    PageTable table;
    table.section = "Water";
    table.title = "Gradients that move fines";
    table.note =
        "Gradients that move 1, 10 and 50 % of the fines' mass half a diameter along the flow; a dash: not below "
        "heave, nor up to the end of the ramp; ≤: motion had not ended when the gradient rose, and a longer hold would "
        "give less. For comparison: heave, which is Terzaghi's i_c over the sine of the flow's rise; Skempton and "
        "Brogan's "
        "α i_c with the sample's own α; and heave × FC/s, at which the seepage force on the fines outweighs all of "
        "them.";
    table.header = {"stage", "samples", "i, 1 %",       "i, 10 %", "i, 50 %", "heave",
                    "α",     "α i_c",   "heave × FC/s", "safety",  "sifts"};
    table.numeric.assign(table.header.size(), true);
    table.numeric.front() = table.numeric.back() = false;
    for (const MobilityStory& story : stories) {
        std::string safety = bounded(story.safety, story.at_most_1, factor_text(story.safety));
        if (!is_met(story.safety, story) && story.safety_at_least) {
            safety = "at least " + least_factor_text(*story.safety_at_least);
        }
        table.rows.push_back(
            {story.name, fmt::format("{}", story.of_sample.size()), reached(story.moves_1, story.at_most_1),
             reached(story.moves_10, story.at_most_10), reached(story.moves_50, story.at_most_50), text(story.heave),
             text(story.alpha_fines), text(story.skempton_brogan), text(story.fines_heave), safety,
             story.sifts ? "yes" : "no"}
        );
    }
    return table;
}

} // namespace suffuse::figures
