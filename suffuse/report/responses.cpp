#include "suffuse/report/responses.hpp"

#include "suffuse/report/fines_study.hpp"
#include "suffuse/report/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>

namespace suffuse::report {

namespace {

using nlohmann::json;
// Of a curve in a drawing; the run's own files hold them all.
constexpr std::size_t most_rows = 240, most_path_rows = 100;

/// Six digits are more than a line shows.
double rounded(double value) {
    return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
}

/// Every n-th row, and the last.
std::vector<std::size_t> drawn_rows(std::size_t count, std::size_t most) {
    const std::size_t every = std::max<std::size_t>(1, (count + most - 1) / most);
    std::vector<std::size_t> rows;
    for (std::size_t k = 0; k < count; k += every) {
        rows.push_back(k);
    }
    if (!rows.empty() && rows.back() + 1 != count) {
        rows.push_back(count - 1);
    }
    return rows;
}

const StressStrainRow& peak_of(const ResponseCurve& test) {
    return *std::max_element(test.rows.begin(), test.rows.end(), [](const auto& a, const auto& b) {
        return a.deviator_stress < b.deviator_stress;
    });
}

Table response_table(const std::vector<ResponseCurve>& tests, std::size_t most) {
    std::vector<std::string> name;
    std::vector<double> row_number, axial, deviator, mean, volumetric, void_ratio, pore_pressure, u_deviation;
    std::vector<double> q_deviation, v_deviation, samples;
    for (const ResponseCurve& test : tests) {
        for (const std::size_t k : drawn_rows(test.rows.size(), most)) {
            const StressStrainRow& row = test.rows[k];
            const StressStrainRow spread = test.deviation.empty() ? StressStrainRow{} : test.deviation[k];
            name.push_back(test.name);
            row_number.push_back(static_cast<double>(k));
            axial.push_back(rounded(100 * row.axial_strain));
            deviator.push_back(rounded(row.deviator_stress / 1e3));
            q_deviation.push_back(rounded(spread.deviator_stress / 1e3));
            mean.push_back(rounded(row.mean_stress / 1e3));
            volumetric.push_back(rounded(100 * row.volumetric_strain));
            v_deviation.push_back(rounded(100 * spread.volumetric_strain));
            void_ratio.push_back(rounded(row.void_ratio));
            pore_pressure.push_back(rounded(row.excess_pore_pressure / 1e3));
            u_deviation.push_back(rounded(spread.excess_pore_pressure / 1e3));
            samples.push_back(test.samples);
        }
    }
    Table table;
    table.add("test", std::move(name));
    table.add("axial_strain", "%", std::move(axial));
    table.add("deviator_stress", "kPa", std::move(deviator));
    table.add("mean_stress", "kPa", std::move(mean));
    table.add("volumetric_strain", "%", std::move(volumetric));
    table.add("void_ratio", "-", std::move(void_ratio));
    table.add("deviator_stress_deviation", "kPa", std::move(q_deviation));
    table.add("volumetric_strain_deviation", "%", std::move(v_deviation));
    table.add("samples", "", std::move(samples));
    table.add("row", "", std::move(row_number));
    table.add("excess_pore_pressure", "kPa", std::move(pore_pressure));
    table.add("excess_pore_pressure_deviation", "kPa", std::move(u_deviation));
    return table;
}

/// Names that stand in one row of a chart of the usual width.
int legend_columns(const json& names) {
    std::size_t longest = 1;
    for (const json& name : names) {
        longest = std::max(longest, name.get_ref<const std::string&>().size());
    }
    return std::max(1, static_cast<int>(560 / (6.2 * static_cast<double>(longest) + 52)));
}

/// "FC 10 %" and "shear" of "FC 10 %, shear"; the stage is empty where the name has none.
std::pair<std::string, std::string> mixture_and_stage(const ResponseCurve& test) {
    const std::size_t comma = test.name.find(", ");
    return comma == std::string::npos ? std::pair{test.name, std::string{}}
                                      : std::pair{test.name.substr(0, comma), test.name.substr(comma + 2)};
}

/// Whether some fines content is tested in several stages.
bool has_stages(const std::vector<ResponseCurve>& tests) {
    std::set<double> contents;
    bool repeats = false;
    for (const ResponseCurve& test : tests) {
        if (!std::isfinite(test.fines_content) || mixture_and_stage(test).second.empty()) {
            return false;
        }
        repeats = repeats || !contents.insert(test.fines_content).second;
    }
    return repeats;
}

/// Color by fines content and dashes by stage: `field` "mixture" or "stage".
json told_by(const char* field, const std::vector<std::pair<std::string, json>>& names) {
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

void color_by_mixture(const std::vector<ResponseCurve>& tests, json& encoding) {
    static const json patterns =
        json::parse("[[1, 0], [6, 3], [2, 2], [8, 2, 2, 2], [12, 3], [5, 2, 1, 2, 1, 2], [1, 3], [12, 2, 4, 2]]");
    std::vector<std::pair<std::string, json>> mixtures, stages;
    std::vector<std::string> seen;
    for (const ResponseCurve& test : tests) {
        const auto [mixture, stage] = mixture_and_stage(test);
        mixtures.emplace_back(mixture, fines_color(test.fines_content));
        if (std::find(seen.begin(), seen.end(), stage) == seen.end()) {
            stages.emplace_back(stage, patterns[seen.size() % patterns.size()]);
            seen.push_back(stage);
        }
    }
    encoding["color"] = told_by("mixture", mixtures);
    encoding["strokeDash"] = told_by("stage", stages);
    encoding["strokeDash"]["legend"]["orient"] = "bottom"; // beside the other it would not fit
}

/// Color and dashes by test; tests over a fines content have its color.
void color_by_test(const std::vector<ResponseCurve>& tests, json& encoding) {
    json names = json::array(), colors = json::array();
    for (const ResponseCurve& test : tests) {
        names.push_back(test.name);
        const json& sequence = color::sequence();
        colors.push_back(
            std::isfinite(test.fines_content) ? json(fines_color(test.fines_content))
                                              : sequence[colors.size() % sequence.size()]
        );
    }
    encoding["color"] = {
        {"field", "test"},
        {"type", "nominal"},
        {"title", nullptr},
        {"scale", {{"domain", names}, {"range", colors}}},
        {"legend",
         {{"symbolType", "stroke"},
          {"symbolOpacity", 1},
          {"symbolSize", color::dash_symbol},
          {"columns", legend_columns(names)}}}};
    encoding["strokeDash"] = {
        {"field", "test"},
        {"type", "nominal"},
        {"title", nullptr},
        {"scale", {{"domain", names}, {"range", json::parse("[[1, 0], [6, 3], [2, 2], [8, 2, 2, 2]]")}}}};
}

/// Whether no test has a deviator stress below zero, but for a hundredth of the highest.
bool starts_at_zero(const std::vector<ResponseCurve>& tests) {
    double lowest = 0, highest = 0;
    for (const ResponseCurve& test : tests) {
        for (const StressStrainRow& row : test.rows) {
            lowest = std::min(lowest, row.deviator_stress);
            highest = std::max(highest, row.deviator_stress);
        }
    }
    return lowest > -0.01 * highest;
}

/// Whether all tests compress: their axis begins at zero, not at the first row.
bool only_compresses(const std::vector<ResponseCurve>& tests) {
    return std::all_of(tests.begin(), tests.end(), [](const ResponseCurve& test) {
        return std::all_of(test.rows.begin(), test.rows.end(), [](const auto& row) { return row.axial_strain >= 0; });
    });
}

bool keeps_volume(const std::vector<ResponseCurve>& tests) {
    return std::all_of(tests.begin(), tests.end(), [](const ResponseCurve& test) {
        return std::all_of(test.rows.begin(), test.rows.end(), [](const auto& row) {
            return std::abs(row.volumetric_strain) < 1e-4;
        });
    });
}

/// One panel over the axial strain: lines, and below them bands of one standard deviation where there are some.
json strain_panel(const std::vector<ResponseCurve>& tests, const std::string& value, const char* title, double height) {
    const bool has_bands =
        std::any_of(tests.begin(), tests.end(), [](const ResponseCurve& test) { return !test.deviation.empty(); });
    json line = {{"mark", {{"type", "line"}}}, {"encoding", json::object()}};
    json& encoding = line["encoding"];
    encoding["x"] = {
        {"field", "axial_strain"},
        {"type", "quantitative"},
        {"title", "axial strain ε₁ [%]"},
        {"axis", {{"tickCount", 8}}},
        {"scale", {{"nice", false}}}};
    if (only_compresses(tests)) {
        encoding["x"]["scale"]["domainMin"] = 0;
    }
    encoding["y"] = {{"field", value}, {"type", "quantitative"}, {"title", title}};
    if (value == "deviator_stress" && starts_at_zero(tests)) {
        encoding["y"]["scale"] = {
            {"domainMin", 0}}; // what is left of q after settling is no reason for a tick below zero
    }
    if (value == "volumetric_strain" &&
        keeps_volume(tests)) { // at constant volume, rounding is not drawn as if it were a response
        encoding["y"]["scale"] = {{"domain", {{"unionWith", {-0.01, 0.01}}}}};
    }
    color_by_test(tests, encoding);
    encoding["order"] = {{"field", "row"}};
    encoding["tooltip"] = json::parse(R"json([
        {"field": "test", "title": "test"}, {"field": "axial_strain", "title": "ε₁ [%]", "format": ".3g"},
        {"field": "deviator_stress", "title": "q [kPa]", "format": ".4g"},
        {"field": "mean_stress", "title": "p [kPa]", "format": ".4g"},
        {"field": "volumetric_strain", "title": "εᵥ [%]", "format": ".3g"},
        {"field": "void_ratio", "title": "void ratio e", "format": ".4g"}])json");
    if (!has_bands) {
        line.update({{"width", 560}, {"height", height}});
        return line;
    }
    json band = {
        {"transform",
         {{{"filter", "datum.samples > 1"}},
          {{"calculate", fmt::format("datum.{0} - datum.{0}_deviation", value)}, {"as", "low"}},
          {{"calculate", fmt::format("datum.{0} + datum.{0}_deviation", value)}, {"as", "high"}}}},
        {"mark", {{"type", "area"}, {"opacity", 0.2}}},
        {"encoding",
         {{"x", encoding["x"]},
          {"y", {{"field", "low"}, {"type", "quantitative"}, {"title", title}}},
          {"y2", {{"field", "high"}}},
          {"color", encoding["color"]}}}};
    return {{"width", 560}, {"height", height}, {"layer", {line, band}}};
}

void hide_axis(json& panel) {
    const auto hide = [](json& encoding) {
        encoding["x"]["axis"] = {{"title", nullptr}, {"labels", false}, {"ticks", false}, {"tickCount", 8}};
    };
    if (panel.contains("layer")) {
        for (json& layer : panel["layer"]) {
            hide(layer["encoding"]);
        }
    } else {
        hide(panel["encoding"]);
    }
}

std::vector<ResponseCurve> with_rows(std::vector<ResponseCurve> tests) {
    std::erase_if(tests, [](const ResponseCurve& test) { return test.rows.empty(); });
    return tests;
}

std::string bands(const std::vector<ResponseCurve>& tests) {
    int most = 1;
    for (const ResponseCurve& test : tests) {
        most = std::max(most, test.samples);
    }
    return most > 1 ? fmt::format(
                          " Lines: the mean over up to {} samples, as far as all of them reach; bands: one standard "
                          "deviation to "
                          "each side.",
                          most
                      )
                    : " One sample a line.";
}

Figure response_figure(const std::vector<ResponseCurve>& tests) {
    Figure figure;
    figure.section = "Tests";
    const bool holds_deviator = tests.front().borne_pore_pressure.has_value();
    json panels = json::array();
    if (holds_deviator) {
        panels.push_back(strain_panel(tests, "excess_pore_pressure", "excess pore pressure Δu [kPa]", 200));
    }
    panels.push_back(strain_panel(
        tests, "deviator_stress", holds_deviator ? "q = σ₁ − σ₃ [kPa]" : "deviator stress q = σ₁ − σ₃ [kPa]",
        holds_deviator ? 120 : 240
    ));
    for (json& panel : panels) {
        hide_axis(panel);
    }
    panels.push_back(strain_panel(tests, "volumetric_strain", "volumetric strain εᵥ [%]", 160));
    figure.chart = {
        {"vconcat", panels},
        {"spacing", 8},
        {"resolve", {{"scale", {{"x", "shared"}, {"color", "shared"}, {"strokeDash", "shared"}}}}}};
    figure.table = response_table(tests, most_rows);
    return figure;
}

} // namespace

std::optional<Figure> loose_compression(const std::vector<ResponseCurve>& all) {
    const std::vector<ResponseCurve> tests = with_rows(all);
    if (tests.empty()) {
        return std::nullopt;
    }
    Figure figure = response_figure(tests);
    figure.id = "fig02";
    figure.title = "Drained compression of the loose samples";
    std::string claim;
    for (const ResponseCurve& test : tests) {
        const StressStrainRow& peak = peak_of(test);
        claim += fmt::format(
            "{}{} kPa at {}", claim.empty() ? "Highest q: " : ", ", short_number(peak.deviator_stress / 1e3), test.name
        );
    }
    figure.caption = claim + ". Contraction positive." + bands(tests);
    return figure;
}

std::optional<Figure>
triaxial_response(const std::vector<ResponseCurve>& all, const std::string& id, const std::string& title) {
    const std::vector<ResponseCurve> tests = with_rows(all);
    if (tests.empty()) {
        return std::nullopt;
    }
    Figure figure = response_figure(tests);
    figure.id = id;
    figure.title = title;
    std::string claim;
    for (const ResponseCurve& test : tests) {
        claim += claim.empty() ? "" : "; ";
        if (test.borne_pore_pressure) {
            claim += fmt::format("{}: bears Δu = {} kPa", test.name, short_number(*test.borne_pore_pressure / 1e3));
            continue;
        }
        const StressStrainRow& peak = peak_of(test);
        claim += fmt::format(
            "{}: highest q {} kPa at ε₁ = {} %", test.name, short_number(peak.deviator_stress / 1e3),
            short_number(100 * peak.axial_strain)
        );
    }
    figure.caption = as_sentence(claim) + ". Contraction positive." + bands(tests);
    if (tests.front().borne_pore_pressure) {
        figure.caption += " A pore pressure is borne as long as q is.";
    }
    return figure;
}

std::optional<Figure> test_paths(const std::vector<ResponseCurve>& all) {
    const std::vector<ResponseCurve> tests = with_rows(all);
    if (tests.empty()) {
        return std::nullopt;
    }
    Figure figure;
    figure.id = "own-paths";
    figure.section = "Tests";
    figure.title = "Paths of stress and of state";
    figure.caption = "Upper panel: deviator stress against mean stress. Lower panel: void ratio against the logarithm "
                     "of the mean stress; tests that end in one critical state end on one line.";
    figure.table = response_table(tests, most_path_rows);
    figure.chart = json::parse(R"json({
        "vconcat": [
            {"width": 480, "height": 220, "mark": {"type": "line"}, "encoding": {
                "x": {"field": "mean_stress", "type": "quantitative", "title": "mean stress p = (σ₁ + σ₂ + σ₃)/3 [kPa]", "scale": {"zero": false}},
                "y": {"field": "deviator_stress", "type": "quantitative", "title": "deviator stress q [kPa]"}}},
            {"width": 480, "height": 200, "mark": {"type": "line"}, "encoding": {
                "x": {"field": "mean_stress", "type": "quantitative", "title": "mean stress p [kPa]",
                      "scale": {"type": "log", "nice": false}},
                "y": {"field": "void_ratio", "type": "quantitative", "title": "void ratio e [-]", "scale": {"zero": false}}}}
        ],
        "spacing": 16,
        "resolve": {"scale": {"color": "shared", "strokeDash": "shared"}}
    })json");
    if (starts_at_zero(tests)) {
        figure.chart["vconcat"][0]["encoding"]["y"]["scale"] = {{"domainMin", 0}};
    }
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
            {"field": "test", "title": "test"}, {"field": "mean_stress", "title": "p [kPa]", "format": ".4g"},
            {"field": "deviator_stress", "title": "q [kPa]", "format": ".4g"},
            {"field": "void_ratio", "title": "void ratio e", "format": ".4g"},
            {"field": "axial_strain", "title": "ε₁ [%]", "format": ".3g"}])json");
    }
    // A liquefied sample's mean stress is noise over many decades.
    double highest = 0, lowest = std::numeric_limits<double>::infinity();
    for (const double p : figure.table.numbers("mean_stress")) {
        highest = std::max(highest, p), lowest = std::min(lowest, p);
    }
    const double least = std::pow(10.0, std::floor(std::log10(std::max(highest, 1e-12))) - 2);
    figure.chart["vconcat"][1]["transform"] = {{{"filter", fmt::format("datum.mean_stress >= {}", least)}}};
    if (lowest < least) {
        figure.caption += fmt::format(" Below {} kPa, where a sample liquefied, it is not drawn.", short_number(least));
    }
    return figure;
}

} // namespace suffuse::report
