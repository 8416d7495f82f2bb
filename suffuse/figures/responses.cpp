#include "suffuse/figures/responses.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/facts/shown.hpp"
#include "suffuse/figures/response_look.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::figures {

namespace {

using nlohmann::json;
// Of a curve in a drawing; the run's own files hold them all.
constexpr std::size_t most_rows = 240;

const study::StressStrainRow& peak_of(const study::ResponseCurve& test) {
    return *std::max_element(test.rows.begin(), test.rows.end(), [](const auto& a, const auto& b) {
        return std::abs(a.deviator_stress) < std::abs(b.deviator_stress); // extension: below zero
    });
}

/// Whether all tests compress: their axis begins at zero, not at the first row.
bool only_compresses(const std::vector<study::ResponseCurve>& tests) {
    return std::all_of(tests.begin(), tests.end(), [](const study::ResponseCurve& test) {
        return std::all_of(test.rows.begin(), test.rows.end(), [](const auto& row) { return row.axial_strain >= 0; });
    });
}

bool keeps_volume(const std::vector<study::ResponseCurve>& tests) {
    return std::all_of(tests.begin(), tests.end(), [](const study::ResponseCurve& test) {
        return std::all_of(test.rows.begin(), test.rows.end(), [](const auto& row) {
            return std::abs(row.volumetric_strain) < 1e-4;
        });
    });
}

/// One panel over the axial strain: lines, and below them bands of one standard deviation where there are some.
json strain_panel(
    const std::vector<study::ResponseCurve>& tests, const std::string& value, const std::string& title, double height
) {
    const bool has_bands = std::any_of(tests.begin(), tests.end(), [](const study::ResponseCurve& test) {
        return !test.deviation.empty();
    });
    json line = {{"mark", {{"type", "line"}}}, {"encoding", json::object()}};
    json& encoding = line["encoding"];
    encoding["x"] = {
        {"field", "axial_strain"},
        {"type", "quantitative"},
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
        {"field": "test", "title": "test"}, {"field": "axial_strain"}, {"field": "deviator_stress"},
        {"field": "mean_stress"}, {"field": "volumetric_strain"}, {"field": "void_ratio"}])json");
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

std::string bands(const std::vector<study::ResponseCurve>& tests) {
    int most = 1;
    for (const study::ResponseCurve& test : tests) {
        most = std::max(most, test.samples);
    }
    return most > 1 ? fmt::format(
                          " Lines: the mean over up to {} samples, as far as all of them reach; bands: one standard "
                          "deviation to each side.",
                          most
                      )
                    : " One sample a line.";
}

Figure response_figure(const std::vector<study::ResponseCurve>& tests) {
    Figure figure;
    figure.section = "Tests";
    const bool holds_deviator = tests.front().borne_pore_pressure.has_value();
    json panels = json::array();
    if (holds_deviator) {
        panels.push_back(strain_panel(tests, "excess_pore_pressure", facts::title("excess_pore_pressure"), 200));
    }
    panels.push_back(strain_panel(
        tests, "deviator_stress", holds_deviator ? "q = σ₁ − σ₃ [kPa]" : "deviator stress q = σ₁ − σ₃ [kPa]",
        holds_deviator ? 120 : 240
    ));
    for (json& panel : panels) {
        hide_axis(panel);
    }
    panels.push_back(strain_panel(tests, "volumetric_strain", facts::title("volumetric_strain"), 160));
    figure.chart = {
        {"vconcat", panels},
        {"spacing", 8},
        {"resolve", {{"scale", {{"x", "shared"}, {"color", "shared"}, {"strokeDash", "shared"}}}}}};
    figure.table = response_table(tests, most_rows);
    return figure;
}

/// "Peak q: 36 kPa at FC = 0 %, 207 kPa at FC = 40 %": of one or two tests, or the lowest and highest of more.
std::string peaks_claim(const std::vector<study::ResponseCurve>& tests) {
    std::vector<std::pair<double, std::string>> peaks;
    for (const study::ResponseCurve& test : tests) {
        peaks.emplace_back(std::round(peak_of(test).deviator_stress / 1e3), test.name);
    }
    if (peaks.size() > 2) {
        std::ranges::sort(peaks);
    }
    const auto reported = [](const auto& peak) {
        return fmt::format("{} kPa ({})", short_number(peak.first, 4), peak.second);
    };
    if (peaks.size() < 2) {
        return "Highest q: " + reported(peaks.front());
    }
    return "Highest q: " + reported(peaks.front()) + (peaks.size() > 2 ? " to " : ", ") + reported(peaks.back());
}

} // namespace

std::optional<Figure> loose_compression(const std::vector<study::ResponseCurve>& all) {
    const std::vector<study::ResponseCurve> tests = with_rows(all);
    if (tests.empty()) {
        return std::nullopt;
    }
    Figure figure = response_figure(tests);
    figure.id = "fig02";
    figure.title = "Drained compression of the loose samples";
    figure.claim = peaks_claim(tests);
    std::string claim;
    for (const study::ResponseCurve& test : tests) {
        const study::StressStrainRow& peak = peak_of(test);
        claim += fmt::format(
            "{}{} kPa at {}", claim.empty() ? "Highest q: " : ", ", short_number(peak.deviator_stress / 1e3), test.name
        );
    }
    figure.caption = claim + ". Contraction positive." + bands(tests);
    return figure;
}

std::optional<Figure>
triaxial_response(const std::vector<study::ResponseCurve>& all, const std::string& id, const std::string& title) {
    const std::vector<study::ResponseCurve> tests = with_rows(all);
    if (tests.empty()) {
        return std::nullopt;
    }
    Figure figure = response_figure(tests);
    figure.id = id;
    figure.title = title;
    figure.claim = peaks_claim(tests);
    std::string claim;
    for (const study::ResponseCurve& test : tests) {
        claim += claim.empty() ? "" : "; ";
        if (test.borne_pore_pressure) {
            claim += fmt::format("{}: bears Δu = {} kPa", test.name, short_number(*test.borne_pore_pressure / 1e3));
            continue;
        }
        const study::StressStrainRow& peak = peak_of(test);
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

} // namespace suffuse::figures
