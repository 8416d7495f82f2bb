// Ours: how quickly fines leave, against the power of the flow that takes them.
#include "suffuse/base/words.hpp"
#include "suffuse/figures/figures_migration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::figures {
namespace {

using erosion::MigrationHold;
using erosion::MigrationResult;
using erosion::MigrationRow;
using nlohmann::json;

constexpr double micro = 1e6; ///< µW a W
constexpr double mg = 1e6;    ///< a kg

/// "sand: 3.1 ± 0.4 mg/J (90 %), scatter 0.2 mg/s"
std::string line_in_words(const std::string& name, const LineFit& fit) {
    const std::string points = fmt::format("{} gradient{} with losses", fit.points, fit.points == 1 ? "" : "s");
    if (!fit.is_carried()) {
        return fmt::format("{}: {} carr{} no line", name, points, fit.points == 1 ? "ies" : "y");
    }
    return fmt::format(
        "{}: the rate rises by {} ± {} mg for each joule (90 %), and scatters around its line by {} mg/s ({})", name,
        short_number(mg * fit.slope, 2), short_number(mg * fit.half_width, 1), short_number(mg * fit.scatter, 2), points
    );
}

/// Through the gradients at which something left: below, a threshold decides, and no line goes through it.
LineFit fit_where_some_left(const RatesByPower& rates) {
    std::vector<double> power, rate;
    for (std::size_t k = 0; k < rates.rate.size(); ++k) {
        if (rates.rate[k] > 0) {
            power.push_back(rates.power[k]);
            rate.push_back(rates.rate[k]);
        }
    }
    return fit_line(power, rate);
}

} // namespace

RatesByPower rates_by_power(const MigrationResult& result) {
    RatesByPower rates;
    double end = 0, energy_before = 0, mass_before = 0;
    auto row = result.rows.begin();
    for (const MigrationHold& hold : result.holds) {
        if (!(hold.held_for > 0)) {
            continue;
        }
        end += hold.held_for;
        double energy = energy_before;
        constexpr double rounding = 1e-9;
        for (; row != result.rows.end() && row->time <= end * (1 + rounding); ++row) {
            energy = row->energy;
        }
        const double mass = hold.eroded_mass_share * result.fines_mass;
        rates.gradient.push_back(hold.gradient);
        rates.power.push_back((energy - energy_before) / hold.held_for);
        rates.rate.push_back((mass - mass_before) / hold.held_for);
        energy_before = energy, mass_before = mass;
    }
    return rates;
}

std::optional<Figure> migration_by_power(const std::vector<MigrationCurve>& curves) {
    std::vector<std::string> stage, claim;
    std::vector<double> gradient, power, rate, line;
    bool any_line = false;
    for (const MigrationCurve& curve : curves) {
        const RatesByPower rates = rates_by_power(curve.result);
        const LineFit fit = fit_where_some_left(rates);
        any_line = any_line || fit.is_carried();
        claim.push_back(line_in_words(curve.name, fit));
        for (std::size_t k = 0; k < rates.power.size(); ++k) {
            stage.push_back(curve.name);
            gradient.push_back(rates.gradient[k]);
            power.push_back(micro * rates.power[k]);
            rate.push_back(mg * rates.rate[k]);
            line.push_back(
                fit.is_carried() && rates.rate[k] > 0 ? mg * (fit.intercept + fit.slope * rates.power[k]) : missing
            );
        }
    }
    if (stage.size() < 2 || std::ranges::all_of(rate, [](double each) { return each == 0; })) {
        return std::nullopt;
    }
    Figure figure;
    figure.id = "own-migration-power";
    figure.section = "Water";
    figure.title = "Erosion rate against the power of the flow";
    std::string words;
    for (const std::string& each : claim) {
        words += (words.empty() ? "" : "; ") + each;
    }
    figure.caption =
        as_sentence(words) +
        fmt::format(
            ". Each point is a gradient: mass that left while it was held, and energy ρ g Q i L that the "
            "flow spent, over the time of the hold. A line is drawn through the points with losses, if they are "
            "{} at least and the 90 % interval of its slope excludes 0.",
            LineFit::fewest
        );
    figure.table.add("stage", std::move(stage));
    figure.table.add("gradient", "-", std::move(gradient));
    figure.table.add("power", "µW", std::move(power));
    figure.table.add("rate", "mg/s", std::move(rate));
    figure.table.add("line", "mg/s", std::move(line));
    figure.chart = json::parse(R"json({
        "width": 480, "height": 300,
        "layer": [
            {"mark": {"type": "point", "filled": true, "size": 60},
             "encoding": {"y": {"field": "rate"}, "tooltip": [
                {"field": "stage", "title": "stage"}, {"field": "gradient", "title": "i", "format": ".3g"},
                {"field": "power", "title": "power [µW]", "format": ".3g"},
                {"field": "rate", "title": "rate [mg/s]", "format": ".3g"}]}}
        ]
    })json");
    if (any_line) {
        figure.chart["layer"].push_back(
            {{"transform", {{{"filter", "isValid(datum.line)"}}}},
             {"mark", {{"type", "line"}, {"strokeWidth", 1.5}}},
             {"encoding", {{"y", {{"field", "line"}}}}}}
        );
    }
    for (json& layer : figure.chart["layer"]) {
        layer["encoding"]["y"].update({{"type", "quantitative"}, {"title", "erosion rate [mg/s]"}});
    }
    figure.chart["encoding"] = {
        {"x", {{"field", "power"}, {"type", "quantitative"}, {"title", "power of the flow ρ g Q i L [µW]"}}},
        {"color",
         {{"field", "stage"}, {"type", "nominal"}, {"title", nullptr}, {"scale", {{"range", color::sequence()}}}}}};
    return figure;
}

} // namespace suffuse::figures
