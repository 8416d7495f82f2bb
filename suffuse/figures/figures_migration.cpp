// Ours: what becomes of fines that travel with the water.
#include "suffuse/figures/figures_migration.hpp"

#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::figures {
namespace {

using erosion::MigrationHold;
using erosion::MigrationResult;
using erosion::MigrationRow;
using nlohmann::json;

constexpr std::size_t most_shown = 400; ///< of a curve over time: more are not seen

/// Of the permeability with all fines at rest [%].
double kept_permeability(const MigrationResult& result, double permeability) {
    const bool is_known = result.resting_permeability > 0; // runs of earlier programs lack it
    return 100 * permeability / (is_known ? result.resting_permeability : result.rows.front().permeability);
}

/// Two panels, one above the other: eroded mass and permeability over the same axis.
json two_panels(const char* field, const char* title, const char* format) {
    json chart = json::parse(R"json({
        "vconcat": [
            {"width": 480, "height": 200, "mark": {"type": "line", "strokeWidth": 2},
             "encoding": {"y": {"field": "eroded", "type": "quantitative", "title": "eroded, of the fines' mass [%]",
                                "scale": {"domain": {"unionWith": [0, 1]}}}}},
            {"width": 480, "height": 200, "mark": {"type": "line", "strokeWidth": 2},
             "encoding": {"y": {"field": "permeability", "type": "quantitative",
                                "title": "permeability, of that at first [%]"}}}
        ],
        "spacing": 16
    })json");
    for (json& panel : chart["vconcat"]) {
        json& encoding = panel["encoding"];
        encoding["x"] = {{"field", field}, {"type", "quantitative"}, {"title", title}};
        encoding["color"] = {
            {"field", "stage"}, {"type", "nominal"}, {"title", nullptr}, {"scale", {{"range", color::sequence()}}}};
        encoding["tooltip"] = {
            {{"field", "stage"}, {"title", "stage"}},
            {{"field", field}, {"title", title}, {"format", format}},
            {{"field", "eroded"}, {"title", "eroded [%]"}, {"format", ".3g"}},
            {{"field", "permeability"}, {"title", "k [%]"}, {"format", ".3g"}}};
    }
    return chart;
}

/// "base: 12 % of the fines eroded, and the permeability is 84 % of that at first; ..."
std::string ends_in_words(const std::vector<MigrationCurve>& curves) {
    std::string words;
    for (const MigrationCurve& curve : curves) {
        const MigrationResult& result = curve.result;
        const MigrationRow& end = result.rows.back();
        words += fmt::format(
            "{}{}: {} % of the fines' mass eroded, and the permeability ends at {} % of that at first",
            words.empty() ? "" : "; ", curve.name,
            short_number(100 * share_of_own(result) * end.eroded_mass / result.fines_mass, 2),
            short_number(kept_permeability(result, end.permeability), 2)
        );
    }
    return words;
}

bool is_empty(const MigrationCurve& curve) {
    return curve.result.rows.empty() || curve.result.holds.empty();
}

} // namespace

std::optional<Figure> migration_by_gradient(const std::vector<MigrationCurve>& curves) {
    const auto rises = [](const MigrationCurve& curve) { return curve.result.holds.size() > 1; };
    if (curves.empty() || std::ranges::any_of(curves, is_empty) || std::ranges::none_of(curves, rises)) {
        return std::nullopt;
    }
    std::vector<std::string> stage, motion;
    std::vector<double> gradient, eroded, permeability;
    for (const MigrationCurve& curve : curves) {
        for (const MigrationHold& hold : curve.result.holds) {
            stage.push_back(curve.name);
            gradient.push_back(hold.gradient);
            eroded.push_back(100 * share_of_own(curve.result) * hold.eroded_mass_share);
            permeability.push_back(kept_permeability(curve.result, hold.permeability));
            motion.emplace_back(hold.ended ? "ended" : "still moving");
        }
    }
    Figure figure;
    figure.id = "own-migration";
    figure.section = "Water";
    figure.title = "Fines that leave as the gradient rises";
    figure.caption = as_sentence(ends_in_words(curves)) +
                     ". Each point is the end of a gradient. A triangle marks one that was cut while fines still "
                     "moved: what erodes is then a lower bound.";
    figure.table.add("stage", std::move(stage));
    figure.table.add("gradient", "-", std::move(gradient));
    figure.table.add("eroded", "%", std::move(eroded));
    figure.table.add("permeability", "%", std::move(permeability));
    figure.table.add("motion", std::move(motion));
    figure.chart = two_panels("gradient", "hydraulic gradient i [-]", ".3g");
    for (json& panel : figure.chart["vconcat"]) {
        const json shape = {
            {"field", "motion"},
            {"type", "nominal"},
            {"legend", nullptr},
            {"scale", {{"domain", {"ended", "still moving"}}, {"range", {"circle", "triangle-up"}}}}};
        panel["layer"] = {
            {{"mark", {{"type", "line"}, {"strokeWidth", 2}}}, {"encoding", {{"order", {{"field", "gradient"}}}}}},
            {{"mark", {{"type", "point"}, {"filled", true}, {"size", 40}}}, {"encoding", {{"shape", shape}}}}};
        panel.erase("mark");
    }
    return figure;
}

std::optional<Figure> migration_in_time(const std::vector<MigrationCurve>& curves) {
    if (curves.empty() || std::ranges::any_of(curves, is_empty)) {
        return std::nullopt;
    }
    std::vector<std::string> stage;
    std::vector<double> time, gradient, eroded, moving, permeability;
    for (const MigrationCurve& curve : curves) {
        const std::vector<MigrationRow>& rows = curve.result.rows;
        const double percent = 100 * share_of_own(curve.result) / curve.result.fines_mass;
        const std::size_t every = 1 + rows.size() / most_shown;
        for (std::size_t k = 0; k < rows.size(); ++k) {
            if (k % every != 0 && k + 1 != rows.size()) {
                continue;
            }
            stage.push_back(curve.name);
            time.push_back(rows[k].time);
            gradient.push_back(rows[k].gradient);
            eroded.push_back(percent * rows[k].eroded_mass);
            moving.push_back(percent * rows[k].moving_mass);
            permeability.push_back(kept_permeability(curve.result, rows[k].permeability));
        }
    }
    Figure figure;
    figure.id = "own-migration-time";
    figure.section = "Water";
    figure.title = "Fines that leave over time";
    figure.caption = as_sentence(ends_in_words(curves)) +
                     ". Time is that of the soil. Each point is a solution of the flow; grains that go with the water "
                     "resist it by their weight alone, so that the permeability falls again where they come to rest.";
    figure.table.add("stage", std::move(stage));
    figure.table.add("time", "s", std::move(time));
    figure.table.add("gradient", "-", std::move(gradient));
    figure.table.add("eroded", "%", std::move(eroded));
    figure.table.add("moving", "%", std::move(moving));
    figure.table.add("permeability", "%", std::move(permeability));
    figure.chart = two_panels("time", "time [s]", ".3g");
    for (json& panel : figure.chart["vconcat"]) {
        panel["encoding"]["tooltip"].push_back({{"field", "gradient"}, {"title", "i"}, {"format", ".3g"}});
        panel["encoding"]["tooltip"].push_back({{"field", "moving"}, {"title", "moving [%]"}, {"format", ".3g"}});
    }
    return figure;
}

} // namespace suffuse::figures
