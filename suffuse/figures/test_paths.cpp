#include "suffuse/base/words.hpp"
#include "suffuse/figures/response_look.hpp"
#include "suffuse/figures/responses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace suffuse::figures {

namespace {

using nlohmann::json;

constexpr std::size_t most_rows_of_a_path = 100; // of a curve in a drawing; the run's own files hold them all

/// "FC 10 %" and "shear" of "FC 10 %, shear"; the stage is empty where the name has none.
std::pair<std::string, std::string> mixture_and_stage(const study::ResponseCurve& test) {
    const std::size_t comma = test.name.find(", ");
    return comma == std::string::npos ? std::pair{test.name, std::string{}}
                                      : std::pair{test.name.substr(0, comma), test.name.substr(comma + 2)};
}

/// Whether some fines content is tested in several stages.
bool has_stages(const std::vector<study::ResponseCurve>& tests) {
    std::set<double> contents;
    bool repeats = false;
    for (const study::ResponseCurve& test : tests) {
        if (!std::isfinite(test.fines_content) || mixture_and_stage(test).second.empty()) {
            return false;
        }
        repeats = repeats || !contents.insert(test.fines_content).second;
    }
    return repeats;
}

/// Color by fines content and dashes by stage: `field` "mixture" or "stage".
json encoded_by(const char* field, const std::vector<std::pair<std::string, json>>& names) {
    json domain = json::array(), range = json::array();
    for (const auto& [name, look] : names) {
        if (std::find(domain.begin(), domain.end(), name) == domain.end()) {
            domain.push_back(name);
            range.push_back(look);
        }
    }
    const int columns = legend_columns(domain);
    return {
        {"field", field},
        {"type", "nominal"},
        {"title", nullptr},
        {"scale", {{"domain", domain}, {"range", range}}},
        {"legend",
         {{"symbolType", "stroke"}, {"symbolOpacity", 1}, {"symbolSize", color::dash_symbol}, {"columns", columns}}}};
}

void color_by_mixture(const std::vector<study::ResponseCurve>& tests, json& encoding) {
    static const json patterns =
        json::parse("[[1, 0], [6, 3], [2, 2], [8, 2, 2, 2], [12, 3], [5, 2, 1, 2, 1, 2], [1, 3], [12, 2, 4, 2]]");
    std::vector<std::pair<std::string, json>> mixtures, stages;
    std::vector<std::string> seen;
    const std::vector<std::string> colors = content_colors(tests);
    for (const study::ResponseCurve& test : tests) {
        const auto [mixture, stage] = mixture_and_stage(test);
        mixtures.emplace_back(mixture, colors[mixtures.size()]);
        if (std::find(seen.begin(), seen.end(), stage) == seen.end()) {
            stages.emplace_back(stage, patterns[seen.size() % patterns.size()]);
            seen.push_back(stage);
        }
    }
    encoding["color"] = encoded_by("mixture", mixtures);
    encoding["strokeDash"] = encoded_by("stage", stages);
    encoding["strokeDash"]["legend"]["orient"] = "bottom"; // next to the other it would not fit
}

/// The lateral stress, p - q/3, where all tests hold the same one, so that their paths of stress lie on one line [Pa].
std::optional<double> common_lateral_stress(const std::vector<study::ResponseCurve>& tests) {
    constexpr double held = 0.05; // what a servo lets go of for a moment
    const study::StressStrainRow& start = tests.front().rows.front();
    const double lateral = start.mean_stress - start.deviator_stress / 3;
    const bool is_common = std::ranges::all_of(tests, [&](const study::ResponseCurve& test) {
        return std::ranges::all_of(test.rows, [&](const study::StressStrainRow& row) {
            return std::abs(row.mean_stress - row.deviator_stress / 3 - lateral) <= held * lateral;
        });
    });
    return is_common ? std::optional(lateral) : std::nullopt;
}

json stress_panel(const std::vector<study::ResponseCurve>& tests) {
    json panel = json::parse(R"json({
        "width": 480, "height": 220, "mark": {"type": "line"}, "encoding": {
            "x": {"field": "mean_stress", "type": "quantitative", "scale": {"zero": false}},
            "y": {"field": "deviator_stress", "type": "quantitative"}}})json");
    if (starts_at_zero(tests)) {
        panel["encoding"]["y"]["scale"] = {{"domainMin", 0}};
    }
    return panel;
}

json state_panel() {
    return json::parse(R"json({
        "width": 480, "height": 200, "mark": {"type": "line"}, "encoding": {
            "x": {"field": "mean_stress", "type": "quantitative",
                  "scale": {"type": "log", "nice": false}},
            "y": {"field": "void_ratio", "type": "quantitative", "scale": {"zero": false}}}})json");
}

/// A liquefied sample's mean stress is noise over many decades, which an axis of its logarithm would show and little
/// else.
void leave_out_liquefied(Figure& figure) {
    double highest = 0, lowest = std::numeric_limits<double>::infinity();
    for (const double p : figure.table.numbers("mean_stress")) {
        highest = std::max(highest, p), lowest = std::min(lowest, p);
    }
    const double least = std::pow(10.0, std::floor(std::log10(std::max(highest, 1e-12))) - 2);
    figure.chart["vconcat"].back()["transform"] = {{{"filter", fmt::format("datum.mean_stress >= {}", least)}}};
    if (lowest < least) {
        figure.caption += fmt::format(" Below {} kPa, where a sample liquefied, it is not drawn.", short_number(least));
    }
}

} // namespace

std::optional<Figure> test_paths(const std::vector<study::ResponseCurve>& all) {
    const std::vector<study::ResponseCurve> tests = with_rows(all);
    if (tests.empty()) {
        return std::nullopt;
    }
    Figure figure;
    figure.id = "own-paths";
    figure.section = "Tests";
    figure.table = response_table(tests, most_rows_of_a_path);
    json panels = json::array();
    const std::string state =
        "void ratio against the logarithm of the mean stress; tests that end in one critical state end on one line.";
    if (const std::optional<double> lateral = common_lateral_stress(tests)) {
        figure.title = "Paths of state";
        figure.caption = fmt::format(
            "{} In stresses all these tests move along one line, q = 3 (p − {} kPa), as their lateral stress is held: "
            "it is not drawn.",
            as_sentence(state), short_number(*lateral / 1e3)
        );
    } else {
        figure.title = "Paths of stress and of state";
        figure.caption = "Upper panel: deviator stress against mean stress. Lower panel: " + state;
        panels.push_back(stress_panel(tests));
    }
    panels.push_back(state_panel());
    figure.chart = {
        {"vconcat", panels},
        {"spacing", 16},
        {"resolve", {{"scale", {{"color", "shared"}, {"strokeDash", "shared"}}}}}};
    const bool by_stage = has_stages(tests);
    if (by_stage) {
        figure.chart["transform"] = json::parse(R"json([
            {"calculate": "split(datum.test, ', ')[0]", "as": "mixture"},
            {"calculate": "split(datum.test, ', ')[1]", "as": "stage"}])json");
    }
    for (json& panel : figure.chart["vconcat"]) {
        by_stage ? color_by_mixture(tests, panel["encoding"]) : color_by_test(tests, panel["encoding"]);
        panel["encoding"]["order"] = {{"field", "row"}};
        panel["encoding"]["tooltip"] = json::parse(R"json([
            {"field": "test", "title": "test"}, {"field": "mean_stress"},
            {"field": "deviator_stress"},
            {"field": "void_ratio", "title": "void ratio e", "format": ".4g"},
            {"field": "axial_strain"}])json");
    }
    leave_out_liquefied(figure);
    return figure;
}

} // namespace suffuse::figures
