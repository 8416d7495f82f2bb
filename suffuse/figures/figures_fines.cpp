// Figures 3 and 4: void ratios and the active share of the fines over the fines content.
#include "suffuse/figures/figures_fines.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/figures/fines_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::figures {

namespace {

using nlohmann::json;

/// "FC = 40 % (0.513)": where a curve is lowest or highest; empty without points.
template <class Before>
std::string extreme(const study::FinesStudy& study, const FinesLine& line, Before before) {
    double found = std::numeric_limits<double>::quiet_NaN(), at = 0;
    for (std::size_t k = 0; k < line.curve->points.size(); ++k) {
        const study::Scatter value = study::number_of(line.curve->points[k], study.fines_content[k], line.number);
        if (value.seeds > 0 && (std::isnan(found) || before(value.mean, found))) {
            found = value.mean;
            at = study.fines_content[k];
        }
    }
    return std::isfinite(found) ? fmt::format("FC = {} ({})", study::percent_name(at), short_number(found))
                                : std::string{};
}

std::string lowest(const study::FinesStudy& study, const FinesLine& line) {
    return extreme(study, line, std::less<>{});
}

/// e_g grows without bound toward fines alone: the panel ends where what is said of it ends.
double top_of_loose_panel(const study::FinesStudy& study) {
    double equivalent = 0, pure = 0;
    for (std::size_t k = 0; k < study.loose.points.size(); ++k) {
        const study::Scatter e = study::number_of(study.loose.points[k], study.fines_content[k], "void_ratio");
        const study::Scatter e_eq =
            study::number_of(study.loose.points[k], study.fines_content[k], "equivalent_void_ratio");
        pure = std::max(pure, e.seeds > 0 ? e.mean : 0);
        equivalent = std::max(equivalent, e_eq.seeds > 0 && study.fines_content[k] < 1 ? e_eq.mean : 0);
    }
    return std::ceil(10 * std::max(1.1 * equivalent, 2 * pure)) / 10;
}

} // namespace

std::optional<Figure> void_ratios(const study::FinesStudy& study) {
    const std::string state = study::name_of_loose(study.loose, study.dense);
    const FinesLine e{study.dense.points.empty() ? "e" : "e (loose)", color::staying, &study.loose, "void_ratio"};
    const FinesLine e_min{"e_min (densest)", color::detachable, &study.dense, "void_ratio"};
    const FinesLine e_g{"e_g (all fines as voids)", color::fines, &study.loose, "intergranular_void_ratio"};
    const FinesLine e_eq{"e_eq (inactive fines as voids)", color::sequence()[2], &study.loose, "equivalent_void_ratio"};
    if (study.loose.points.empty()) {
        return std::nullopt;
    }
    std::vector<FinesLine> first = {e};
    if (!study.dense.points.empty()) {
        first.push_back(e_min);
    }
    const std::vector<FinesLine> second = {e, e_g, e_eq};
    FinesTable numbers("void_ratio", "-", 1);
    for (const FinesLine& line : first) {
        numbers.add(study, line, "a");
    }
    for (const FinesLine& line : second) {
        numbers.add(study, line, "b");
    }
    Figure figure;
    figure.id = "fig03";
    figure.section = "Fines and structure";
    figure.title = "Void ratios over the fines content";
    figure.claim = fmt::format("The {} has its lowest void ratio at {}", state, lowest(study, e));
    if (!study.dense.points.empty()) {
        figure.caption = fmt::format("The densest state has its lowest e_min at {}.", lowest(study, e_min));
    }
    const double top = top_of_loose_panel(study);
    for (std::size_t k = 0; k < study.loose.points.size(); ++k) {
        const study::Scatter value = study::number_of(study.loose.points[k], study.fines_content[k], e_g.number);
        if (value.seeds > 0 && value.mean > top) {
            figure.caption += fmt::format(
                " Panel (b) ends at {}: e_g is {} at FC = {} and grows without bound.", short_number(top),
                short_number(value.mean), study::percent_name(study.fines_content[k])
            );
            break;
        }
    }
    figure.caption += about_bars(numbers.most_samples());
    json panels = json::array();
    panels.push_back(fines_panel(study, first, "void_ratio", "(a) void ratio e, e_min [-]", study.density, "a"));
    panels.push_back(fines_panel(study, second, "void_ratio", "(b) e, e_g, e_eq [-]", {}, "b"));
    for (json& layer : panels[0]["layer"]) {
        if (layer["encoding"].contains("y") && !layer["encoding"]["y"].contains("scale")) {
            layer["encoding"]["y"]["scale"] = {{"zero", false}};
        }
    }
    for (json& layer : panels[1]["layer"]) {
        layer["encoding"]["y"]["scale"] = {{"domain", {0, top}}, {"nice", false}};
        layer["mark"]["clip"] = true;
    }
    figure.chart = {
        {"vconcat", panels},
        {"spacing", 22},
        {"resolve", {{"scale", {{"color", "independent"}, {"strokeDash", "independent"}}}}}};
    figure.table = std::move(numbers).table();
    return figure;
}

std::optional<Figure> active_fines(const study::FinesStudy& study) {
    const FinesLine b{"b", color::fines, &study.loose, "active_fines_fraction"};
    FinesTable numbers("active_fines", "-", 1);
    numbers.add(study, b);
    if (numbers.most_samples() == 0) {
        return std::nullopt;
    }
    Figure figure;
    figure.id = "fig04";
    figure.section = "Fines and structure";
    figure.title = "Active share of the fines";
    figure.claim = fmt::format("The active share of the fines is highest at {}", extreme(study, b, std::greater<>{}));
    figure.caption = fmt::format(
        "b: volume of the fines with at least two contacts over the volume of all fines, {}.",
        study::name_of_loose(study.loose, study.dense)
    );
    figure.caption += about_bars(numbers.most_samples());
    figure.chart = fines_panel(study, {b}, "active_fines", "active share of the fines b [-]", study.activity);
    for (json& layer : figure.chart["layer"]) {
        if (layer["encoding"].contains("y") && !layer["encoding"]["y"].contains("scale")) {
            layer["encoding"]["y"]["scale"] = {{"domain", {0, 1}}};
        }
        if (layer["encoding"].contains("color")) { // one line needs no legend
            layer["encoding"]["color"]["legend"] = nullptr;
        }
        if (layer["encoding"].contains("strokeDash")) {
            layer["encoding"]["strokeDash"]["legend"] = nullptr;
        }
    }
    figure.table = std::move(numbers).table();
    return figure;
}

} // namespace suffuse::figures
